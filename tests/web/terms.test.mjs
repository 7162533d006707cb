// Terms, their steps, and the views of the derivation, stack and why panels on the server's answers: no browser needed.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {apply, lambda, literal, name, print, Printer} from '../../web/terms/term.js';
import {cps_apply, cps_const, states, step, substituted, variable} from '../../web/terms/reduce.js';
import {
  arrows,
  compType,
  described,
  gloss,
  line,
  nodeAt,
  sources,
  stepsAt,
  told,
  typeOf,
  walk,
} from '../../web/terms/derivation.js';
import {CellTracker} from '../../web/terms/cells.js';
import {age, operationWords, stackRows} from '../../web/terms/stack_words.js';
import {Latest} from '../../web/terms/latest.js';

// Terms as the server takes them apart. A name is written as a text.
const term = (one) => (typeof one === 'string' ? name(one) : one);
const call = (head, ...args) => apply(term(head), ...args.map(term));
const fun = (variables, body) => variables.split(' ').reduceRight((inner, one) => lambda(one, inner), term(body));
const point = (...numbers) => ({kind: 'point', parts: numbers.map((one) => literal(String(one)))});
const list = (...parts) => ({kind: 'list', parts: parts.map(term)});
const number = (value) => literal(String(value));

test('a term is printed in the notation of logs', () => {
  const rows = [
    [call('negate', 'x'), '-x'],
    [call('+', number('-3.5e-7'), call('*', 'y', call('-', number(2), 'z'))), '-3.5e-7 + y * (2 - z)'],
    [call('or', call('not', call('and', 'a', 'b')), 'c'), 'not (a and b) or c'],
    [call('and', call('or', 'a', 'b'), 'c'), '(a or b) and c'],
    [call('-', 'a', call('-', 'b', 'c')), 'a - (b - c)'],
    [call('=', 'a', call('=', 'b', 'c')), 'a = (b = c)'],
    [point('0.1', '-1', '0.5'), '<0.1, -1, 0.5>'],
    [call('f', literal("'it\\'s'"), name('red block', true)), "f('it\\'s', `red block`)"],
    [{kind: 'apply', head: fun('x', call('f', 'x')), args: [name('a'), name('b')]}, '(\\x. f(x))(a, b)'],
    [lambda('x', lambda('y', call('y', 'x'), 'e -> t'), 'e'), '\\x: e. \\y: e -> t. y(x)'],
    [fun('x y z', 'x'), '\\x y z. x'],
    [name('+'), '(+)'],
    [call('fold', '+', list(number(1), number(2))), 'fold((+), [1, 2])'],
    [list(list(), list('a')), '[[], [a]]'],
    [call('map', fun('o', call('>', call('size', 'o'), number(1))), 'os'), 'map(\\o. size(o) > 1, os)'],
  ];
  for (const [structure, text] of rows) assert.equal(print(structure), text);
  assert.equal(print(fun('x', call('f', 'x')), {sign: 'λ'}), 'λx. f(x)');
});

test('parts of a term are marked by themselves, and not their equals', () => {
  const whole = call('f', 'a', call('g', 'a'));
  const pieces = new Printer({mark: whole.args[1]}).pieces(whole);
  assert.deepEqual(pieces, [
    {text: 'f(a, ', marked: false},
    {text: 'g(a)', marked: true},
    {text: ')', marked: false},
  ]);
});

test('β puts the argument for the variable and catches no name', () => {
  assert.equal(print(states(call(fun('x y', call('f', 'x', 'y')), 'a', 'b')).at(-1).term), 'f(a, b)');
  assert.equal(print(states(call(fun('x y', call('f', 'x', 'y')), 'y')).at(-1).term), "\\y'. f(y, y')");
  assert.equal(print(substituted(fun('x', call('f', 'x')), 'x', name('a'))), '\\x. f(x)');
  assert.equal(print(states(call(fun('f', call('f', 'a')), fun('x', call('g', 'x')))).at(-1).term), 'g(a)');
  assert.equal(step(call('f', 'a')), null);
  const endless = states(call(fun('x', call('x', 'x')), fun('x', call('x', 'x'))));
  assert.ok(endless.length > 50 && endless.length < 200);
});

test('cpsApply runs the argument before the function, and ends in the continuation', () => {
  const c = (text) => apply(cps_const, name(text));
  const all = states(apply(cps_apply, apply(cps_apply, c('put'), c('cup')), c('there'), variable('k')));
  const texts = all.map(({term}) => print(term, {sign: 'λ', haskell: true}));
  assert.equal(texts[0], 'cpsApply (cpsApply (cpsConst put) (cpsConst cup)) (cpsConst there) k');
  assert.equal(texts[1], 'cpsConst there (λ b → cpsApply (cpsConst put) (cpsConst cup) (λ a → k (a b)))');
  assert.equal(texts.at(-1), 'k (put(cup, there))');
  assert.ok(
    texts.findIndex((text) => text.startsWith('cpsConst there')) <
      texts.findIndex((text) => text.startsWith('cpsConst cup')),
  );
  assert.ok(
    texts.findIndex((text) => text.startsWith('cpsConst cup')) <
      texts.findIndex((text) => text.startsWith('cpsConst put')),
  );
});

