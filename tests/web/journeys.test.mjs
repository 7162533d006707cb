// Two ways of a newcomer through the inspector, walked and timed; docs/journeys.md has the table that this prints.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {cpSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {program, root, serve, temporaryFolder, Visitor} from './support.mjs';

const minute_s = 60;
const most_clicks = 3;
const folder = temporaryFolder();
const rows = [];
let server, visitor;

/** A recording of four minutes: one of a minute, again and again. */
function fourMinutes() {
  const lines = readFileSync(join(root, 'traces/building_blocks.trace.jsonl'), 'utf8').trim().split('\n');
  const [header, ...events] = lines
    .map((line) => JSON.parse(line))
    .filter(({kind}) => kind !== 'expect' && kind !== 'end');
  const later = (event, by) => ({
    ...event,
    t: event.t + by,
    ...(event.until !== undefined && {until: event.until + by}),
  });
  const all = [0, 1, 2, 3].flatMap((k) => events.map((event) => later(event, k * minute_s)));
  const trace = join(folder, 'four_minutes.trace.jsonl');
  writeFileSync(trace, [header, ...all].map((one) => `${JSON.stringify(one)}\n`).join(''));
  execFileSync(program, ['replay', trace, '--no-physics', '-o', join(folder, 'four_minutes.run.jsonl')]);
}

before(async () => {
  fourMinutes();
  for (const name of ['disambiguation', 'disambiguation_exhausted'])
    cpSync(join(root, `traces/paper/${name}.run.jsonl`), join(folder, `${name}.run.jsonl`));
  cpSync(join(root, 'traces/documents'), join(folder, 'documents'), {recursive: true});
  server = await serve(folder);
  visitor = await Visitor.start(server.address);
});
after(async () => {
  await visitor?.close();
  server?.stop();
});

/** Walks from the start page by clicks alone: the n-th of `wanted` is pressed after the one before has had its effect. */
async function walk(name, wanted, found) {
  const page = await visitor.visit('/');
  await page.waitForFunction(() => !/being read/.test(document.body.innerText));
  const begun = performance.now();
  for (const [, locate] of wanted) await locate(page).click();
  const place = found(page);
  await place.waitFor();
  const seconds = (performance.now() - begun) / 1000;
  assert.ok(wanted.length <= most_clicks, `${wanted.length} clicks`);
  await assertWhole(place);
  rows.push(`| ${name} | ${wanted.map(([words]) => words).join(', ')} | ${wanted.length} | ${seconds.toFixed(1)} |`);
  return place.innerText();
}

/** The element is on the screen from its first to its last letter, and no panel cuts it off. */
async function assertWhole(place) {
  const cut = await place.evaluate((element) => {
    const box = element.getBoundingClientRect();
    const frames = [];
    for (let one = element.parentElement; one; one = one.parentElement)
      if (getComputedStyle(one).overflow !== 'visible') frames.push(one.getBoundingClientRect());
    const whole = {top: 0, bottom: innerHeight, left: 0, right: innerWidth};
    const inside = (frame) =>
      box.top >= frame.top - 1 &&
      box.bottom <= frame.bottom + 1 &&
      box.left >= frame.left - 1 &&
      box.right <= frame.right + 1;
    return !box.height || ![whole, ...frames].every(inside) || element.scrollHeight > element.clientHeight + 1;
  });
  assert.ok(!cut, 'it is whole on the screen');
}

test('minute 3 of a recording is understood from the summary alone', async () => {
  const told = await walk(
    'what happened in minute 3 of a recording',
    [
      ['the run', (page) => page.locator('a.name', {hasText: 'four_minutes'})],
      ['*Summary*', (page) => page.getByTestId('tab-account')],
      ['⤢', (page) => page.getByRole('button', {name: 'Enlarge Summary'})],
    ],
    (page) => page.locator('.account li', {hasText: '2:00 – 3:00'}),
  );
  assert.match(told, /human: [\s\S]*point[\s\S]*avatar: “[\s\S]*the avatar puts the \w+ block/);
  assert.doesNotMatch(told, /block\d|posack|negack|δ|</, 'in words');
});

test('the cause of a divergence is whole on the screen after three clicks', async () => {
  const box = (name) => (page) => page.getByLabel(`Choose ${name} to compare`, {exact: true});
  const told = await walk(
    'why two runs part',
    [
      ['one run', box('disambiguation')],
      ['the other', box('disambiguation_exhausted')],
      ['*Compare*', (page) => page.getByTestId('compare-chosen')],
    ],
    (page) => page.getByTestId('cause'),
  );
  assert.match(told, /^They part at .*“No\.” .* is only in B/);
});

test('the table stands in docs/journeys.md, but for the seconds', () => {
  const table = ['| to know | clicks, from the start page | number | seconds |', '| --- | --- | --- | --- |', ...rows];
  console.log(table.join('\n'));
  const timeless = (line) => line.replace(/ [\d.]+ \|$/, '');
  const page = readFileSync(join(root, 'docs/journeys.md'), 'utf8').split('\n');
  const told = page.filter((line) => line.startsWith('|'));
  assert.deepEqual(told.map(timeless), table.map(timeless));
});
