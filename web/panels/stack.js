// The stack at the cursor, top first, and what the last change did to it.
import {h, panel, text, counted} from '../dom.js';

const sign = {added: '+', removed: '−', changed: '~', same: ''};
const spoken = {added: 'added', removed: 'removed', changed: 'changed', same: 'unchanged'};

export function mountStack(app) {
  const body = h('div', {class: 'symbols', tabindex: 0, role: 'region', 'aria-label': 'Symbols, top first'});
  const depth = h('span', {class: 'muted', 'data-testid': 'depth'});
  let asked = -1;

  const slot = (name, value, change) => {
    if (!change) return h('div', {class: 'slot'}, h('dt', {}, name), h('dd', {}, text(value)));
    const kind = change.was === null ? 'added' : change.now === null ? 'removed' : 'changed';
    return h('div', {class: `slot ${kind}`},
      h('dt', {}, h('span', {class: 'sign', title: spoken[kind]}, sign[kind]), name),
      h('dd', {},
        change.was !== null && h('del', {}, text(change.was)),
        change.was !== null && change.now !== null && ' ',
        change.now !== null && h('span', {}, text(change.now))));
  };

  const symbol = (one, change) => {
    const changes = one.slots_changed ?? {};
    const names = [...new Set([...Object.keys(one.slots), ...Object.keys(changes)])];
    return h('li', {class: `symbol ${change}`, 'data-testid': 'symbol'},
      h('div', {class: 'title'},
        h('span', {class: 'sign', title: spoken[change]}, sign[change]),
        h('b', {}, `symbol ${one.id}`), h('span', {class: 'unseen'}, ` ${spoken[change]}`),
        h('button', {type: 'button', class: 'link', onclick: () => app.jump(one.made)}, `made at #${one.made}`)),
      names.length ? h('dl', {}, names.map((name) => slot(name, one.slots[name] ?? null, change === 'removed' ? null : changes[name])))
                   : h('p', {class: 'muted none'}, 'all slots empty'));
  };

  const show = (stack) => {
    depth.textContent = stack.at === null ? '' : counted(stack.depth, 'symbol');
    const moved = stack.removed.length || stack.symbols.some((one) => one.change !== 'same');
    body.replaceChildren(...(stack.at === null
      ? [h('p', {class: 'empty'}, 'The automaton has not moved yet.')]
      : [h('p', {class: 'note'}, moved ? 'Changed by ' : 'Left as it was by ',
           h('button', {type: 'button', class: 'link', onclick: () => app.jump(stack.at)},
             `#${stack.at} ${app.data.label(stack.at)}`)),
         h('ol', {},
           stack.removed.map((one) => symbol(one, 'removed')),
           stack.symbols.map((one) => symbol(one, one.change))),
         !stack.symbols.length && h('p', {class: 'empty'}, 'The stack is empty.')].filter(Boolean)));
  };

  return {
    element: panel('stack', 'Stack', depth, body),
    async render({n}) {
      if (asked === n) return;
      asked = n;
      try {
        const stack = await app.client.stack(n);
        if (asked === n) show(stack);
      } catch (problem) {
        if (asked === n) body.replaceChildren(h('p', {class: 'trouble'}, problem.message));
      }
    },
  };
}