const words = (text, input, from) => ({
  kind: 'words',
  text: `“${text}” in “Put it there.” (1.0 s)`,
  words: text,
  n: input + 1,
  input,
  t: 1,
  ...(from && {from}),
});
const node = (structure, rest) => ({term: print(term(structure)), structure: term(structure), ...rest});
const leaf = (structure, type, origin) => node(structure, {type, how: 'leaf', origin});
const pointing = {kind: 'pointing', text: 'the right hand’s pointing (1.2 s)', n: 7, input: 5, t: 1.2};
const open = {
  kind: 'open',
  text: 'left open: “block” may mean a or b, in “Put it there.” (1.0 s)',
  n: 4,
  input: 3,
  t: 1,
};
const put = node(call('put', 'cup', point(1, 2, 0)), {
  type: 't',
  how: 'application',
  n: 20,
  rule: null,
  children: [
    node(call('put', 'cup'), {
      type: 'loc -> t',
      how: 'application',
      n: 19,
      rule: null,
      children: [leaf('put', 'e -> loc -> t', words('put', 3)), leaf('cup', 'e', words('it', 3, words('the cup', 1)))],
    }),
    leaf(point(1, 2, 0), 'loc', words('there', 3, pointing)),
  ],
});
const lacking = node(fun('x', call('put', 'x')), {
  type: null,
  how: 'abstraction',
  children: [
    node(call('put', 'x'), {
      type: 't',
      how: 'application',
      n: 9,
      rule: null,
      children: [leaf('put', 'e -> t', words('put', 3)), leaf('x', 'e', open)],
    }),
  ],
});

test('a derivation is told in the words and gestures it came from', () => {
  assert.equal(gloss(put), '“put” + “it” (“the cup”) + “there” (pointing)');
  assert.equal(told(put.children[1].origin), 'from “there” at #3, pointing at #5');
  assert.deepEqual(
    sources(put).map(({n, text, kind, paths}) => [n, text, kind, paths.join()]),
    [
      [1, '“the cup”', 'words', '0.1'],
      [3, '“put”', 'words', '0.0'],
      [3, '“it”', 'words', '0.1'],
      [3, '“there”', 'words', '1'],
      [5, 'pointing', 'pointing', '1'],
    ],
  );
  assert.deepEqual(
    walk(put).map(({path}) => path),
    ['', '0', '0.0', '0.1', '1'],
  );
  assert.equal(nodeAt(put, '0.1').term, 'cup');
  assert.equal(nodeAt(put, '0.7'), null);
  assert.match(described(put.children[1]), /type loc; “there” in/);
});

test('what a slot kept goes back to the word or gesture since which it has it', () => {
  const slot = leaf('cup', 'e', {
    kind: 'slot',
    text: 'slot options since gesture right point start (3.0 s)  #9',
    n: 9,
    input: 8,
    t: 3,
  });
  const memory = leaf('f', 'e -> t', {
    kind: 'memory',
    text: 'register last since “Yes (it is)” (2.0 s)  #7',
    n: 7,
    input: 6,
    t: 2,
  });
  const kept = node(call('f', 'cup'), {type: 't', how: 'application', n: 11, rule: null, children: [memory, slot]});
  assert.deepEqual(
    sources(kept).map(({n, text, kind}) => [n, text, kind]),
    [
      [6, '“Yes (it is)”', 'words'],
      [8, 'gesture right point start', 'gesture'],
    ],
  );
  assert.equal(told(slot.origin), 'from gesture right point start, in slot options at #8');
});

test('the λ-terms are worked out from what each word brings', () => {
  const all = stepsAt(put, 'λ').map(({term}) => print(term, {sign: 'λ'}));
  assert.deepEqual(all, ['(λx v. put(x, v))(cup, <1, 2, 0>)', '(λv. put(cup, v))(<1, 2, 0>)', 'put(cup, <1, 2, 0>)']);
  assert.deepEqual(stepsAt(put, 'gloss'), []);
  assert.deepEqual(line(put.children[0], 'λ'), {text: 'put(cup)', type: 'loc → t'});
});

test('in continuation-passing style a node is a computation', () => {
  assert.deepEqual(line(put, 'CPS'), {text: 'cpsApply m n', type: 'Comp t r'});
  assert.deepEqual(line(put.children[0].children[0], 'CPS'), {text: 'cpsConst put', type: 'Comp (e → loc → t) r'});
  assert.equal(print(stepsAt(put, 'CPS').at(-1).term, {haskell: true}), 'k (put(cup, <1, 2, 0>))');
});

test('what is missing is a hole with its type', () => {
  assert.equal(gloss(lacking), '“put” + ▢');
  assert.equal(typeOf(lacking), 'e -> t');
  assert.match(described(lacking.children[0].children[1]), /type e; left open: “block” may mean a or b/);
  assert.equal(print(stepsAt(lacking, 'λ').at(-1).term), '\\x. put(x)');
  assert.equal(print(stepsAt(lacking, 'CPS').at(-1).term, {sign: 'λ', haskell: true}), 'λ x → k (put(x))');
});

