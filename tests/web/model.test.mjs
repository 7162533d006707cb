// The page's logic without a page: addresses, columns, stops, states over time, the axis, layout without libraries.
import assert from 'node:assert/strict';
import {mkdtempSync, cpSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';
import {test} from 'node:test';

const web = join(dirname(fileURLToPath(import.meta.url)), '../../web');
// The modules beside a vendor.js as it is built without libraries.
const folder = mkdtempSync(join(tmpdir(), 'continua-web-'));
cpSync(web, folder, {recursive: true, filter: (file) => !/\.(png|txt|cmake)$/.test(file)});
writeFileSync(join(folder, 'vendor.js'), 'export const dagre = null;\nexport const three = null;\n');
writeFileSync(join(folder, 'package.json'), '{"type": "module"}');
const load = (name) => import(pathToFileURL(join(folder, name)));
const {parseAddress, formatAddress, fresh} = await load('model.js');
const {lastAtMost} = await load('search.js');
const {RunData} = await load('run/run_data.js');
const {readColumns} = await load('run/columns.js');
const {TimeAxis, idleGaps} = await load('timeline/time_axis.js');
const {Comparison} = await load('run/comparison.js');
const {mergedGraph, layOut, labelLines} = await load('graph/graph_layout.js');
const {placeOf} = await load('panels/go_to.js');

const nothing = parseAddress('/');

test('an address and what it says are the same thing', () => {
  const all = {
    run: 'a b',
    other: null,
    n: 137,
    branch: 2,
    cell: '5.options',
    term: '0.1',
    zoom: [11.9, 13.1],
    gaps: true,
    by_time: true,
    filter: 'put( λ&',
    kind: 'act',
    panel: 'graph',
    tab: 'notes',
    hunk: null,
    search: '',
  };
  assert.deepEqual(parseAddress(formatAddress(all)), all);
  const compared = {...all, run: 'x/y', other: 'z', hunk: 3, n: null, zoom: null};
  assert.deepEqual(parseAddress(formatAddress(compared)), compared);
  assert.equal(formatAddress({...nothing, ...fresh('a b'), n: 137, zoom: [11.9, 13.1]}), '/r/a%20b?n=137&z=11.9..13.1');
  assert.equal(formatAddress({...nothing, ...fresh('a', 'b'), hunk: 0}), '/diff/a/b?h=0');
  assert.equal(formatAddress(nothing), '/');
  assert.equal(parseAddress(formatAddress({...nothing, search: 'two words'})).search, 'two words');
});

test('what an address says wrongly is left open', () => {
  assert.deepEqual(parseAddress('/r/x?n=-3&z=5..2&other=1&h=-1&b=two'), {...nothing, run: 'x'});
  assert.equal(parseAddress('/r/x?n=abc').n, null);
  assert.equal(parseAddress('/elsewhere').run, null);
  assert.equal(parseAddress('/r/%E0%A4%A').run, '%E0%A4%A');
});

test('the last element that is at most a value', () => {
  assert.equal(lastAtMost([], 1), -1);
  assert.equal(lastAtMost([1, 2, 2, 3], 2), 2);
  assert.equal(lastAtMost([1, 2, 2, 3], 0.5), -1);
  assert.equal(lastAtMost([1, 2, 2, 3], 9), 3);
});

/** Columns packed as the server packs them. */
function packed(header, columns) {
  const arrays = {
    Float64Array: 'f64',
    Float32Array: 'f32',
    Int32Array: 'i32',
    Uint32Array: 'u32',
    Uint16Array: 'u16',
    Uint8Array: 'u8',
  };
  let offset = 0;
  const described = {};
  for (const [name, column] of Object.entries(columns)) {
    described[name] = {type: arrays[column.constructor.name], offset, length: column.length};
    offset += Math.ceil(column.byteLength / 8) * 8;
  }
  const text = new TextEncoder().encode(JSON.stringify({...header, columns: described}));
  const start = Math.ceil((4 + text.length) / 8) * 8;
  const buffer = new ArrayBuffer(start + offset);
  const bytes = new Uint8Array(buffer);
  new DataView(buffer).setUint32(0, text.length, true);
  bytes.set(text, 4);
  for (const [name, column] of Object.entries(columns))
    bytes.set(new Uint8Array(column.buffer), start + described[name].offset);
  return buffer;
}

function run({
  names = ['A', 'B', 'C', 'x'],
  t = [0, 1, 1, 4, 3.5, 6],
  kinds = ['run', 'transition'],
  kind = t.map((_, i) => (i ? 1 : 0)),
  cause = [-1, 0, 1, 0, 3, 2],
  columns = {},
} = {}) {
  const buffer = packed(
    {records: t.length, duration: Math.max(...t), kinds, names, complete: true},
    {
      t: Float64Array.from(t),
      kind: Uint8Array.from(kind),
      cause: Int32Array.from(cause),
      stop: Uint32Array.of(1, 3, 5),
      'step.n': Uint32Array.of(1, 2, 5),
      'step.id': Uint16Array.of(3, 3, 3),
      'step.from': Uint16Array.of(0, 1, 0),
      'step.to': Uint16Array.of(1, 0, 2),
      'step.depth': Uint16Array.of(2, 1, 3),
      ...columns,
    },
  );
  return new RunData({
    summary: {counts: {}},
    schema: {stamp: [], kinds: []},
    graph: {start: 'A', states: [{id: 'A'}, {id: 'B'}, {id: 'C'}], edges: []},
    columns: readColumns(buffer),
    labels: {label: () => '', text: () => ''},
  });
}
const data = run();

test('steps go from stop to stop, also from between them, and stay inside the run', () => {
  assert.equal(data.stop([1, 3, 5], 3, 1), 5);
  assert.equal(data.stop([1, 3, 5], 4, 1), 5);
  assert.equal(data.stop([1, 3, 5], 4, -1), 3);
  assert.equal(data.stop([1, 3, 5], 0, -1), 1);
  assert.equal(data.stop([1, 3, 5], 1, 10), 5);
});

test('states last until the next transition; those without length are left out', () => {
  const {state} = data.lanes;
  assert.deepEqual([...state.name], [0]);
  assert.deepEqual([state.from[0], state.to[0]], [0, 6]);
  assert.equal(data.state(0), 'A');
  assert.equal(data.state(1), 'B');
  assert.equal(data.state(4), 'A');
  assert.equal(data.depth(5), 3);
  assert.deepEqual(data.stepAt(2), {n: 5, id: 'x', from: 'A', to: 'C'});
});

test('a time between records, and times out of order, find the last record reached', () => {
  assert.equal(data.at(0.5), 0);
  assert.equal(data.at(1), 2);
  assert.equal(data.at(4), 4);
  assert.equal(data.at(99), 5);
  assert.equal(data.t[4], 3.5, 'the times themselves stay');
});

test('effects are the records that name this one as their cause', () => {
  assert.deepEqual(data.effects(0), [1, 3]);
});

test('what is typed to go to: a number, an instant, a state', () => {
  for (const [text, n] of [
    ['#3', 3],
    ['3', 3],
    ['99', null],
    ['1.0 s', 1],
    ['0:04', 3],
    ['c', 5],
    ['nowhere', null],
    ['', null],
  ])
    assert.equal(placeOf(data, text, 0), n, text);
});

test('idle time is drawn short, and a place on the axis is a time again', () => {
  const spans = [{from: Float64Array.of(3), to: Float64Array.of(9)}];
  const gaps = idleGaps(Float64Array.of(0, 1, 3, 20, 21), Uint32Array.of(0, 1, 2, 3, 4), spans, 30);
  assert.deepEqual(
    gaps,
    [
      [9, 20],
      [21, 30],
    ],
    'what goes on is not idle',
  );
  const axis = new TimeAxis(gaps);
  assert.equal(axis.of(9), 9);
  assert.ok(axis.of(20) - axis.of(9) < 1);
  assert.ok(Math.abs(axis.of(21) - axis.of(20) - 1) < 1e-9);
  for (const t of [0, 0.5, 9, 12, 20, 20.5, 25, 30, 31]) assert.ok(Math.abs(axis.back(axis.of(t)) - t) < 1e-9, `${t}`);
});

test('two runs: counterparts lie as far behind the inputs they have in common', () => {
  const kinds = ['run', 'input', 'transition', 'utterance'];
  const own = run({kinds, t: [0, 1, 1, 5, 5], kind: [0, 1, 2, 1, 2], cause: [-1, -1, 1, -1, 3]});
  const other = run({kinds, t: [0, 2, 2, 2, 7, 7], kind: [0, 1, 2, 3, 1, 2], cause: [-1, -1, 1, 2, -1, 4]});
  const told = {
    differences: [{kind: 'happened', t: 2, a: [], b: [{n: 3, t: 2, kind: 'utterance', brief: ''}]}],
    first: 0,
    pairs: [
      [1, 1],
      [3, 4],
    ],
  };
  const comparison = new Comparison(own, {data: other}, told);
  assert.deepEqual(
    [0, 1, 2, 3, 4].map((n) => comparison.toOther(n)),
    [0, 1, 2, 4, 5],
  );
  assert.equal(comparison.toOwn(5), 4);
  assert.ok(comparison.toOwn(3) <= 2, 'what only the other has is where it would be');
  assert.ok(comparison.marked('b', 3) && !comparison.marked('a', 3));
  assert.equal(comparison.timeToOwn(7), 5);
  assert.equal(comparison.timeToOther(3), 4.5);
  const n = comparison.recordOf(0);
  assert.equal(comparison.otherOf({n, hunk: 0}), 3, 'a selected difference shows its own records');
});

const graph = {
  start: 'Wait',
  states: ['Wait', 'AskWhichBlock', 'Act', 'End', 'Never'].map((id) => ({
    id,
    accepting: id === 'End',
    visits: id === 'Never' ? 0 : 2,
  })),
  edges: [
    {id: 'a', from: 'Wait', to: 'AskWhichBlock', visits: 2},
    {id: 'b', from: 'Wait', to: 'AskWhichBlock', visits: 1},
    {id: 'c', from: 'AskWhichBlock', to: 'AskWhichBlock', visits: 4},
    {id: 'd', from: 'AskWhichBlock', to: 'Act', visits: 2},
    {id: 'e', from: 'Act', to: 'Never', visits: 0},
    ...['Wait', 'AskWhichBlock', 'Act', 'End'].map((from) => ({id: 'q', from, to: 'End', visits: 0})),
  ],
};

test('parallel edges are one; what was never taken can be left out; a way from everywhere is a mark', () => {
  const taken = mergedGraph(graph, true);
  assert.deepEqual(
    taken.nodes.map((node) => node.id),
    ['Wait', 'AskWhichBlock', 'Act'],
  );
  assert.deepEqual(
    taken.edges.map((edge) => edge.visits),
    [3, 4, 2],
  );
  const all = mergedGraph(graph, false);
  assert.equal(all.nodes.length, 5);
  assert.ok(all.nodes.find((node) => node.id === 'End').anywhere);
  assert.ok(!all.edges.some((edge) => edge.to === 'End'));
});

test('two graphs in one: what each took, and what only one has', () => {
  const other = structuredClone(graph);
  other.states.push({id: 'New', accepting: false, visits: 1});
  other.edges.find(({id}) => id === 'd').visits = 0;
  other.edges.push({id: 'n', from: 'AskWhichBlock', to: 'New', visits: 1});
  const {nodes, edges} = mergedGraph(graph, true, other);
  assert.deepEqual(
    nodes.map((node) => node.id),
    ['Wait', 'AskWhichBlock', 'Act', 'New'],
  );
  assert.deepEqual(
    edges.map((edge) => [edge.visits, edge.visits_b]),
    [
      [3, 3],
      [4, 4],
      [2, 0],
      [0, 1],
    ],
  );
});

test('places do not depend on what was taken: a machine looks the same in every run', () => {
  const other = structuredClone(graph);
  for (const edge of other.edges) edge.visits = edge.from === 'Wait' ? 0 : 7;
  const places = (one) =>
    layOut(mergedGraph(one, false), {width: 600, height: 400})
      .nodes.filter(({id}) => id !== 'End')
      .map(({id, x, y}) => ({id, x, y}));
  other.edges = other.edges.map((edge) => (edge.id === 'q' ? {...edge, visits: 0} : edge));
  assert.deepEqual(places(graph), places(other));
});

test('without libraries, nodes still do not overlap', () => {
  const {nodes, width, height} = layOut(mergedGraph(graph, false), {width: 800, height: 400});
  for (const a of nodes) {
    assert.ok(a.x - a.w / 2 >= 0 && a.x + a.w / 2 <= width && a.y - a.h / 2 >= 0 && a.y + a.h / 2 <= height);
    for (const b of nodes)
      assert.ok(
        a === b || Math.abs(a.x - b.x) >= (a.w + b.w) / 2 || Math.abs(a.y - b.y) >= (a.h + b.h) / 2,
        `${a.id} on ${b.id}`,
      );
  }
});

test('an empty graph is laid out too', () => {
  assert.equal(layOut(mergedGraph({start: '', states: [], edges: []}, true), {width: 1, height: 1}).nodes.length, 0);
});

test('labels break between words', () => {
  assert.deepEqual(labelLines('ComposeObjectAndAction'), ['Compose', 'ObjectAnd', 'Action']);
  assert.deepEqual(labelLines('Wait'), ['Wait']);
  assert.deepEqual(labelLines('first half of_it'), ['first half', 'of it']);
});
