// The parts of the state graph as elements: arrows, states, and the arrows of refused transitions.
import {pressable, s, shown, counted} from '../dom.js';
import {arrowHead, bent, curve, loopPath, path} from './graph_paths.js';
import {freePlace} from './graph_labels.js';

const badge_px = 8; // radius of the number on a refused transition

/** A transition in words. */
export const rowText = (row) =>
  `${row.id}: ${row.input ?? 'ε'}${row.condition ? `, ${shown(row.condition)}` : ''} / ${shown(row.operation)}` +
  (row.diverted ? ', turned away by a gate' : '') +
  (row.visits ? `, ${counted(row.visits, 'time')}` : ', never taken');

// In a comparison, the class of a part that only one of the two runs took.
function whose({visits, visits_b}, compared) {
  if (!compared || Boolean(visits) === Boolean(visits_b)) return '';
  return visits ? ' only-a' : ' only-b';
}
/** The count of an arrow's uses as it is shown. */
export const visitsText = ({visits, visits_b}, compared) =>
  !compared || visits === visits_b ? `${visits}` : `A ${visits} B ${visits_b}`;

const word = (props, ...text) => s('text', {'text-anchor': 'middle', ...props}, ...text);

/**
 * An arrow with all transitions between two states. `compared`: two runs are shown; `tell()`: it was pressed; `over(is)`:
 * the pointer has come over it, or left it.
 */
export function drawEdge(edge, {compared, tell, over}) {
  const {from, to, points, rows} = edge;
  const loop = from === to;
  const d = loop ? loopPath(points) : path(points);
  const used = edge.visits + edge.visits_b;
  const width = used ? 1.1 + Math.min(5, Math.log10(used) * 1.5) : 0.8;
  const visits = visitsText(edge, compared);
  const diverted = rows.every((row) => row.diverted) ? ' diverted' : '';
  const group = s(
    'g',
    {
      class: `edge ${used ? 'taken' : 'never'}${whose(edge, compared)}${diverted}`,
      'data-edge': nameOf(edge),
      role: 'button',
      tabindex: used ? 0 : -1,
      'aria-label': `${from} to ${to}, taken ${visits} times; its transitions`,
    },
    s('path', {class: 'hit', d}),
    s('path', {class: 'stroke', d, 'stroke-width': width}),
    s('path', {class: 'head', d: arrowHead(points)}),
  );
  hoverable(group, over);
  return pressable(group, tell);
}
function hoverable(group, over) {
  group.addEventListener('pointerenter', () => over(true));
  group.addEventListener('pointerleave', () => over(false));
}

/** The count of an arrow's uses, where there is room for it. */
export const drawCount = (edge, compared) =>
  edge.label &&
  word({class: 'count', 'data-edge': nameOf(edge), x: edge.label.x, y: edge.label.y + 4}, visitsText(edge, compared));
const nameOf = ({from, to}) => `${from} → ${to}`;

/** A state. `begins`: the automaton starts in it; `jump()`: it was pressed. */
export function drawNode(node, {compared, begins, jump, over}) {
  const {id, x, y, w, h, lines, visits} = node;
  const left = x - w / 2;
  const top = y - h / 2;
  const first_line = y - (lines.length - 1) * 6.5 + 4;
  const entered = `entered ${counted(visits, 'time')}`;
  const group = s(
    'g',
    {
      class: `node ${visits || node.visits_b || begins ? 'taken' : 'never'}${whose(node, compared)}`,
      role: visits ? 'button' : 'img',
      tabindex: visits ? 0 : null,
      'data-state': id,
      'aria-label': `State ${id}, ${entered}${visits ? '; go to the next' : ''}`,
    },
    node.accepting && s('rect', {class: 'outer', x: left - 3, y: top - 3, width: w + 6, height: h + 6, rx: 10}),
    s('rect', {class: 'box', x: left, y: top, width: w, height: h, rx: 8}),
    lines.map((line, i) => word({x, y: first_line + i * 13}, id.includes(`${line} `) ? `${line} ` : line)),
    node.anywhere && fromAnywhere(node.anywhere, x, top),
    begins && s('path', {class: 'begin', d: `M${left - 9} ${y - 5}l8 5l-8 5z`}),
  );
  hoverable(group, over);
  return pressable(group, jump);
}

// The arrow of a transition that every state has, above its target.
const fromAnywhere = (row, x, top) =>
  s(
    'g',
    {class: 'edge never'},
    s('title', {}, `from any state\n${rowText(row)}`),
    s('path', {class: 'stroke', d: `M${x} ${top - 20}v14`}),
    s('path', {class: 'head', d: `M${x} ${top - 2}l-3.5 -6h7z`}),
    word({class: 'count', x, y: top - 23}, 'from any state'),
  );

/**
 * The arrow from node `a` to node `b` of the transitions `refused` there, each with its `number` in the list; `i`: how many
 * such arrows there are already. The badge with the numbers keeps clear of the boxes `taken`, to which it is added; where there is no
 * room there is none.
 */
export function drawRefused(a, b, refused, i, taken) {
  const loop = a === b;
  const points = loop ? loopBelow(a) : bent(a, b, 0.22 + 0.05 * i);
  const numbers = refused.map((one) => one.number).join(', ');
  const size = {w: Math.max(2 * badge_px, numbers.length * 6 + 8), h: 2 * badge_px};
  const at = freePlace(loop ? [points[1], points[2]] : curve(points, false), size, taken);
  const reasons = refused.map((one) => `${one.id}, ${shown(one.reason)}`);
  return s(
    'g',
    {class: 'edge refused', role: 'img', 'aria-label': `refused: ${a.id} to ${b.id}, ${reasons.join('; ')}`},
    s('title', {}, refused.map((one) => `${one.number}. ${one.id} refused: ${shown(one.reason)}`).join('\n')),
    s('path', {class: 'stroke', d: loop ? loopPath(points) : path(points)}),
    s('path', {class: 'head', d: arrowHead(points)}),
    at && badge(at, size, numbers),
  );
}
const badge = ({x, y}, {w, h}, text) => [
  s('rect', {class: 'badge-back', x: x - w / 2, y: y - h / 2, width: w, height: h, rx: badge_px}),
  word({class: 'count', x, y: y + 4}, text),
];

function loopBelow({x, y, w, h}) {
  const left = x - w / 2;
  const bottom = y + h / 2;
  return [
    {x: left + 4, y: bottom},
    {x: left - 4, y: bottom + 20},
    {x: left + 24, y: bottom + 20},
    {x: left + 22, y: bottom},
  ];
}
