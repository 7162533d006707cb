// The parts of the state graph as elements: arrows, states, and the arrows of refused transitions.
import {pressable, s, shown, brief, counted} from '../dom.js';
import {along, arrowHead, bent, loopPath, path} from './graph_paths.js';

const most_letters = 26; // of a value next to an arrow

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
const visitsText = ({visits, visits_b}, compared) =>
  !compared || visits === visits_b ? `${visits}` : `A ${visits} B ${visits_b}`;

const word = (props, ...text) => s('text', {'text-anchor': 'middle', ...props}, ...text);

/** An arrow with all transitions between two states. `compared`: two runs are shown; `tell()`: it was pressed. */
export function drawEdge(edge, {compared, tell}) {
  const {from, to, points, rows} = edge;
  const loop = from === to;
  const d = loop ? loopPath(points) : path(points);
  const middle = loop ? {x: points[2].x + 4, y: points[1].y + 6} : along(points, 0.4);
  const used = edge.visits + edge.visits_b;
  const width = used ? 1.2 + Math.min(3, Math.log10(used) * 1.1) : 0.8;
  const visits = visitsText(edge, compared);
  const count = {class: 'count', x: middle.x, y: middle.y + 3, 'text-anchor': loop ? 'start' : 'middle'};
  const diverted = rows.every((row) => row.diverted) ? ' diverted' : '';
  const group = s(
    'g',
    {
      class: `edge ${used ? 'taken' : 'never'}${whose(edge, compared)}${diverted}`,
      role: 'button',
      tabindex: used ? 0 : -1,
      'aria-label': `${from} to ${to}, taken ${visits} times; its transitions`,
    },
    s('title', {}, `${from} → ${to}\n${rows.map(rowText).join('\n')}`),
    s('path', {class: 'hit', d}),
    s('path', {class: 'stroke', d, 'stroke-width': width}),
    s('path', {class: 'head', d: arrowHead(points)}),
    used > 0 && s('text', count, visits),
  );
  return pressable(group, tell);
}

/** A state. `begins`: the automaton starts in it; `jump()`: it was pressed. */
export function drawNode(node, {compared, begins, jump}) {
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
    s('title', {}, `${id}: ${entered}`),
    node.accepting && s('rect', {class: 'outer', x: left - 3, y: top - 3, width: w + 6, height: h + 6, rx: 10}),
    s('rect', {class: 'box', x: left, y: top, width: w, height: h, rx: 8}),
    lines.map((line, i) => word({x, y: first_line + i * 13}, line)),
    node.anywhere && fromAnywhere(node.anywhere, x, top),
    begins && s('path', {class: 'begin', d: `M${left - 9} ${y - 5}l8 5l-8 5z`}),
  );
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

/** The value in "|options| > 1: |options| is 1"; all of a reason that has none. */
function valueOf(reason) {
  const text = brief(String(reason ?? ''));
  const at = text.lastIndexOf(': ');
  const value = at < 0 ? text : text.slice(at + 2);
  return value.length > most_letters ? `${value.slice(0, most_letters - 1)}…` : value;
}

/** The arrow from node `a` to node `b` of the transitions `refused` there; `i`: how many such arrows there are already. */
export function drawRefused(a, b, refused, i) {
  const loop = a === b;
  const points = loop ? loopBelow(a) : bent(a, b, 0.22 + 0.05 * i);
  const middle = loop ? {x: points[1].x + 12, y: points[1].y + 9} : middleOf(points);
  const [first] = refused;
  const more = refused.length > 1 ? `, and ${refused.length - 1} more` : '';
  const reasons = refused.map((one) => `${one.id}, ${shown(one.reason)}`);
  return s(
    'g',
    {class: 'edge refused', role: 'img', 'aria-label': `refused: ${a.id} to ${b.id}, ${reasons.join('; ')}`},
    s('title', {}, refused.map((one) => `${one.id} refused: ${shown(one.reason)}`).join('\n')),
    s('path', {class: 'stroke', d: loop ? loopPath(points) : path(points)}),
    s('path', {class: 'head', d: arrowHead(points)}),
    word({class: 'count', x: middle.x, y: middle.y + 3}, `${first.id}: ${valueOf(first.reason)}${more}`),
  );
}

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
const middleOf = ([from, control, to]) => ({
  x: (from.x + 2 * control.x + to.x) / 4,
  y: (from.y + 2 * control.y + to.y) / 4,
});