test('a raising rule stands by its name until the result is there', () => {
  const raised = {
    ...put,
    ...node(call('put', 'cup', call('near', 'box'))),
    rule: 'near_it',
    children: [leaf(fun('v', call('put', 'cup', 'v')), 'loc -> t', null), leaf('box', 'e', null)],
  };
  const lambda = stepsAt(raised, 'λ').map(({term}) => print(term));
  const last = stepsAt(raised, 'CPS').map(({term}) => print(term, {haskell: true}));
  assert.deepEqual(lambda.slice(-2), ['put(cup, near_it(box))', 'put(cup, near(box))']);
  assert.equal(last.at(-1), 'k (put(cup, near(box)))');
  assert.match(line(raised, 'CPS').text, /cpsConst near_it/);
  assert.match(described(raised), /raised by near_it/);
});

test('types are taken apart at their arrows', () => {
  assert.deepEqual(arrows('(e -> t) -> e list -> t'), [['(e -> t)', 'e list'], 't']);
  assert.deepEqual(arrows(null), [[], '']);
  assert.equal(compType('e -> t'), 'Comp (e → t) r');
});

test('derivations that are not as they should be harm nobody', () => {
  for (const root of [
    null,
    {},
    {term: 5, how: 'application', children: [null, 3]},
    {term: 'f(', children: 'x'},
    {term: 'a', how: 'leaf', origin: 'words'},
    {how: 'abstraction', term: 'x', children: [{}]},
    {rule: {}, how: 'application', children: [{}, {}]},
  ])
    for (const depth of ['gloss', 'λ', 'CPS']) {
      stepsAt(root, depth);
      for (const {node} of walk(root)) {
        line(node, depth);
        described(node);
        told(node.origin);
      }
      sources(root);
    }
});

test('a cell is found again under the id of whatever took its place', () => {
  const tracker = new CellTracker();
  const cell = (symbol, slot, ...older) => ({symbol, slot, symbols: [symbol, ...older]});
  assert.equal(tracker.find([cell(5, 'a'), cell(5, 'b')], '5.b').slot, 'b');
  assert.equal(tracker.find([cell(7, 'b', 6, 5)], '5.b').symbol, 7);
  assert.equal(tracker.find([cell(6, 'b', 5)], '7.b'), null);
  assert.equal(tracker.find([cell(7, 'b', 6, 5)], '7.b').symbol, 7);
  assert.equal(tracker.find([cell(5, 'b')], '7.b').symbol, 5);
  assert.equal(tracker.find([cell(8, 'b')], '7.b'), null);
  assert.equal(tracker.find(undefined, '7.b'), null);
  assert.equal(tracker.find([cell(8, 'b')], ''), null);
});

test('a stack is told before and after, its unchanged tail folded', () => {
  const same = (id) => ({id, change: 'same', slots: {}});
  const {rows, folded} = stackRows({
    symbols: [
      {
        id: 9,
        change: 'changed',
        slots: {a: '2', c: '3'},
        slots_changed: {a: {was: '1', now: '2'}, c: {was: null, now: '3'}},
      },
      same(1),
      same(2),
      same(3),
    ],
    removed: [{id: 8, slots: {}}],
  });
  assert.deepEqual(rows[0].after, null);
  assert.deepEqual(rows[1].before.slots, {a: '1'});
  assert.equal(folded, 3);
  assert.equal(stackRows({symbols: [same(1), same(2)]}).folded, 0);
  assert.equal(stackRows({symbols: [same(1), same(2), same(3)]}).folded, 2);
  assert.deepEqual(operationWords({push: {a: 'meaning', b: null}}), {
    what: 'push: a symbol was laid on top',
    sets: [
      ['a', 'meaning'],
      ['b', 'null'],
    ],
  });
  assert.match(operationWords({pop: 2}).what, /2 symbols/);
  assert.match(operationWords({pop_until: 'a = b'}).what, /until a = b/);
  for (const odd of [null, undefined, 7, 'x', [], {}, {later: {a: 1}}])
    assert.equal(typeof operationWords(odd).what, 'string');
  assert.equal(age(4.2), '4.2 s ago');
  assert.equal(age(0), 'just now');
});

test('of many questions in a row only the first and the last are asked, and only the last is answered', async () => {
  const asked = [];
  const shown = [];
  const waiting = [];
  const latest = new Latest(
    (key) => {
      asked.push(key);
      return new Promise((done) => waiting.push(done));
    },
    (answer, key) => shown.push([answer, key]),
    () => {},
  );
  for (let key = 1; key <= 60; ++key) latest.want(key);
  assert.deepEqual(asked, [1]);
  waiting[0]('old');
  await new Promise((done) => setTimeout(done));
  assert.deepEqual(asked, [1, 60]);
  waiting[1]('new');
  await new Promise((done) => setTimeout(done));
  latest.want(60);
  assert.deepEqual(shown, [['new', 60]]);
  assert.deepEqual(asked, [1, 60]);
});
