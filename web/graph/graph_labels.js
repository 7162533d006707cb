// Places for the counts on the graph's arrows: none covers a state or another count, or is crossed by its arrow. Pure.
import {along, curve} from './graph_paths.js';

const letter_px = 6.6;
const height_px = 12;
const parts = [0.4, 0.5, 0.3, 0.6, 0.25, 0.7, 0.18, 0.8, 0.45, 0.55, 0.35, 0.65, 0.1, 0.9]; // of the way along; less than half first, so that an arrow and its reverse keep apart
const gaps_px = [3, 7, 12]; // between a count and the straight line along its arrow: a bend needs more

const apart = (a, b) => Math.abs(a.x - b.x) * 2 >= a.w + b.w || Math.abs(a.y - b.y) * 2 >= a.h + b.h;

/** The boxes of the states, about their middles, and of the counts that have a place. */
export const boxesOf = ({nodes, edges}, textOf) => [
  ...nodes.map(({x, y, w, h, accepting}) => ({x, y, w: w + (accepting ? 9 : 3), h: h + (accepting ? 9 : 3)})),
  ...nodes.filter(({anywhere}) => anywhere).map(({x, y, h}) => ({x, y: y - h / 2 - 18, w: 84, h: 32})),
  ...edges.filter(({label}) => label).map((edge) => ({...edge.label, ...sizeOf(textOf(edge))})),
];
const sizeOf = (text) => ({w: text.length * letter_px + 4, h: height_px});

/** A place on the way for a box of this size that keeps clear of those `taken`, to which it is added; or null. */
export function freePlace(points, {w, h}, taken) {
  for (const part of parts) {
    const {x, y} = along(points, part);
    const box = {x, y, w, h};
    if (!taken.every((other) => apart(box, other))) continue;
    taken.push(box);
    return {x, y};
  }
  return null;
}

/**
 * Gives each edge with a text a `label` {x, y} for its middle, beside its arrow, or null where there is no room; those
 * used most choose first, and a place that no other arrow crosses is better. `textOf(edge)`: the count as it is shown.
 * @returns the number of those without a place that no arrow crosses
 */
export function placeLabels({nodes, edges, width, height}, textOf) {
  const taken = boxesOf({nodes, edges: []});
  const ways = edges.map(wayOf);
  const order = edges.map((_, i) => i).toSorted((a, b) => useOf(edges[b]) - useOf(edges[a]));
  let misses = 0;
  for (const i of order) {
    edges[i].label = null;
    if (!useOf(edges[i])) continue;
    const free = placesBeside(ways[i].points, sizeOf(textOf(edges[i]))).filter(
      (box) => inside(box, width, height) && taken.every((other) => apart(box, other)) && !crossed(box, ways[i]),
    );
    const alone = free.find((box) => !ways.some((way) => crossed(box, way)));
    if (!alone) ++misses;
    const best = alone ?? free[0];
    if (!best) continue;
    taken.push(best);
    edges[i].label = {x: best.x, y: best.y};
  }
  return misses;
}
const inside = ({x, y, w, h}, width, height) => x >= w / 2 && y >= h / 2 && x + w / 2 <= width && y + h / 2 <= height;
const useOf = ({visits, visits_b}) => visits + visits_b;

// The curve of an arrow as it is drawn, and the box about it.
function wayOf(edge) {
  const points = curve(edge.points, edge.from === edge.to);
  const [left, right] = ends(points.map(({x}) => x));
  const [top, bottom] = ends(points.map(({y}) => y));
  return {points, box: {x: (left + right) / 2, y: (top + bottom) / 2, w: right - left + 1, h: bottom - top + 1}};
}
const ends = (values) => [Math.min(...values), Math.max(...values)];

// Boxes of this size on both sides of the way, the nearest first.
function placesBeside(points, {w, h}) {
  const boxes = [];
  for (const gap of gaps_px)
    for (const part of parts) {
      const [before, at, after] = [part - 0.02, part, part + 0.02].map((where) => along(points, where));
      const length = Math.hypot(after.x - before.x, after.y - before.y) || 1;
      const [nx, ny] = [(after.y - before.y) / length, (before.x - after.x) / length];
      const away = (Math.abs(nx) * w + Math.abs(ny) * h) / 2 + gap;
      for (const side of [away, -away]) boxes.push({x: at.x + nx * side, y: at.y + ny * side, w, h});
    }
  return boxes;
}

// Whether the way runs through the box.
const crossed = (box, {points, box: around}) =>
  !apart(box, around) && points.some((point, i) => i > 0 && meets(points[i - 1], point, box));

// Whether the line from a to b meets the box: the parts of the line within its breadth and within its height overlap.
function meets(a, b, {x, y, w, h}) {
  let from = 0;
  let to = 1;
  for (const [start, way, least, most] of [
    [a.x, b.x - a.x, x - w / 2, x + w / 2],
    [a.y, b.y - a.y, y - h / 2, y + h / 2],
  ]) {
    if (!way) {
      if (start < least || start > most) return false;
      continue;
    }
    const [enters, leaves] = [(least - start) / way, (most - start) / way].toSorted((p, q) => p - q);
    from = Math.max(from, enters);
    to = Math.min(to, leaves);
  }
  return from <= to;
}
