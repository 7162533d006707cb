// Stack, derivation and why of real runs, in a browser served by the program.
import assert from 'node:assert/strict';
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {walk} from '../../web/terms/derivation.js';
import {print} from '../../web/terms/term.js';
import {logOf, recordsOf, serve, temporaryFolder, Visitor} from './support.mjs';

const folder = temporaryFolder();
let server, visitor;
const odd = [
  {kind: 'run', n: 0, t: 0, version: 1, graph: {states: [], start: '', edges: []}},
  {
    kind: 'transition',
    n: 1,
    t: 1,
    id: 7,
    operation: 'x',
    candidates: 'all',
    refused: [null, 3, {id: {}}],
    gates: {},
    stack: 9,
    depth: 'deep',
  },
  {
    kind: 'reading',
    n: 2,
    t: 1,
    cause: 1,
    meaning: 'f((',
    resolved: [null, {words: 3, ruled_out: 'none', referents: {}}],
    missing: 'nothing',
    parses: [4],
  },
  {kind: 'symbol', n: 3, t: 1, id: 10, below: 10.5, slots: {a: {deep: [1]}, b: 'f(x)'}},
  {kind: 'application', n: 4, t: 1, cause: 2, function: 3, argument: null, result: 'f(x)', types: 'none', rule: {}},
  {kind: 'transition', n: 5, t: 2, cause: 4, id: 'on', operation: {rewrite: 3}, stack: 10, depth: 1},
  {kind: 'novelty', n: 6, t: 3, cause: 5, what: 'of a later version', list: [{a: 1}, {b: 'two'}]},
];
const events = new Map(); // run → {n of the act asked for, …}

before(async () => {
  for (const [name, where] of [
    ['dialogue_gesture', 'paper'],
    ['correction', 'paper'],
    ['predicate_first', 'paper'],
    ['staircase', 'talk'],
  ]) {
    writeFileSync(join(folder, `${name}.run.jsonl`), logOf(`${where}/${name}`));
    const all = recordsOf(`${where}/${name}`);
    const of = (test) => all.filter(test).map((one) => one.n);
    events.set(name, {
      all,
      act: of((one) => one.kind === 'act' && one.status === 'asked'),
      question: of((one) => one.kind === 'utterance'),
      steps: of((one) => one.kind === 'transition'),
    });
  }
  const text = readFileSync(join(folder, 'dialogue_gesture.run.jsonl'), 'utf8');
  const last = events.get('dialogue_gesture').act[0];
  writeFileSync(
    join(folder, 'cut.run.jsonl'),
    `${text
      .split('\n')
      .slice(0, last + 1)
      .join('\n')}\n{"kind":"act","n":`,
  );
  writeFileSync(join(folder, 'odd.run.jsonl'), `${odd.map((one) => JSON.stringify(one)).join('\n')}\n`);
  server = await serve(folder);
  visitor = await Visitor.start(server.address);
});
after(async () => {
  await visitor?.close();
  server?.stop();
});
const visit = (path, options) => visitor.visit(path, options);
const at = (id) => visitor.at(id);
const act = (name) => events.get(name).act.at(-1);
const visitAct = (name, more = '', options) => visit(`/r/${name}?n=${act(name)}${more}`, options);

