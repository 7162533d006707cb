// Places the state graph: parallel edges merged, layers by dagre where it was built in, else by a simple one of ours.
import {dagre} from '../vendor.js';

const letter_px = 6.5;
const line_px = 13;
const anywhere_px = 30; // above a state that every state leads to

/** "ComposeObjectAndAction" in lines of at most about ten letters. */
export function labelLines(id) {
  const lines = [];
  for (const word of id.split(/[\s_-]+/))
    word.split(/(?<=[a-z0-9])(?=[A-Z])/).forEach((part, i) => {
      const joint = i === 0 ? ' ' : '';
      if (lines.length && (lines.at(-1) + joint + part).length <= 10) lines[lines.length - 1] += joint + part;
      else lines.push(part);
    });
  return lines;
}

/**
 * @typedef {{id: string, lines: string[], x: number, y: number, w: number, h: number, visits: number,
 *            accepting: boolean}} Node
 * @typedef {{from: string, to: string, visits: number, rows: object[], points: {x: number, y: number}[]}} Edge
 */

/**
 * Nodes and merged edges of what is to be shown, not yet placed. `taken_only` leaves out what the run never used.
 * `other`: the graph of a run it is compared with, whose visits count in `visits_b`, and what only it has is there too.
 */
export function mergedGraph(graph, taken_only, other = null) {
  const rows = withOther(graph, other);
  const used_by = (row) => row.visits + (row.visits_b ?? 0);
  const edges = new Map();
  // A transition that leaves most states would bury the rest: it is told by a mark on its target, drawn where taken.
  const sources = new Map();
  for (const row of rows) sources.set(row.id, (sources.get(row.id) ?? 0) + 1);
  const from_anywhere = (row) => graph.states.length > 4 && sources.get(row.id) > graph.states.length / 2;
  const entered_from_anywhere = new Map();
  for (const row of rows) {
    if (!used_by(row) && from_anywhere(row)) entered_from_anywhere.set(row.to, row);
    if (!used_by(row) && (taken_only || from_anywhere(row))) continue;
    const key = JSON.stringify([row.from, row.to]);
    if (!edges.has(key)) edges.set(key, {from: row.from, to: row.to, visits: 0, visits_b: 0, rows: [], points: []});
    const edge = edges.get(key);
    edge.visits += row.visits;
    edge.visits_b += row.visits_b ?? 0;
    edge.rows.push(row);
  }
  const used = new Set([graph.start]);
  for (const edge of edges.values()) used.add(edge.from).add(edge.to);
  const all = other
    ? graph.states.concat(
        other.states.filter(({id}) => !graph.states.some((one) => one.id === id)).map((one) => ({...one, visits: 0})),
      )
    : graph.states;
  const visits_b = new Map(other?.states.map(({id, visits}) => [id, visits]));
  const nodes = all
    .filter((state) => !taken_only || used.has(state.id))
    .map((state) => {
      const lines = labelLines(state.id);
      return {
        id: state.id,
        lines,
        visits: state.visits,
        visits_b: visits_b.get(state.id) ?? 0,
        accepting: state.accepting,
        x: 0,
        y: 0,
        anywhere: taken_only ? null : (entered_from_anywhere.get(state.id) ?? null),
        w: Math.max(44, Math.max(...lines.map((line) => line.length)) * letter_px + 10),
        h: lines.length * line_px + 11,
      };
    });
  const known = new Set(nodes.map((node) => node.id));
  return {nodes, edges: [...edges.values()].filter((edge) => known.has(edge.from) && known.has(edge.to))};
}

// The transitions of both graphs, each with the visits of both.
function withOther(graph, other) {
  if (!other) return graph.edges;
  const key = (row) => JSON.stringify([row.id, row.from, row.to]);
  const rows = new Map(graph.edges.map((row) => [key(row), {...row, visits_b: 0}]));
  for (const row of other.edges) {
    const own = rows.get(key(row));
    if (own) own.visits_b += row.visits;
    else rows.set(key(row), {...row, visits: 0, visits_b: row.visits});
  }
  return [...rows.values()];
}

// The distances between ranks, and between the nodes of one, in pixels: with air, and where that needs too much room.
const airs = [
  {ranks: {LR: 26, TB: 22}, nodes: 14},
  {ranks: {LR: 16, TB: 12}, nodes: 10},
];
// Distances with room for counts beside the arrows, and a number of arrows from which on counts are the lesser part.
const wide_airs = [
  {ranks: {LR: 44, TB: 30}, nodes: 20},
  {ranks: {LR: 64, TB: 40}, nodes: 28},
  {ranks: {LR: 90, TB: 60}, nodes: 44},
];
const many_edges = 40;

/**
 * Places nodes and edges for a panel of this size: with air, if all of it is then in sight, else as dense as can be read.
 * `misses(placed)`: the number of counts that lack room in it; more air is taken where all stays in sight and fewer lack room.
 * @returns {{nodes: Node[], edges: Edge[], width, height}}
 */
export function layOut(merged, room, misses = () => 0) {
  const fit = ({width, height}) => Math.min(room.width / width, room.height / height);
  const each = (air) => ['LR', 'TB'].map((direction) => place(structuredClone(merged), direction, air));
  let best = null;
  for (const air of airs) {
    for (const placed of each(air)) if (!best || fit(placed) > fit(best)) best = placed;
    if (fit(best) >= 1) break;
  }
  let fewest = merged.edges.length > many_edges ? 0 : misses(best);
  for (const air of wide_airs) {
    if (!fewest) break;
    for (const placed of each(air)) {
      const lacking = fit(placed) >= 1 ? misses(placed) : fewest;
      if (lacking < fewest) [best, fewest] = [placed, lacking];
    }
  }
  return best;
}

