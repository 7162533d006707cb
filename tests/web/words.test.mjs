// People's names for things, wherever the page tells of them; the log's own are shown on hover, in terms, and field by
// field alone.
import assert from 'node:assert/strict';
import {writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import {at, folder, serveFolder, server, visitor} from './served.mjs';
import {logOf, numberOf} from './support.mjs';

const runs = ['paper/disambiguation', 'paper/correction', 'talk/n_best', 'talk/staircase', 'building_blocks'];
const raw_places = /[<[]-?\d\S*, ?-?\d/; // coordinates
const nameOf = (run) => run.split('/').at(-1);
serveFolder(() => {
  for (const run of runs) writeFileSync(join(folder, `${nameOf(run)}.run.jsonl`), logOf(run));
});
const looked_at = 25; // stops of each run

// The text of a panel without terms, also those that have no words, and conditions, and without the record's own fields.
const prose = (panel) =>
  at(`panel-${panel}`).evaluate((element) => {
    const copy = element.cloneNode(true);
    for (const one of copy.querySelectorAll(
      '.term, .fields, [data-testid=fields], [data-testid=derivation], .type, .row:is(.kind-application, .kind-reading, .kind-symbol) .label',
    ))
      one.remove();
    return copy.textContent;
  });

for (const run of runs)
  test(`${run} names its things as people do`, async () => {
    const id = nameOf(run);
    const {titles} = await (await fetch(`${server.address}/api/runs/${id}`)).json();
    const ids = Object.keys(titles).filter((name) => /[\d_]/.test(name));
    assert.ok(ids.length > 0 || run !== 'paper/disambiguation');
    // Things that look the same are told apart by their ids.
    const without = (text) => Object.values(titles).reduce((rest, told) => rest.replaceAll(told, ''), text);
    const raw = async (panel) => {
      const text = without(await prose(panel));
      const places = ids.map((name) => new RegExp(`.{0,60}(?<!\\w)${name}(?!\\w).{0,20}`).exec(text)?.[0]);
      if (panel === 'why') places.push(raw_places.exec(text)?.[0]);
      return places.filter(Boolean).map((place) => `${panel}: ${place}`);
    };
    await visitor.visit(`/r/${id}?n=0`);
    const stops = await visitor.page.evaluate(() => [...window.continua.page.data.stops]);
    const each = Math.max(1, Math.floor(stops.length / looked_at));
    const problems = [];
    for (const n of stops.filter((_, i) => i % each === 0)) {
      await visitor.page.evaluate((to) => window.continua.cursor.jump(to), n);
      await visitor.page.evaluate(() => window.continua.page.settled());
      // An application is told as the terms that it is of.
      const of_terms = await visitor.page.evaluate((at) => window.continua.page.data.kind(at) === 'application', n);
      for (const panel of of_terms ? ['stack', 'dialogue'] : ['why', 'stack', 'dialogue'])
        for (const one of await raw(panel)) problems.push(`#${n} ${one}`);
    }
    await visitor.page.evaluate(() => window.continua.page.showTab('account'));
    await visitor.page.evaluate(() => window.continua.page.settled());
    problems.push(...(await raw('account')));
    await visitor.page.evaluate(() => window.continua.page.showTab('records'));
    for (const n of stops.filter((_, i) => i % (4 * each) === 0)) {
      await visitor.page.evaluate((to) => window.continua.cursor.jump(to), n);
      await visitor.page.evaluate(() => window.continua.page.settled());
      for (const one of await raw('records')) problems.push(`#${n} ${one}`);
    }
    assert.deepEqual(problems, []);
    assert.deepEqual(visitor.complaints, []);
  });

test('the log’s own names are shown on hover, and records are found by either', async () => {
  const asked = numberOf('talk/n_best', ({kind, text}) => kind === 'utterance' && /Which cup/.test(text));
  await visitor.visit(`/r/n_best?n=${asked}`);
  assert.match(await at('headline').innerText(), /“cup” may mean the white cup or the blue cup/);
  assert.match(await at('headline').getAttribute('title'), /“cup” may mean cup or cup_blue/);
  const rows = () => visitor.page.locator('[data-testid=panel-records] .row');
  for (const words of ['cup_blue', 'blue cup']) {
    await visitor.visit(`/r/n_best?kind=*&tab=records&filter=${encodeURIComponent(words)}`);
    await visitor.page.waitForFunction(() => document.querySelector('[data-testid=panel-records] .row .label'));
    await visitor.page.waitForFunction(() => /blue/.test(document.querySelector('.row .label').textContent));
    assert.ok((await rows().count()) > 0, words);
  }
  assert.ok((await rows().locator('.label[title*=cup_blue]', {hasText: 'the blue cup'}).count()) > 0);
});

test('who was ruled out is told with the server’s words for the reason, the log’s own on hover', async () => {
  const n = numberOf('talk/staircase', ({kind, resolved}) => resolved?.some((one) => one.ruled_out?.length));
  const {inputs} = await (await fetch(`${server.address}/api/runs/staircase/explain?n=${n}`)).json();
  const [first] = inputs.flatMap(({readings}) => readings.flatMap(({resolved}) => resolved ?? []));
  const [out] = first.ruled_out;
  await visitor.visit(`/r/staircase?n=${n}&tab=why`);
  const item = visitor.page.locator('[data-testid=ruled-out] li').first();
  assert.equal(await item.textContent(), `${out.told} ruled out: ${out.why}`);
  assert.equal(await item.getAttribute('title'), out.why === out.reason ? null : out.reason);
});
