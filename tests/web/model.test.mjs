// The page's logic without a page: addresses, stops, states over time, layout without libraries.
import assert from 'node:assert/strict';
import {mkdtempSync, copyFileSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';
import {test} from 'node:test';

const web = join(dirname(fileURLToPath(import.meta.url)), '../../web');
// The modules beside a vendor.js as it is built without libraries.
const folder = mkdtempSync(join(tmpdir(), 'continua-web-'));
for (const name of ['model.js', 'run_data.js', 'graph_layout.js']) copyFileSync(join(web, name), join(folder, name));
writeFileSync(join(folder, 'vendor.js'), 'export const dagre = null;\n');
writeFileSync(join(folder, 'package.json'), '{"type": "module"}');
const load = (name) => import(pathToFileURL(join(folder, name)));
const {parseAddress, formatAddress} = await load('model.js');
const {RunData, lastAtMost} = await load('run_data.js');
const {mergedGraph, layOut, labelLines} = await load('graph_layout.js');

test('an address and what it says are the same thing', () => {
  const all = {run: 'a b', n: 137, zoom: [11.9, 13.1], filter: 'put( λ', kind: 'act'};
  assert.deepEqual(parseAddress(formatAddress(all)), all);
  assert.equal(formatAddress({...all, filter: '', kind: ''}), '/r/a%20b?n=137&z=11.9..13.1');
  assert.equal(formatAddress(parseAddress('/')), '/');
});

test('what an address says wrongly is left open', () => {
  assert.deepEqual(parseAddress('/r/x?n=-3&z=5..2&other=1'), {run: 'x', n: null, zoom: null, filter: '', kind: ''});
  assert.equal(parseAddress('/r/x?n=abc').n, null);
  assert.equal(parseAddress('/elsewhere').run, null);
});

test('the last element that is at most a value', () => {
  assert.equal(lastAtMost([], 1), -1);
  assert.equal(lastAtMost([1, 2, 2, 3], 2), 2);
  assert.equal(lastAtMost([1, 2, 2, 3], 0.5), -1);
  assert.equal(lastAtMost([1, 2, 2, 3], 9), 3);
});

const data = new RunData({
  summary: {}, graph: {start: 'A', states: [], edges: []},
  lanes: {kinds: ['run', 'transition'], kind: [0, 1, 1, 1, 1, 1], cause: [-1, 0, 1, 0, 3, 2], label: ['', '', '', '', '', ''],
          t: [0, 1, 1, 4, 3.5, 6], interest: [1, 3, 5], transitions: {n: [1, 2, 5], to: ['B', 'A', 'C'], from: ['A', 'B', 'A'], depth: [2, 1, 3]}},
});

test('steps go from stop to stop, also from between them, and stay inside the run', () => {
  assert.equal(data.stop([1, 3, 5], 3, 1), 5);
  assert.equal(data.stop([1, 3, 5], 4, 1), 5);
  assert.equal(data.stop([1, 3, 5], 4, -1), 3);
  assert.equal(data.stop([1, 3, 5], 0, -1), 1);
  assert.equal(data.stop([1, 3, 5], 1, 10), 5);
});

test('states last until the next transition; those without length are left out', () => {
  assert.deepEqual(data.segments.map(({state, from, to}) => [state, from, to]), [['A', 0, 6]]);
  assert.equal(data.state(0), 'A');
  assert.equal(data.state(1), 'B');
  assert.equal(data.state(4), 'A');
  assert.equal(data.depth(5), 3);
});

test('a time between records, and times out of order, find the last record reached', () => {
  assert.equal(data.at(0.5), 0);
  assert.equal(data.at(1), 2);
  assert.equal(data.at(4), 4);
  assert.equal(data.at(99), 5);
});

test('effects are the records that name this one as their cause', () => {
  assert.deepEqual(data.effects(0), [1, 3]);
});

const graph = {
  start: 'Wait',
  states: ['Wait', 'AskWhichBlock', 'Act', 'End', 'Never'].map((id) => ({id, accepting: id === 'End', visits: id === 'Never' ? 0 : 2})),
  edges: [
    {id: 'a', from: 'Wait', to: 'AskWhichBlock', visits: 2}, {id: 'b', from: 'Wait', to: 'AskWhichBlock', visits: 1},
    {id: 'c', from: 'AskWhichBlock', to: 'AskWhichBlock', visits: 4}, {id: 'd', from: 'AskWhichBlock', to: 'Act', visits: 2},
    {id: 'e', from: 'Act', to: 'Never', visits: 0}, ...['Wait', 'AskWhichBlock', 'Act', 'End'].map((from) => ({id: 'q', from, to: 'End', visits: 0})),
  ],
};

test('parallel edges are one; what was never taken can be left out; a way from everywhere is a mark', () => {
  const taken = mergedGraph(graph, true);
  assert.deepEqual(taken.nodes.map((node) => node.id), ['Wait', 'AskWhichBlock', 'Act']);
  assert.deepEqual(taken.edges.map((edge) => edge.visits), [3, 4, 2]);
  const all = mergedGraph(graph, false);
  assert.equal(all.nodes.length, 5);
  assert.ok(all.nodes.find((node) => node.id === 'End').anywhere);
  assert.ok(!all.edges.some((edge) => edge.to === 'End'));
});

test('without libraries, nodes still do not overlap', () => {
  const {nodes, width, height} = layOut(mergedGraph(graph, false), 2);
  for (const a of nodes) {
    assert.ok(a.x - a.w / 2 >= 0 && a.x + a.w / 2 <= width && a.y - a.h / 2 >= 0 && a.y + a.h / 2 <= height);
    for (const b of nodes)
      assert.ok(a === b || Math.abs(a.x - b.x) >= (a.w + b.w) / 2 || Math.abs(a.y - b.y) >= (a.h + b.h) / 2, `${a.id} on ${b.id}`);
  }
});

test('an empty graph is laid out too', () => {
  assert.equal(layOut(mergedGraph({start: '', states: [], edges: []}, true), 1).nodes.length, 0);
});

test('labels break between words', () => {
  assert.deepEqual(labelLines('ComposeObjectAndAction'), ['Compose', 'ObjectAnd', 'Action']);
  assert.deepEqual(labelLines('Wait'), ['Wait']);
});
