// The stack at the cursor, top first: before and after its last change, and of each cell since when, from what, read by whom.
import {h, panel, brief, text, counted} from '../dom.js';
import {Latest} from '../terms/latest.js';
import {CellTracker, keyOf, slotOf} from '../terms/cells.js';
import {age, operationWords, stackRows} from '../terms/stack_words.js';

const sign = {added: '+', removed: '−', changed: '~', same: ''};
const spoken = {added: 'added', removed: 'removed', changed: 'changed', same: 'unchanged'};
const slotsOf = (symbol) => (symbol?.slots && typeof symbol.slots === 'object' ? symbol.slots : {});
const valueText = (value) => brief(text(value));

export function mountStack(app) {
  const body = h('div', {class: 'symbols', tabindex: 0, role: 'region', 'aria-label': 'Symbols, top first'});
  const depth = h('span', {class: 'muted', 'data-testid': 'depth'});
  const line = h('p', {class: 'cell-line', 'data-testid': 'cell-line', role: 'status', hidden: true});
  const tracker = new CellTracker();
  let told = null, cells = [], selected = null, unfolded = false;

  const jump = (n, words, more) => h('button', {type: 'button', class: 'link', onclick: () => app.jump(n), ...more}, words ?? `#${n}`);
  const changeOf = (was, now) => (was === undefined || was === null ? 'added' : now === undefined || now === null ? 'removed' : JSON.stringify(was) === JSON.stringify(now) ? 'same' : 'changed');

  // A cell as it is after the change, with what it was where that is not beside it.
  const cell = (symbol, slot, was, now, marks) => {
    const known = cells.find((one) => one.symbol === symbol.id && one.slot === slot);
    const change = marks ? changeOf(was, now) : 'same';
    const values = [change !== 'same' && was !== undefined && was !== null && h('del', {}, valueText(was)), ' ',
      now !== undefined && now !== null && h('span', {class: 'now'}, valueText(now))];
    const named = [h('span', {class: 'name'}, sign[change] && h('span', {class: 'sign'}, sign[change]), change !== 'same' && h('span', {class: 'unseen'}, `${spoken[change]} `), slot), h('span', {class: 'value'}, values)];
    return h('li', {class: `cell ${change}`},
      now === undefined || now === null || !known
        ? h('div', {class: 'pair'}, named)
        : h('button', {type: 'button', class: 'pair', 'data-cell': keyOf(known), 'aria-pressed': 'false', onclick: () => app.model.go({cell: selected === known ? '' : keyOf(known)})}, named),
      known && now !== undefined && h('p', {class: 'meta'},
        jump(known.set, `set at #${known.set}`, {'aria-label': `set at #${known.set}: ${slot}`}), `, ${age(app.data.t[told.n] - known.t)}`,
        known.expression !== null && ` ← ${brief(text(known.expression))}`,
        known.origin && `, from ${known.origin.text}`));
  };

  const symbolTitle = (symbol, change) => h('div', {class: 'title'},
    h('span', {class: 'sign'}, sign[change]), h('b', {}, `symbol ${symbol.id}`), h('span', {class: 'unseen'}, ` ${spoken[change]}`),
    jump(symbol.made, `made at #${symbol.made}`));

  const after = ({change, before, after: symbol}) => {
    if (!symbol) return h('div', {class: 'symbol removed narrow'}, symbolTitle(before, 'removed'), h('ul', {}, Object.entries(slotsOf(before)).map(([slot, value]) => cell(before, slot, value, null, true))));
    const was = change === 'changed' ? slotsOf(before) : {}, now = slotsOf(symbol);
    const names = [...new Set([...Object.keys(now), ...Object.keys(was)])];
    // A pushed symbol takes slots over from the one below: those it has not set are not new.
    const set = (slot) => change === 'changed' || (change === 'added' && Object.hasOwn(symbol.slots_changed ?? {}, slot));
    return h('div', {class: `symbol ${change}`, 'data-testid': 'symbol'}, symbolTitle(symbol, change),
      names.length ? h('ul', {}, names.map((slot) => cell(symbol, slot, was[slot], now[slot], set(slot)))) : h('p', {class: 'muted none'}, 'all slots empty'));
  };

  const before = ({change, before: symbol, after: next}) => {
    if (!symbol) return h('div', {class: 'absent', 'aria-hidden': 'true'});
    const now = slotsOf(next);
    return h('div', {class: `symbol was was-${change}`}, h('div', {class: 'title'}, h('b', {}, change === 'changed' ? 'before' : `symbol ${symbol.id}`), change === 'removed' && h('span', {class: 'gone'}, '− removed')),
      h('ul', {}, Object.entries(slotsOf(symbol)).map(([slot, value]) =>
        h('li', {class: `cell ${change === 'changed' && changeOf(value, now[slot]) !== 'same' ? 'left' : 'same'}`}, h('div', {class: 'pair'}, h('span', {class: 'name'}, slot), h('span', {class: 'value'}, valueText(value)))))));
  };

  const happened = (record) => {
    if (!record) return [];
    const {what, sets: all} = operationWords(record.kind === 'correction' ? record.kind : record.operation), sets = all.filter(([, value]) => value !== 'null');
    return [`, ${what}`, sets.length > 0 && h('span', {class: 'sets'}, ' (', sets.map(([slot, value], i) => [i > 0 && ', ', h('span', {class: 'term'}, `${slot} ← ${brief(value)}`)]), ')')];
  };

  const draw = () => {
    const {stack, record} = told, focus = document.activeElement?.dataset?.cell, held = body.contains(document.activeElement);
    depth.textContent = stack.at === null ? '' : (stack.branch ? `branch ${stack.branch.id}, ` : '') + `${stack.depth_before === stack.depth ? '' : `${stack.depth_before} → `}${counted(stack.depth, 'symbol')}`;
    if (stack.at === null) {
      body.replaceChildren(h('p', {class: 'empty'}, 'The automaton has not moved yet.'));
      return;
    }
    const {rows, folded} = stackRows(stack), chosen = tracker.find(cells, app.model.selection.cell);
    const open = unfolded || rows.slice(rows.length - folded).some((row) => chosen && row.after?.id === chosen.symbol);
    const shown = folded && !open ? rows.slice(0, rows.length - folded) : rows;
    body.replaceChildren(
      h('p', {class: 'note', 'data-testid': 'operation'}, jump(stack.at, `#${stack.at} ${app.data.label(stack.at)}`), happened(record)),
      h('div', {class: 'heads', 'aria-hidden': 'true'}, h('span', {}, 'before'), h('span', {}, 'after')),
      h('ol', {class: 'stack-rows'}, shown.map((row) => h('li', {class: 'row-pair'}, before(row), after(row)))),
      ...[folded > 0 && h('button', {type: 'button', class: 'link fold', 'data-testid': 'fold', 'aria-expanded': String(open), onclick: () => { unfolded = !open; draw(); body.querySelector('.fold')?.focus(); }},
        open ? `▾ ${folded} unchanged below` : `▸ ${folded} unchanged below`),
      !stack.symbols.length && h('p', {class: 'empty'}, 'The stack is empty.')].filter(Boolean));
    if (held) ((focus && [...body.querySelectorAll('[data-cell]')].find((one) => slotOf(one.dataset.cell) === slotOf(focus))) || body).focus();
    mark();
  };

  const mark = () => {
    const wanted = app.model.selection.cell;
    selected = tracker.find(cells, wanted);
    for (const one of body.querySelectorAll('[data-cell]')) {
      const on = Boolean(selected) && one.dataset.cell === keyOf(selected);
      one.setAttribute('aria-pressed', String(on));
      one.closest('.cell').classList.toggle('chosen', on);
    }
    line.hidden = !wanted;
    if (!wanted) return;
    const clear = h('button', {type: 'button', class: 'link', 'aria-label': 'No cell', onclick: () => app.model.go({cell: ''})}, '✕');
    if (!selected) {
      line.replaceChildren(h('b', {}, slotOf(wanted)), ' is not on the stack here. ', clear);
      return;
    }
    const numbers = (list) => list.map((n, i) => [i > 0 && ', ', jump(n)]);
    line.replaceChildren(...[h('b', {}, selected.slot), ' set at ', jump(selected.set), `, ${age(app.data.t[told.n] - selected.t)}`,
      selected.changes.length > 0 && ['; before that changed at ', numbers(selected.changes)],
      selected.read === null ? '; not read nearby' : ['; read last at ', jump(selected.read)], '. ', clear].flat(Infinity).filter(Boolean));
  };

  const latest = new Latest(
    async (wanted) => {
      const [n, branch] = wanted.split(' ').map(Number);
      // A branch that has ended has no stack here: the leading one's is shown.
      const stack_asked = branch === undefined ? app.client.stack(n) : app.client.stack(n, branch).catch(() => app.client.stack(n));
      const [stack, explained] = await Promise.all([stack_asked, app.client.explain(n).catch(() => null)]);
      return {n, stack, explained, record: stack.at === null ? null : await app.client.record(stack.at).catch(() => null)};
    },
    (answer) => {
      told = answer;
      cells = Array.isArray(answer.explained?.cells) ? answer.explained.cells : [];
      draw();
    },
    (problem) => body.replaceChildren(h('p', {class: 'trouble'}, problem.message)));

  return {
    element: panel('stack', 'Stack', depth, [body, line]),
    render({n, branch}) {
      latest.want(branch === null ? `${n}` : `${n} ${branch}`);
      if (told) mark();
    },
    labelsArrived() { if (told) draw(); },
  };
}