test('the derivation of an act shows what was said and what was pointed at, and leads there', async () => {
  await visitAct('dialogue_gesture');
  assert.match(await at('tree').innerText(), /“put” \+ “it” \(“the plate”\) \+ “there” \(pointing\)/);
  assert.match(await at('tree').innerText(), /← from “there” at #\d+, pointing at #\d+/);
  const chips = await at('chip').allInnerTexts();
  for (const part of ['“there”', '“put”', '“the plate”', 'pointing'])
    assert.ok(
      chips.some((one) => one.startsWith(part)),
      `${part} in ${chips}`,
    );
  assert.ok((await visitor.page.locator('.curve:not(.tip)').count()) >= chips.length);
  await at('chip').filter({hasText: 'pointing'}).click();
  const {all} = events.get('dialogue_gesture');
  assert.equal(all[await visitor.n()].event.kind, 'pointing');
  assert.deepEqual(visitor.complaints, []);
});

test('every term of a derivation is printed from its structure as the log has it', async () => {
  let terms = 0;
  for (const [name, {all}] of events)
    for (const {n, kind} of all) {
      if (!['act', 'application', 'reading', 'learned'].includes(kind)) continue;
      const told = await (await fetch(`${server.address}/api/runs/${name}/explain?n=${n}`)).json();
      for (const {node} of walk(told.derivation)) {
        assert.equal(print(node.structure), node.term);
        ++terms;
      }
    }
  assert.ok(terms > 200, `${terms} terms`);
});

test('the same term as λ and in continuation-passing style, step by step, by keys', async () => {
  await visitAct('dialogue_gesture');
  const n = await visitor.n();
  const {keyboard} = visitor.page;
  await keyboard.press('Alt+ArrowDown');
  assert.equal(await at('depth-λ').getAttribute('aria-pressed'), 'true');
  assert.match(await at('expression').innerText(), /^\(λx v\. put\(x, v\)\)\(plate, .*<.*>.*\)$/);
  assert.ok((await at('expression').locator('.redex').count()) >= 1);
  const step = async () => {
    await keyboard.press('Alt+ArrowRight');
    return at('step').innerText();
  };
  let told = await step();
  for (let most = 20; most > 0 && !/^(\d+) of \1/.test(told); --most) told = await step();
  assert.match(told, /^(\d+) of \1: worked out/);
  assert.match(await at('expression').innerText(), /^put\(plate, .*<.*>.*\)$/);
  await keyboard.press('Alt+ArrowDown');
  const whole = await at('expression').innerText();
  assert.match(whole, /^cpsApply \(cpsApply \(cpsConst put\) \(cpsConst plate\)\) \(.*cpsConst <.*>.*\) k$/);
  await keyboard.press('Alt+ArrowRight');
  const stepped = await at('expression').innerText();
  assert.notEqual(stepped, whole);
  assert.match(stepped, /λ \w+ → /);
  await keyboard.press('Alt+ArrowLeft');
  assert.match(await at('step').innerText(), /^0 of/);
  assert.match(await at('tree').innerText(), /Comp \(e → loc → t\) r/);
  assert.equal(await visitor.n(), n, 'time stands still');
  assert.deepEqual(visitor.complaints, []);
});

test('a node is chosen by keys alone, and the address holds it', async () => {
  await visitAct('dialogue_gesture');
  await at('tree').locator('[role=treeitem]').first().focus();
  await visitor.page.keyboard.press('ArrowDown');
  await visitor.page.keyboard.press('ArrowDown');
  await visitor.page.keyboard.press('Enter');
  await visitor.addressSays('term', '0.0');
  assert.match(await at('node').innerText(), /put: type e → loc → t; “put” in “Put it there\.”/);
  await visitor.page.reload();
  await at('node').waitFor();
  assert.equal(await at('tree').locator('[aria-selected=true]').getAttribute('data-path'), '0.0');
});

test('what is not known yet is a hole that says what it may be', async () => {
  const several = events
    .get('staircase')
    .all.find((one) => one.kind === 'reading' && one.missing?.some((gap) => gap.why === 'several'));
  await visit(`/r/staircase?n=${several.n}`);
  const tree = await at('tree').innerText();
  assert.match(tree, /▢[\s\S]*left open: “[^”]+” may mean [\w ]+, [\w ]+ or [\w ]+/);
  await visit(`/r/predicate_first?n=${events.get('predicate_first').question[0]}`);
  await at('depth-λ').click();
  assert.match(await at('tree').innerText(), /λx\. put\(x, [\s\S]*e → t[\s\S]*▢ x[\s\S]*it was not said/);
});

test('the stack tells what was done, since when a cell has its value and where from', async () => {
  const {steps} = events.get('predicate_first');
  await visit(`/r/predicate_first?n=${steps[0]}&panel=stack`);
  assert.match(await at('operation').innerText(), /push: a symbol was laid on top/);
  assert.match(await at('depth').innerText(), /→ 2 symbols|2 symbols/);
  const command = visitor.page.locator('[data-cell$=".command"]').first();
  await command.focus();
  await visitor.page.keyboard.press('Enter');
  assert.equal(await command.getAttribute('aria-pressed'), 'true');
  const cell = await command.getAttribute('data-cell');
  await visitor.addressSays('cell', cell);
  assert.match(await at('cell-line').innerText(), new RegExp(`command set at #${steps[0]}, just now`));
  assert.match(await at('panel-stack').innerText(), /from “Put it there\.”/);
  // It stays chosen as long as it is on the stack.
  await visit(`/r/predicate_first?n=${steps[1]}&cell=${cell}`);
  assert.match(await at('cell-line').innerText(), new RegExp(`command set at #${steps[0]}`));
  assert.match(await at('subject').innerText(), new RegExp(`The value of command, set at #${steps[0]}`));
  await at('cell-line')
    .locator('button', {hasText: `#${steps[0]}`})
    .first()
    .click();
  assert.equal(await visitor.n(), steps[0]);
  await visit(`/r/predicate_first?n=${steps.at(-1)}&cell=${cell}`);
  assert.match(await at('cell-line').innerText(), /not on the stack here/);
  assert.deepEqual(visitor.complaints, []);
});

test('why: the sentence, the chain to the input, who was ruled out, what came of it', async () => {
  await visitAct('correction');
  assert.match(await at('headline').innerText(), /because the human said “No, that one\.”/);
  assert.match(
    await at('why').innerText(),
    /transition[\s\S]*reading[\s\S]*percept[\s\S]*input[\s\S]*“No, that one\.”/,
  );
  assert.match(await at('inputs').innerText(), /Put the white cup there/);
  await at('who-not').locator('summary').click();
  assert.match(await at('who-not').innerText(), /cup not pointed at/);
  await at('decided').locator('summary').first().click();
  assert.match(await at('decided').innerText(), /Compose → Done/);
  await at('fields').locator('summary').click();
  assert.match(await at('fields').innerText(), /program[\s\S]*put\(cup_blue/);
  const schema = await (await fetch(`${server.address}/api/schema`)).json();
  const {members} = schema.kinds.find((kind) => kind.name === 'act');
  assert.ok((await at('fields').innerText()).includes(members.find((one) => one.name === 'program').meaning));
  await at('why').locator('button').first().click();
  const record = events.get('correction').all[await visitor.n()];
  assert.equal(record.kind, 'transition');
  await visitor.page.waitForFunction(() => document.querySelector('[data-testid=refused]'));
  assert.match(await at('panel-why').innerText(), /applicable/);
  assert.deepEqual(visitor.complaints, []);
});

test('why: the decision stands below the sentence, with condition, stack and what was refused, in sight at once', async () => {
  const decided = (all, {n, kind}) =>
    kind === 'utterance' && all.findLast((one) => one.kind === 'transition' && one.n < n)?.refused?.length;
  const [run, {all}] = [...events].find(([, one]) => one.all.some((record) => decided(one.all, record)));
  const asked = all.find((record) => decided(all, record)).n;
  await visit(`/r/${run}?n=${asked}`);
  const told = await at('decision').innerText();
  const step = all.findLast(({n, kind}) => kind === 'transition' && n < asked);
  assert.ok(told.includes(`${step.id} ${step.from} → ${step.to}`), told);
  assert.match(told, /stack\n\S/);
  assert.match(told, /refused\n\S/);
  const [box, panel] = [await at('decision').boundingBox(), await at('panel-why').boundingBox()];
  assert.ok(box.y > panel.y && box.y + 40 < panel.y + panel.height, 'the decision is in sight');
  assert.doesNotMatch(await at('why').innerText(), /\d s$/m, 'times have one form');
});

test('a log that is cut short is explained as far as it goes', async () => {
  await visit(`/r/cut?n=${act('dialogue_gesture')}`);
  assert.match(await at('headline').innerText(), /puts the white plate/);
  assert.match(await at('tree').innerText(), /“there” \(pointing\)/);
  assert.match(await at('panel-why').innerText(), /ends without its end record|cut|last line|not whole|no end/i);
});

test('records that nobody foresaw are shown field by field', async () => {
  await visit('/r/odd?n=0');
  for (const record of odd) {
    await visitor.page.evaluate(async (n) => {
      window.continua.cursor.jump(n);
      await window.continua.page.settled();
    }, record.n);
    assert.match(await at('panel-why').innerText(), new RegExp(`#${record.n} at`));
    assert.deepEqual(visitor.complaints, [], `record ${record.n}`);
  }
  assert.match(await at('panel-why').innerText(), /what\s+of a later version[\s\S]*list\s+a 1; b two/);
});

test('while scrubbing the panels come to rest at the last record', async () => {
  await visit('/r/staircase?n=2');
  const to = events.get('staircase').steps.at(-1);
  await visitor.page.evaluate(async (last) => {
    for (let n = 3; n <= last; n += 2) {
      window.continua.cursor.select(n, 'slide');
      await new Promise(requestAnimationFrame);
    }
    window.continua.cursor.select(last, 'slide');
  }, to);
  await visitor.page.waitForFunction(
    (n) => document.querySelector('[data-testid=operation]')?.textContent.startsWith(`#${n} `),
    to,
  );
});

for (const colorScheme of ['light', 'dark'])
  test(`axe finds nothing in ${colorScheme}`, async () => {
    await visitAct('dialogue_gesture', '&term=0.1', {colorScheme, bypassCSP: true});
    for (const depth of ['words', 'λ', 'CPS']) {
      await at(`depth-${depth}`).click();
      assert.deepEqual(await visitor.violations(), [], depth);
    }
    const {steps} = events.get('predicate_first');
    await visit(`/r/predicate_first?n=${steps[1]}&cell=1.command&panel=stack`, {colorScheme, bypassCSP: true});
    assert.deepEqual(await visitor.violations(), []);
    await visit(`/r/correction?n=${events.get('correction').steps[1]}&panel=why`, {colorScheme, bypassCSP: true});
    for (const one of await visitor.page.locator('.why details').all())
      await one.evaluate((element) => {
        element.open = true;
      });
    assert.deepEqual(await visitor.violations(), []);
  });