function place({nodes, edges}, direction, air) {
  const loops = edges.filter((edge) => edge.from === edge.to);
  const others = edges.filter((edge) => edge.from !== edge.to);
  (dagre ? placeByDagre : placeByRank)(nodes, others, direction, air);
  const at = new Map(nodes.map((node) => [node.id, node]));
  for (const edge of others) clip(edge, at);
  for (const loop of loops) {
    const {x, y, w, h} = at.get(loop.from);
    const top = y - h / 2;
    const right = x + w / 2;
    loop.points = [
      {x: right - 20, y: top},
      {x: right - 22, y: top - 17},
      {x: right - 4, y: top - 17},
      {x: right - 6, y: top},
    ];
  }
  return framed(nodes, edges);
}

function placeByDagre(nodes, edges, direction, air) {
  const graph = new dagre.graphlib.Graph();
  // Greedy: as few arrows as can be go back, which keeps the picture small.
  const {ranks, nodes: nodesep} = air;
  graph.setGraph({rankdir: direction, nodesep, ranksep: ranks[direction], edgesep: 8, acyclicer: 'greedy'});
  graph.setDefaultEdgeLabel(() => ({}));
  for (const {id, w, h, anywhere} of nodes) graph.setNode(id, {width: w, height: h + (anywhere ? 2 * anywhere_px : 0)});
  for (const edge of edges) graph.setEdge(edge.from, edge.to, {});
  dagre.layout(graph);
  for (const node of nodes) ({x: node.x, y: node.y} = graph.node(node.id));
  for (const edge of edges) edge.points = graph.edge(edge.from, edge.to).points.map(({x, y}) => ({x, y}));
}

// Layers by distance from the first node; within a layer, in order of the neighbours' places in the one before.
function placeByRank(nodes, edges, direction) {
  const rank = new Map(nodes.length ? [[nodes[0].id, 0]] : []);
  const open = [...rank.keys()];
  const visit = () => {
    while (open.length) {
      const id = open.shift();
      for (const edge of edges)
        if (edge.from === id && !rank.has(edge.to)) {
          rank.set(edge.to, rank.get(id) + 1);
          open.push(edge.to);
        }
    }
  };
  visit();
  for (const node of nodes)
    if (!rank.has(node.id)) {
      rank.set(node.id, 0);
      open.push(node.id);
      visit();
    }
  const layers = [];
  for (const node of nodes) (layers[rank.get(node.id)] ??= []).push(node);
  const order = new Map();
  let along = 0;
  for (const layer of layers.filter(Boolean)) {
    const pull = (node) => {
      const places = edges.filter((e) => e.to === node.id && order.has(e.from)).map((e) => order.get(e.from));
      return places.length ? places.reduce((a, b) => a + b) / places.length : 0;
    };
    layer.sort((a, b) => pull(a) - pull(b));
    const thick = Math.max(...layer.map((node) => (direction === 'LR' ? node.w : node.h)));
    const breadth = (node) => (direction === 'LR' ? node.h : node.w) + 18;
    let across = -layer.reduce((sum, node) => sum + breadth(node), 0) / 2;
    for (const node of layer) {
      const middle = across + breadth(node) / 2;
      [node.x, node.y] = direction === 'LR' ? [along + thick / 2, middle] : [middle, along + thick / 2];
      order.set(node.id, middle);
      across += breadth(node);
    }
    along += thick + 46;
  }
  const at = new Map(nodes.map((node) => [node.id, node]));
  for (const edge of edges) {
    const a = at.get(edge.from);
    const b = at.get(edge.to);
    const bend = {x: (a.x + b.x) / 2 + (b.y - a.y) * 0.12, y: (a.y + b.y) / 2 - (b.x - a.x) * 0.12};
    edge.points = [{x: a.x, y: a.y}, bend, {x: b.x, y: b.y}];
  }
}

// Ends an edge at the borders of its nodes.
function clip(edge, at) {
  const points = edge.points;
  points[0] = border(at.get(edge.from), points[1]);
  points[points.length - 1] = border(at.get(edge.to), points[points.length - 2]);
}

function border(node, toward) {
  const dx = toward.x - node.x;
  const dy = toward.y - node.y;
  if (!dx && !dy) return {x: node.x, y: node.y};
  const scale = Math.min(dx ? node.w / 2 / Math.abs(dx) : Infinity, dy ? node.h / 2 / Math.abs(dy) : Infinity);
  return {x: node.x + dx * scale, y: node.y + dy * scale};
}

// Moves everything into a frame that begins at 0,0.
function framed(nodes, edges) {
  const margin = 14;
  let left = Infinity;
  let top = Infinity;
  let right = -Infinity;
  let bottom = -Infinity;
  const reach = (x, y) => {
    left = Math.min(left, x);
    right = Math.max(right, x);
    top = Math.min(top, y);
    bottom = Math.max(bottom, y);
  };
  for (const {x, y, w, h, anywhere} of nodes) {
    reach(x - w / 2, y - h / 2 - (anywhere ? anywhere_px : 12));
    reach(x + w / 2, y + h / 2);
  }
  for (const {points} of edges) for (const {x, y} of points) reach(x, y);
  if (!nodes.length) reach(0, 0);
  for (const item of [...nodes, ...edges.flatMap((edge) => edge.points)]) {
    item.x += margin - left;
    item.y += margin - top;
  }
  return {nodes, edges, width: right - left + 2 * margin, height: bottom - top + 2 * margin};
}
