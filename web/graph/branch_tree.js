// How the configurations of an automaton branched, as a picture: time goes right, each branch has a row.
import {pressable, s} from '../dom.js';

const step_px = 46;
const row_px = 20;
const left_px = 16;
const top_px = 14;
const dot_px = 5;

/**
 * `records`: of the kind `branches`, in order; `now`: the one at the cursor; `selected`: a branch or null;
 * `choose(branch, n)`: a dot was pressed.
 */
export function branchTree(records, {now, selected, choose}) {
  const rows = [...new Set(records.flatMap((one) => one.branches.map(({id}) => id)))].sort((a, b) => a - b);
  const x = (i) => left_px + i * step_px;
  const y = (id) => top_px + rows.indexOf(id) * row_px;
  const marked = (id) => (id === selected ? ' chosen' : '');

  // From the branch that it came from to the branch, across one step.
  function way({id, parent}, i) {
    if (i === 0 || !rows.includes(parent)) return null;
    const middle = x(i) - step_px / 2;
    const d = `M${x(i - 1)} ${y(parent)}C${middle} ${y(parent)} ${middle} ${y(id)} ${x(i)} ${y(id)}`;
    return s('path', {class: `way${marked(id)}`, d});
  }
  function end(id, i, n) {
    if (!rows.includes(id)) return null;
    const title = s('title', {}, `${id} could not go on at #${n}`);
    return s('path', {class: 'ended', d: `M${x(i) - 20} ${y(id) - 4}l8 8m0 -8l-8 8`}, title);
  }
  function dot({id, state, weight}, i, record) {
    const group = s(
      'g',
      {
        class: `dot${marked(id)}${record === now ? ' now' : ''}`,
        role: 'button',
        tabindex: 0,
        'aria-label': `branch ${id} in ${state} at record ${record.n}`,
      },
      s('title', {}, `${id}: ${state}, weight ${Number(weight).toFixed(3)}, #${record.n}`),
      s('circle', {cx: x(i), cy: y(id), r: dot_px}),
      s('text', {x: x(i) + 7, y: y(id) - 3}, id),
    );
    return pressable(group, () => choose(id, record.n));
  }

  return s(
    'svg',
    {
      class: 'branch-tree',
      role: 'group',
      'aria-label': 'How they branched',
      width: x(records.length),
      height: top_px + rows.length * row_px,
    },
    records.map((record, i) => [
      record.branches.map((one) => way(one, i)),
      (record.dropped ?? []).map((id) => end(id, i, record.n)),
      record.branches.map((one) => dot(one, i, record)),
    ]),
  );
}
