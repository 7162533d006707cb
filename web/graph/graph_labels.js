// Places for the counts on the graph's arrows: none covers a state or another count. Pure.
import {along} from './graph_paths.js';

const letter_px = 6.2;
const height_px = 12;
const parts = [0.4, 0.5, 0.3, 0.6, 0.25, 0.7, 0.18, 0.8, 0.45, 0.55, 0.35, 0.65, 0.1, 0.9]; // of the way along; less than half first, so that an arrow and its reverse keep apart

const apart = (a, b) => Math.abs(a.x - b.x) * 2 >= a.w + b.w || Math.abs(a.y - b.y) * 2 >= a.h + b.h;

/** The boxes of the states, about their middles, and of the counts that have a place. */
export const boxesOf = ({nodes, edges}, textOf) => [
  ...nodes.map(({x, y, w, h}) => ({x, y, w: w + 2, h: h + 2})),
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
 * Gives each edge with a text a `label` {x, y} for its middle, or null where there is no room; those used most choose
 * first. `textOf(edge)`: the count as it is shown.
 */
export function placeLabels({nodes, edges}, textOf) {
  const taken = boxesOf({nodes, edges: []});
  for (const edge of edges.toSorted((a, b) => b.visits + b.visits_b - a.visits - a.visits_b)) {
    const used = edge.visits + edge.visits_b > 0;
    const way = edge.from === edge.to ? overLoop(edge.points) : edge.points;
    edge.label = used ? freePlace(way, sizeOf(textOf(edge)), taken) : null;
  }
}
const overLoop = ([, b, c]) => [
  {x: b.x, y: b.y - 2},
  {x: c.x, y: c.y - 2},
];
