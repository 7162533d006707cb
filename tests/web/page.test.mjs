// The page of a run in a real browser, served by the program.
import assert from 'node:assert/strict';
import {writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {roundsLog} from './logs.mjs';
import {serve, temporaryFolder, Visitor} from './support.mjs';

const folder = temporaryFolder();
let server, visitor;
before(async () => {
  writeFileSync(join(folder, 'rounds.run.jsonl'), roundsLog());
  writeFileSync(join(folder, 'garbage.run.jsonl'), 'hello\n');
  server = await serve(folder);
  visitor = await Visitor.start(server.address);
});
after(async () => {
  await visitor?.close();
  server?.stop();
});
const visit = (path, options) => visitor.visit(path, options);
const at = (id) => visitor.at(id);
const n = () => visitor.n();

test('the start page lists the runs and opens one', async () => {
  await visit('/');
  assert.equal(await at('run').count(), 2);
  assert.match(await at('run').first().innerText(), /garbage[\s\S]*not a run log/);
  assert.match(await at('run').nth(1).innerText(), /rounds[\s\S]*1:01[\s\S]*asking[\s\S]*table/);
  await visitor.page.click('text=rounds');
  await visitor.page.waitForSelector('[data-testid=panel-graph]');
  assert.match(visitor.page.url(), /\/r\/rounds\?n=/);
  await visitor.page.goBack();
  await visitor.page.waitForSelector('[data-testid=runs]');
  assert.deepEqual(visitor.complaints, []);
});

test('all panels are there, filled, without scrolling the page', async () => {
  await visit('/r/rounds');
  for (const panel of ['dialogue', 'graph', 'scene', 'stack', 'derivation', 'lanes', 'why'])
    assert.ok(await at(`panel-${panel}`).isVisible(), panel);
  assert.match(await at('verdict').innerText(), /3 utterances, 3 of 3 acts done, 1 input refused/);
  assert.ok(await visitor.page.evaluate(() => document.documentElement.scrollHeight <= innerHeight));
  // It opens where the avatar first had to ask.
  assert.match(await at('panel-why').innerText(), /Which block\?/);
  assert.match(await at('panel-dialogue').innerText(), /Put it there, 0\./);
  assert.deepEqual(visitor.complaints, []);
});

test('the graph shows the states, the current one lit, the others on demand', async () => {
  await visit('/r/rounds');
  const states = at('graph').locator('.node');
  assert.equal(await states.count(), 3);
  assert.equal(await at('graph').locator('.node.current').getAttribute('data-state'), 'AskWhichObject');
  assert.match(await at('graph').locator('.edge.last').getAttribute('aria-label'), /to AskWhichObject, taken/);
  await at('taken-only').uncheck();
  assert.equal(await states.count(), 4);
  await at('graph').locator('[data-state=Act]').click();
  assert.equal(await at('graph').locator('.node.current').getAttribute('data-state'), 'Act');
});

test('an arrow tells its transitions, by mouse and by key', async () => {
  await visit('/r/rounds');
  await at('graph').locator('.edge.taken').first().focus();
  await visitor.page.keyboard.press('Enter');
  assert.ok(await at('edge-card').isVisible());
  assert.match(await at('edge-card').innerText(), /→[\s\S]*time/);
  await visitor.page.keyboard.press('Enter');
  assert.ok(await at('edge-card').isHidden());
});

test('the stack shows symbols, slots and changes, with λ', async () => {
  await visit('/r/rounds');
  assert.equal(await at('symbol').count(), 2);
  assert.match(await at('symbol').first().innerText(), /\+[\s\S]*action[\s\S]*λb\. put\(b, on\(block1\)\)/);
  await at('graph').locator('[data-state=Act]').click();
  await visitor.page.waitForSelector('.symbol.changed:not(.was)');
  const changed = visitor.page.locator('.symbol.changed:not(.was)');
  assert.match(await changed.innerText(), /~[\s\S]*λb\. put\(b, on\(block1\)\)[\s\S]*puts block2 on block1/);
  assert.equal(await changed.locator('[title="put(block2, on(block1))"]').count(), 1, 'the log has the term');
});

test('arrow keys step, and the address follows', async () => {
  await visit('/r/rounds');
  const first = await n();
  await visitor.page.keyboard.press('ArrowRight');
  const second = await n();
  assert.ok(second > first + 300, 'poses are not stops');
  await visitor.addressSays('n', second);
  await visitor.page.keyboard.press('ArrowLeft');
  assert.equal(await n(), first);
  await visitor.page.keyboard.press('.');
  assert.equal(
    await visitor.page.evaluate(() => window.continua.page.data.kind(window.continua.model.selection.n)),
    'transition',
  );
  await visitor.page.keyboard.press('End');
  const last = await n();
  await visitor.page.keyboard.press('Home');
  assert.equal(await n(), 0);
  await visitor.page.goBack();
  assert.equal(await n(), last);
  await visitor.page.keyboard.press('?');
  assert.ok(await at('keys').isVisible());
  await visitor.page.keyboard.press('Escape');
  assert.deepEqual(visitor.complaints, []);
});

test('by keyboard alone: panels, tabs, places, pauses', async () => {
  await visit('/r/rounds');
  const {keyboard} = visitor.page;
  const selected = () => visitor.page.evaluate(() => window.continua.model.selection);
  await keyboard.press('2');
  assert.ok(await visitor.page.evaluate(() => document.activeElement.closest('.panel.graph') !== null));
  await keyboard.press('2');
  assert.ok(await visitor.page.locator('.panel.graph.enlarged').isVisible());
  await visitor.addressSays('panel', 'graph');
  await keyboard.press('Escape');
  assert.equal((await selected()).panel, '');
  await keyboard.press('#');
  await keyboard.type('0:30');
  await keyboard.press('Enter');
  assert.ok(
    Math.abs((await visitor.page.evaluate(() => window.continua.page.data.t[window.continua.model.selection.n])) - 30) <
      5,
  );
  await keyboard.press('#');
  await keyboard.type('nowhere at all');
  await keyboard.press('Enter');
  assert.ok(await visitor.page.locator('dialog[open] .trouble').isVisible());
  await keyboard.press('Escape');
  await keyboard.press('g');
  assert.ok((await selected()).gaps);
  for (const [key, tab] of [
    ['/', 'records'],
    ['m', 'notes'],
    ['y', 'why'],
  ]) {
    await keyboard.press(key);
    assert.ok(await at(`panel-${tab}`).isVisible(), tab);
    await visitor.page.evaluate(() => document.activeElement.blur());
  }
  await at('tab-why').focus();
  await keyboard.press('ArrowRight');
  assert.ok(await at('panel-account').isVisible());
  await keyboard.press('ArrowRight');
  assert.ok(await at('panel-records').isVisible());
  await keyboard.press('ArrowRight');
  assert.ok(await at('panel-notes').isVisible(), 'the focus goes along');
  assert.deepEqual(visitor.complaints, []);
});

test('a rest between two inputs is drawn short, and at full length when that is wanted', async () => {
  await visit('/r/rounds?z=0..61');
  assert.ok(await at('gaps').isChecked());
  const place = () => visitor.page.evaluate(() => window.continua.page.parts.lanes.placeOf(45));
  const short = await place();
  await at('gaps').uncheck();
  assert.ok((await place()) > short + 50);
  await visitor.addressSays('gaps', 'full');
});

test('a link restores instant, stretch of time and filter', async () => {
  await visit('/r/rounds?n=317&z=20..30&kind=act&filter=done');
  assert.equal(await n(), 317);
  assert.match(await at('span').innerText(), /0:20\.0 – 0:30\.0/);
  assert.equal(await at('filter').inputValue(), 'done');
  assert.equal(await at('kind').inputValue(), 'act');
  assert.match(await at('count').innerText(), /^3 of/);
  assert.match(await at('position').innerText(), /#317/);
});

test('what a link says wrongly does no harm', async () => {
  await visit('/r/rounds?n=99999999&z=nonsense&kind=nothing');
  assert.match(await at('position').innerText(), /#/);
  assert.deepEqual(visitor.complaints, []);
  await visit('/r/none');
  assert.match(await at('problem').innerText(), /no run 'none'/);
});

test('clicking along the timeline scrubs, the wheel zooms', async () => {
  await visit('/r/rounds?n=5');
  const box = await at('timeline').boundingBox();
  await visitor.page.mouse.click(box.x + box.width - 30, box.y + 6);
  assert.ok((await n()) > 300);
  const before_zoom = await visitor.query('z');
  await visitor.page.mouse.move(box.x + box.width / 2, box.y + 50);
  await visitor.page.mouse.wheel(0, -300);
  await visitor.page.waitForFunction((z) => new URL(location.href).searchParams.get('z') !== z, before_zoom);
});

test('why: an act leads back to what was said, with the applications between', async () => {
  await visit('/r/rounds');
  const act = await visitor.page.evaluate(() => window.continua.page.data.lanes.act.n[0]);
  await visit(`/r/rounds?n=${act}`);
  await at('why').waitFor();
  assert.match(await at('why').innerText(), /transition[\s\S]*AskWhichObject → Act[\s\S]*input/);
  await visitor.page.keyboard.press('[');
  await at('refused').waitFor();
  assert.match(await at('panel-why').innerText(), /agree, the only one applicable/);
  assert.match(await at('refused').innerText(), /the input is not x/);
});

test('records are filtered by text, and only those in sight are in the page', async () => {
  await visit('/r/rounds?kind=*');
  assert.ok((await visitor.page.locator('.row').count()) < 40);
  await visitor.page.keyboard.press('/');
  await visitor.page.keyboard.type('which block');
  await visitor.page.waitForFunction(() => document.querySelectorAll('.row').length === 3);
  await visitor.page.locator('.row').nth(1).click();
  assert.match(await visitor.page.locator('.row[aria-selected=true]').innerText(), /Which block/);
});

test('play moves the cursor, space stops it', async () => {
  await visit('/r/rounds');
  const first = await n();
  await visitor.page.keyboard.press(' ');
  await visitor.page.waitForFunction((start) => window.continua.model.selection.n > start + 20, first);
  await visitor.page.keyboard.press(' ');
  assert.equal(await at('play').getAttribute('aria-pressed'), 'false');
});

for (const colorScheme of ['light', 'dark'])
  test(`nothing stands in the way of access, ${colorScheme}`, async () => {
    for (const path of ['/', '/r/rounds']) {
      await visit(path, {colorScheme, bypassCSP: true});
      assert.deepEqual(await visitor.violations(), []);
    }
  });
