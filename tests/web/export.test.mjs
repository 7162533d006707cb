// A run as one file, opened from the disk.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync, statSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {program, recordsOf, root, temporaryFolder, Visitor} from './support.mjs';

const folder = temporaryFolder();
const file = join(folder, 'correction.html');
let visitor;
before(async () => {
  execFileSync(program, [
    'export',
    join(root, 'traces/paper/correction.physics.run.jsonl'),
    '--to',
    'html',
    '-o',
    file,
  ]);
  visitor = await Visitor.start(pathToFileURL(folder).href, {webgl: true});
});
after(() => visitor?.close());
const at = (id) => visitor.at(id);

test('it shows every panel, offline, and complains of nothing', async () => {
  await visitor.visit('/correction.html', {offline: true});
  for (const name of ['dialogue', 'graph', 'scene', 'lanes', 'stack', 'derivation', 'why'])
    assert.ok(await at(`panel-${name}`).isVisible(), name);
  assert.match(await at('verdict').innerText(), /2 utterances/);
  assert.match(await at('panel-dialogue').innerText(), /Put the white cup there/);
  assert.match(await at('panel-why').innerText(), /Why|because|put/);
  await visitor.page.waitForFunction(() =>
    /cup/.test(
      document.querySelector('.stage').getAttribute('aria-label') ??
        document.querySelector('.stage [role=img]')?.getAttribute('aria-label') ??
        '',
    ),
  );
  assert.ok(await visitor.page.evaluate(() => window.continua.page.parts.scene.stage.drawing !== null));
  for (const name of ['records', 'notes']) {
    await at(`tab-${name}`).click();
    assert.ok(await at(`panel-${name}`).isVisible(), name);
  }
  assert.deepEqual(visitor.complaints, []);
});

test('keys, filters and links work as on the served page', async () => {
  await visitor.visit('/correction.html');
  const first = await visitor.n();
  await visitor.page.keyboard.press('ArrowRight');
  const second = await visitor.n();
  assert.ok(second > first);
  await visitor.page.waitForFunction((n) => location.hash.includes(`n=${n}`), second);
  await visitor.page.keyboard.press('/');
  await visitor.page.keyboard.type('okay');
  await visitor.page.waitForFunction(() => {
    const rows = [...document.querySelectorAll('.row')];
    return rows.length && rows.every((row) => /okay/i.test(row.textContent));
  });
  await visitor.visit('/correction.html#/r/correction.physics?n=5&panel=stack');
  assert.equal(await visitor.n(), 5);
  assert.ok(await visitor.page.locator('.panel.stack.enlarged').isVisible());
});

test('a stretch of it is handed over as the records of the log', async () => {
  await visitor.visit('/correction.html');
  await visitor.selectStretch();
  const [from, to] = (await at('stretch').innerText()).match(/\d+:\d\d\.\d\d/g).map((text) => Number(text.slice(2)));
  const [file] = await Promise.all([
    visitor.page.waitForEvent('download'),
    at('stretch').locator('button', {hasText: 'Export this stretch'}).click(),
  ]);
  const told = readFileSync(await file.path(), 'utf8')
    .trimEnd()
    .split('\n');
  const expected = recordsOf('paper/correction.physics').filter(({t}) => t > from - 0.005 && t < to + 0.005);
  assert.ok(told.length > 200, `${told.length} records`);
  assert.deepEqual(
    told.map((line) => JSON.parse(line)),
    expected,
  );
});

test('it asks for nothing elsewhere, and holds no more than it must', () => {
  const text = readFileSync(file, 'utf8').replace(/>[A-Za-z0-9+/=\n]{200,}</g, '><');
  assert.deepEqual(text.match(/(?:src|href)=["'](?!data:)[^"']*/g), null);
  assert.match(text, /default-src 'none'/);
  assert.ok(statSync(file).size < 3e6, `${statSync(file).size} bytes`);
});

test('nothing stands in the way of access', async () => {
  await visitor.visit('/correction.html', {bypassCSP: true});
  assert.deepEqual(await visitor.violations(), []);
});
