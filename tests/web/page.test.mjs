// The page in a real browser, served by the program. Exit status 77 means it could not be tried.
import assert from 'node:assert/strict';
import {spawn} from 'node:child_process';
import {existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {after, before, test} from 'node:test';
import {fileURLToPath} from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const program = process.env.CONTINUA ?? join(root, 'build/continua');
const chromium_path = process.env.CHROMIUM || '/usr/bin/chromium';
const packages = process.env.CONTINUA_NODE_MODULES ?? join(root, 'build/tests/web/npm/node_modules');

function skip(why) {
  console.log(`skipped: ${why}`);
  process.exit(77);
}
if (!existsSync(program)) skip(`${program} is not built`);
if (!existsSync(chromium_path)) skip(`there is no browser at ${chromium_path}`);
if (!existsSync(join(packages, 'playwright-core'))) skip(`playwright-core is not in ${packages}`);
const require = createRequire(join(packages, 'x.js'));
const {chromium} = require('playwright-core');
const axe = readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');

/** A run of three rounds of asking and agreeing, with more records than a table can hold. */
function logText() {
  const lines = [];
  const add = (kind, t, fields, cause) => {
    lines.push(JSON.stringify({kind, n: lines.length, t, ...(cause === undefined ? {} : {cause}), ...fields}));
    return lines.length - 1;
  };
  const edge = (id, from, to, input, condition, operation) => ({id, from, to, input, condition, operation});
  add('run', 0, {version: 1, continua: 'test', trace: {name: 'three rounds'}, seed: 0, choice: 'likeliest', machine: {name: 'asking', document: {}},
    graph: {states: ['Wait', 'AskWhichObject', 'Act', 'NeverSeen'].map((id) => ({id, accepting: id === 'Wait'})), start: 'Wait', edges: [
      edge('ask', 'Wait', 'AskWhichObject', 'P', 'size(options) > 1', 'push'), edge('next', 'AskWhichObject', 'AskWhichObject', 'n', null, 'pop'),
      edge('agree', 'AskWhichObject', 'Act', 'y', null, 'rewrite'), edge('done', 'Act', 'Wait', 'ε', null, 'flush'), edge('lost', 'Wait', 'NeverSeen', 'x', null, 'none')]},
    scene: {name: 'table', mjcf: '<mujoco/>'}});
  let id = 1;
  add('symbol', 0, {id, below: null, slots: {}}, 0);
  const step = (t, cause, name, from, to, input, stack, depth) => add('transition', t, {id: name, from, to, input, operation: {none: null}, weight: 1,
    probability: 1, draw: null, candidates: [{id: name, weight: 1}], refused: [{id: 'lost', reason: 'the input is not x'}], gates: [], stack, depth, margin: null}, cause);
  for (let round = 0; round < 3; ++round) {
    const t = 5 + round * 20;
    const said = add('input', t, {line: 2, event: {kind: 'speech', text: `Put it there, ${round}.`, until: t + 1.5}, symbol: 'P'});
    add('application', t, {function: '\\v. \\b. put(b, v)', argument: 'on(block1)', result: '\\b. put(b, on(block1))',
      types: {function: 'loc -> e -> t', argument: 'loc', result: 'e -> t'}, rule: null, because: [said]}, said);
    add('symbol', t, {id: id + 1, below: 1, slots: {action: '\\b. put(b, on(block1))', options: '[block2, block3]'}}, said);
    const asked = step(t, said, 'ask', 'Wait', 'AskWhichObject', 'P', id + 1, 2);
    add('utterance', t, {text: 'Which block?'}, asked);
    for (let i = 0; i < 300; ++i) add('pose', t + 1 + i / 100, {bodies: {hand: [0, 0, 0, 1, 0, 0, 0]}});
    const yes = add('input', t + 5, {line: 3, event: {kind: 'gesture', name: 'yes', phase: 'stroke'}, symbol: 'y'});
    add('symbol', t + 5, {id: id + 2, below: 1, slots: {action: 'put(block2, on(block1))'}}, yes);
    const agreed = step(t + 5, yes, 'agree', 'AskWhichObject', 'Act', 'y', id + 2, 2);
    const act = add('act', t + 5, {act: round + 1, program: 'put(block2, on(block1))', status: 'asked'}, agreed);
    add('act', t + 9, {act: round + 1, program: 'put(block2, on(block1))', status: 'done', result: {position_error_m: 0.001}}, act);
    step(t + 9, agreed, 'done', 'Act', 'Wait', null, 1, 1);
    id += 2;
  }
  add('refusal', 60, {state: 'Wait', input: 'z', reason: 'no transition takes z', refused: [{id: 'ask', reason: 'the input is not P'}]});
  add('end', 61, {counts: {}, decisions: '', physics: '', digest: ''});
  return `${lines.join('\n')}\n`;
}

const folder = mkdtempSync(join(tmpdir(), 'continua-page-'));
let server, browser, address, page, complaints;

before(async () => {
  writeFileSync(join(folder, 'rounds.run.jsonl'), logText());
  writeFileSync(join(folder, 'garbage.run.jsonl'), 'hello\n');
  server = spawn(program, ['serve', folder, '--port', '0'], {stdio: ['ignore', 'pipe', 'inherit']});
  address = await new Promise((resolve, reject) => {
    let said = '';
    server.stdout.on('data', (part) => {
      said += part;
      const found = /http:\/\/[\d.]+:\d+/.exec(said);
      if (found) resolve(found[0]);
    });
    server.on('exit', () => reject(new Error(`the server ended: ${said}`)));
  });
  browser = await chromium.launch({executablePath: chromium_path, args: ['--no-sandbox', '--disable-gpu', '--disable-background-networking',
    '--no-first-run', '--disable-component-update', '--disable-sync']});
});

after(async () => {
  await browser?.close();
  server?.kill();
  rmSync(folder, {recursive: true, force: true});
});

/** A fresh page at this address; notes all that a good page does not do. */
async function visit(path, options = {}) {
  await page?.context().close();
  const context = await browser.newContext({viewport: {width: 1280, height: 720}, ...options});
  page = await context.newPage();
  complaints = [];
  page.on('console', (message) => { if (['error', 'warning'].includes(message.type())) complaints.push(message.text()); });
  page.on('pageerror', (problem) => complaints.push(problem.stack));
  page.on('request', (request) => { if (!request.url().startsWith(address) && !request.url().startsWith('data:')) complaints.push(`asked ${request.url()}`); });
  await page.goto(address + path);
  await page.waitForSelector(path.startsWith('/r/') ? '[data-testid=symbol], .symbols .empty, [data-testid=problem]' : '[data-testid=runs]');
}
const at = (id) => page.locator(`[data-testid=${id}]`);
const query = async (name) => new URL(await page.evaluate(() => location.href)).searchParams.get(name);
const n = () => page.evaluate(() => window.continua.model.selection.n);
/** Waits until the address says so: it is written a little after the fact. */
const addressSays = (name, value) => page.waitForFunction(([key, wanted]) => new URL(location.href).searchParams.get(key) === wanted, [name, String(value)]);

test('the start page lists the runs and opens one', async () => {
  await visit('/');
  assert.equal(await at('run').count(), 2);
  assert.match(await at('run').first().innerText(), /garbage[\s\S]*not a run log/);
  assert.match(await at('run').nth(1).innerText(), /rounds[\s\S]*1:01[\s\S]*asking[\s\S]*table/);
  await page.click('text=rounds');
  await page.waitForSelector('[data-testid=panel-graph]');
  assert.match(page.url(), /\/r\/rounds\?n=/);
  await page.goBack();
  await page.waitForSelector('[data-testid=runs]');
  assert.deepEqual(complaints, []);
});

test('all panels are there, filled, without scrolling the page', async () => {
  await visit('/r/rounds');
  for (const panel of ['dialogue', 'graph', 'stack', 'lanes', 'records', 'details']) assert.ok(await at(`panel-${panel}`).isVisible(), panel);
  assert.match(await at('verdict').innerText(), /3 utterances, 3 acts, 1 refusal, 61 s/);
  assert.ok(await page.evaluate(() => document.documentElement.scrollHeight <= innerHeight));
  // It opens where the avatar first had to ask.
  assert.match(await at('panel-details').innerText(), /Which block\?/);
  assert.match(await at('panel-dialogue').innerText(), /Put it there, 0\./);
  assert.deepEqual(complaints, []);
});

test('the graph shows the states, the current one lit, the others on demand', async () => {
  await visit('/r/rounds');
  const states = at('graph').locator('.node');
  assert.equal(await states.count(), 3);
  assert.equal(await at('graph').locator('.node.current').getAttribute('data-state'), 'AskWhichObject');
  await at('taken-only').uncheck();
  assert.equal(await states.count(), 4);
  await at('graph').locator('[data-state=Act]').click();
  assert.equal(await at('graph').locator('.node.current').getAttribute('data-state'), 'Act');
});

test('the stack shows symbols, slots and changes, with λ', async () => {
  await visit('/r/rounds');
  assert.equal(await at('symbol').count(), 2);
  assert.match(await at('symbol').first().innerText(), /\+[\s\S]*action[\s\S]*λb\. put\(b, on\(block1\)\)/);
  await at('graph').locator('[data-state=Act]').click();
  await page.waitForSelector('.symbol.changed');
  assert.match(await page.locator('.symbol.changed').innerText(), /~[\s\S]*put\(block2, on\(block1\)\)/);
});

test('arrow keys step, and the address follows', async () => {
  await visit('/r/rounds');
  const first = await n();
  await page.keyboard.press('ArrowRight');
  const second = await n();
  assert.ok(second > first + 300, 'poses are not stops');
  await addressSays('n', second);
  await page.keyboard.press('ArrowLeft');
  assert.equal(await n(), first);
  await page.keyboard.press('.');
  assert.equal(await page.evaluate(() => window.continua.data.kind(window.continua.model.selection.n)), 'transition');
  await page.keyboard.press('End');
  const last = await n();
  await page.keyboard.press('Home');
  assert.equal(await n(), 0);
  await page.goBack();
  assert.equal(await n(), last);
  await page.keyboard.press('?');
  assert.ok(await at('keys').isVisible());
  await page.keyboard.press('Escape');
  assert.deepEqual(complaints, []);
});

test('a link restores instant, stretch of time and filter', async () => {
  await visit('/r/rounds?n=317&z=20..30&kind=act&filter=done');
  assert.equal(await n(), 317);
  assert.match(await at('span').innerText(), /20\.0 – 30\.0 s/);
  assert.equal(await at('filter').inputValue(), 'done');
  assert.equal(await at('kind').inputValue(), 'act');
  assert.match(await at('count').innerText(), /^3 of/);
  assert.match(await at('position').innerText(), /#317/);
});

test('what a link says wrongly does no harm', async () => {
  await visit('/r/rounds?n=99999999&z=nonsense&kind=nothing');
  assert.match(await at('position').innerText(), /#/);
  assert.deepEqual(complaints, []);
  await visit('/r/none');
  assert.match(await at('problem').innerText(), /no run 'none'/);
});

test('clicking along the timeline scrubs, the wheel zooms', async () => {
  await visit('/r/rounds?n=5');
  const box = await at('timeline').boundingBox();
  await page.mouse.click(box.x + box.width - 30, box.y + 6);
  assert.ok(await n() > 300);
  const before_zoom = await query('z');
  await page.mouse.move(box.x + box.width / 2, box.y + 50);
  await page.mouse.wheel(0, -300);
  await page.waitForFunction((z) => new URL(location.href).searchParams.get('z') !== z, before_zoom);
});

test('why: an act leads back to what was said, with the applications between', async () => {
  await visit('/r/rounds');
  const act = await page.evaluate(() => window.continua.data.lanes.act[0][2]);
  await visit(`/r/rounds?n=${act}`);
  await at('why').waitFor();
  assert.match(await at('why').innerText(), /transition[\s\S]*AskWhichObject → Act[\s\S]*input/);
  await page.keyboard.press('[');
  await at('refused').waitFor();
  assert.match(await at('panel-details').innerText(), /agree, the only one applicable/);
  await at('refused').locator('summary').click();
  assert.match(await at('refused').innerText(), /the input is not x/);
});

test('records are filtered by text, and only those in sight are in the page', async () => {
  await visit('/r/rounds?kind=*');
  assert.ok(await page.locator('.row').count() < 40);
  await page.keyboard.press('/');
  await page.keyboard.type('which block');
  await page.waitForFunction(() => document.querySelectorAll('.row').length === 3);
  await page.locator('.row').nth(1).click();
  assert.match(await page.locator('.row[aria-selected=true]').innerText(), /Which block/);
});

test('play moves the cursor, space stops it', async () => {
  await visit('/r/rounds');
  const first = await n();
  await page.keyboard.press(' ');
  await page.waitForFunction((start) => window.continua.model.selection.n > start + 20, first);
  await page.keyboard.press(' ');
  assert.equal(await at('play').getAttribute('aria-pressed'), 'false');
});

for (const colorScheme of ['light', 'dark'])
  test(`nothing serious stands in the way of access, ${colorScheme}`, async () => {
    for (const path of ['/', '/r/rounds']) {
      await visit(path, {colorScheme, bypassCSP: true});
      await page.evaluate(axe);
      const {violations} = await page.evaluate(() => window.axe.run());
      const serious = violations.filter(({impact}) => impact === 'serious' || impact === 'critical');
      assert.deepEqual(serious.map(({id, nodes}) => `${id}: ${nodes.map((node) => node.html).slice(0, 3)}`), []);
    }
  });
