// The live page's knowledge of a scene besides its poses: the table's edges, the objects on it with their sizes, and
// examples of sentences about them. Metres, frame W. Pure.
import {readMjcf} from '../scene3d/scene_text.js';

const usual_table = {left: -0.5, right: 0.5, near: -0.3, far: 0.3};
const round_types = ['cylinder', 'sphere', 'ellipsoid', 'capsule'];

/** {table, objects: [name], titles: Map of name to what it is called, outlines: Map of name to that of outlineOf(), hand: body or null, examples} */
export function readTable(scene) {
  const geoms = Array.isArray(scene?.geoms) ? scene.geoms : [];
  const {objects, grip} = readMjcf(
    scene?.mjcf,
    [...new Set(geoms.map((geom) => geom?.body))].filter((name) => typeof name === 'string'),
  );
  const ofBody = (name) => geoms.filter((geom) => geom.body === name);
  const titles = titlesOf(scene?.mjcf, objects);
  return {
    objects,
    titles,
    hand: grip?.body ?? null,
    table: tableOf(ofBody('table'), scene?.bodies?.table),
    outlines: new Map(objects.map((name) => [name, outlineOf(ofBody(name))])),
    examples: examplesOf([...titles.values()]),
  };
}

// Sentences about the first things of the scene.
function examplesOf([one, other]) {
  if (!one) return [];
  const about_two = other ? [`Put the ${one} next to the ${other}.`] : [];
  return [`The ${one}.`, `Lift the ${one}.`, ...about_two, `Where is the ${one}?`];
}

function tableOf(geoms, pose = [0, 0, 0]) {
  const top = geoms.filter(({type}) => type === 'box').sort((a, b) => b.pos[2] + b.size[2] - a.pos[2] - a.size[2])[0];
  if (!top) return usual_table;
  const x = pose[0] + top.pos[0];
  const y = pose[1] + top.pos[1];
  return {left: x - top.size[0], right: x + top.size[0], near: y - top.size[1], far: y + top.size[1]};
}

/** Seen from above: half sizes, and whether it is round. */
function outlineOf(geoms) {
  let left = Infinity;
  let right = -Infinity;
  let near = Infinity;
  let far = -Infinity;
  for (const {type, size, pos} of geoms) {
    const [x, y] = type === 'box' || type === 'ellipsoid' ? size : [size[0] || 0.02, size[0] || 0.02];
    left = Math.min(left, pos[0] - x);
    right = Math.max(right, pos[0] + x);
    near = Math.min(near, pos[1] - y);
    far = Math.max(far, pos[1] + y);
  }
  if (!geoms.length) [left, right, near, far] = [-0.02, 0.02, -0.02, 0.02];
  return {
    round: geoms.some(({type}) => round_types.includes(type)),
    left,
    right,
    near,
    far,
    colour: (geoms[0]?.rgba ?? [0.5, 0.5, 0.5]).slice(0, 3).map((part) => Math.round(255 * part)),
  };
}

const onTable = ({left, right, near, far}, [x, y]) => x >= left && x <= right && y >= near && y <= far;
const tenth_mm = (x) => Math.round(x * 1e4) / 1e4;
/** The point as it is sent; null beside the table. */
export const targetOf = (table, point) => (point && onTable(table, point) ? point.slice(0, 2).map(tenth_mm) : null);
export const clipped = ({left, right, near, far}, [x, y]) => [
  tenth_mm(Math.max(left, Math.min(right, x))),
  tenth_mm(Math.max(near, Math.min(far, y))),
];

/** "cup", "blue cup": a name that is a word as it is, else colour and type as the scene tells them. */
function titlesOf(mjcf, objects) {
  const told = new Map(
    [...(mjcf ?? '').matchAll(/<text name="([^"]+)" data="type=(\w+)(?: color=(\w+))?"/g)].map(
      ([, name, type, colour]) => [name, [colour, type].filter(Boolean).join(' ')],
    ),
  );
  return new Map(
    objects.map((name) => [name, /^[a-z]+$/.test(name) ? name : (told.get(name) ?? name.replaceAll('_', ' '))]),
  );
}
