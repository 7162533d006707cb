// What the automaton may be in, where it is in several configurations at once: how they branched, and each of them.
import {h, s, panel, counted} from '../dom.js';
import {lastAtMost} from '../run/run_data.js';

const steps_shown = 12, step_px = 46, row_px = 20, dot_px = 5;

/** Whether the run ever was in several configurations. */
export const hasBranches = (data) => data.count('branches') > 0;

export function mountBranches(app) {
  const {data, client} = app;
  const tree = s('svg', {class: 'branch-tree', role: 'group', 'aria-label': 'How they branched'});
  const table = h('tbody', {});
  const told = h('p', {class: 'muted', 'data-testid': 'branches-told'});
  const body = h('div', {class: 'body', tabindex: 0, role: 'region', 'aria-label': 'Configurations'}, told, h('div', {class: 'branch-scroll'}, tree),
    h('table', {class: 'branch-table', 'data-testid': 'branches'}, h('thead', {}, h('tr', {}, ['Branch', 'from', 'state', 'weight', 'depth', 'by'].map((one) => h('th', {scope: 'col'}, one)))), table));
  const element = panel('branches', 'Branches', null, body);
  let all = null, shown = '';

  const numbers = async () => {
    // Few enough to be asked for at once, and the same for every instant.
    all ??= client.records('branches', 0, 5000).then((records) => records.filter((one) => Array.isArray(one.branches)));
    return all;
  };
  const choose = (id, n) => app.model.go({branch: app.model.selection.branch === id && n === undefined ? null : id, ...n !== undefined && {n}});
  const draw = (records, place, selected) => {
    const now = records[place];
    told.textContent = now ? `${counted(now.branches.length, 'configuration')} since #${now.n}${now.dropped?.length ? `; ${now.dropped.join(', ')} could not go on` : ''}${now.merged ? `; ${now.merged} became one with another` : ''}${now.pruned ? `; ${now.pruned} given up` : ''}.` : 'One configuration.';
    table.replaceChildren(...(now?.branches ?? []).map((one, i) => h('tr', {class: one.id === selected ? 'chosen' : null},
      h('td', {}, h('button', {type: 'button', 'aria-pressed': String(one.id === selected), 'data-testid': 'branch', onclick: () => choose(one.id)}, `${one.id}${i === 0 ? ' (leading)' : ''}`)),
      h('td', {}, one.parent === one.id ? '' : one.parent), h('td', {}, one.state), h('td', {}, h('meter', {min: 0, max: 1, value: one.weight, 'aria-label': `weight of branch ${one.id}`}), ` ${Number(one.weight).toFixed(3)}`),
      h('td', {}, one.depth), h('td', {}, (one.by ?? []).join(', ')))));
    drawTree(records.slice(Math.max(0, place - steps_shown + 3), Math.max(0, place - steps_shown + 3) + steps_shown), now, selected);
  };
  // Time goes right, each branch has a row; a line from where it came from, a cross where it ended.
  const drawTree = (records, now, selected) => {
    const rows = [...new Set(records.flatMap((one) => one.branches.map(({id}) => id)))].sort((a, b) => a - b);
    const x = (i) => 16 + i * step_px, y = (id) => 14 + rows.indexOf(id) * row_px;
    const parts = [];
    records.forEach((record, i) => {
      for (const one of record.branches) {
        if (i > 0 && rows.includes(one.parent)) parts.push(s('path', {class: `way${one.id === selected ? ' chosen' : ''}`, d: `M${x(i - 1)} ${y(one.parent)}C${x(i) - step_px / 2} ${y(one.parent)} ${x(i) - step_px / 2} ${y(one.id)} ${x(i)} ${y(one.id)}`}));
      }
      for (const id of record.dropped ?? []) if (rows.includes(id)) parts.push(s('path', {class: 'ended', d: `M${x(i) - 20} ${y(id) - 4}l8 8m0 -8l-8 8`}, s('title', {}, `${id} could not go on at #${record.n}`)));
      for (const one of record.branches)
        parts.push(s('g', {class: `dot${one.id === selected ? ' chosen' : ''}${record === now ? ' now' : ''}`, role: 'button', tabindex: 0, 'aria-label': `branch ${one.id} in ${one.state} at record ${record.n}`,
          onclick: () => choose(one.id, record.n), onkeydown: (event) => { if (event.key === 'Enter' || event.key === ' ') { event.preventDefault(); event.stopPropagation(); choose(one.id, record.n); } }},
        s('title', {}, `${one.id}: ${one.state}, weight ${Number(one.weight).toFixed(3)}, #${record.n}`), s('circle', {cx: x(i), cy: y(one.id), r: dot_px}), s('text', {x: x(i) + 7, y: y(one.id) - 3}, one.id)));
    });
    tree.replaceChildren(...parts);
    tree.setAttribute('width', x(records.length));
    tree.setAttribute('height', 14 + rows.length * row_px);
  };
  return {
    element,
    /** To the next of the branches at the cursor. */
    async cycle(by) {
      const records = await numbers(), now = records[lastAtMost(records.map(({n}) => n), app.model.selection.n)];
      if (!now) return;
      const ids = now.branches.map(({id}) => id), at = ids.indexOf(app.model.selection.branch);
      app.model.go({branch: ids[(at + by + ids.length) % ids.length]});
    },
    async render({n, branch}) {
      const records = await numbers().catch(() => []), place = lastAtMost(records.map((one) => one.n), n);
      if (shown === `${place} ${branch}`) return;
      shown = `${place} ${branch}`;
      draw(records, place, branch);
    },
  };
}
