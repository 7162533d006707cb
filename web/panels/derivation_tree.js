// A derivation as a tree to walk through by mouse and keys. A node is named by its path: the places of its ancestors and
// its own, each among its siblings, as in '0.1'; the root's path is empty.
import {h, shown} from '../dom.js';
import {isHole, line, told} from '../terms/derivation.js';
import {shorter} from '../terms/term.js';

const steps = {ArrowUp: -1, ArrowDown: 1};

export class DerivationTree {
  element = h('ul', {class: 'tree', role: 'tree', 'aria-label': 'Derivation', 'data-testid': 'tree'});
  #select;

  /** `select(path)`: a node was chosen. */
  constructor(select) {
    this.#select = select;
    this.element.addEventListener('click', (event) => {
      const item = event.target.closest('[role=treeitem]');
      if (item) select(item.dataset.path);
    });
    this.element.addEventListener('focusin', (event) => this.#makeReachable(event.target));
    this.element.addEventListener('keydown', (event) => this.#onKey(event));
  }

  #items() {
    return [...this.element.querySelectorAll('[role=treeitem]')];
  }
  itemAt(path) {
    return this.element.querySelector(`[data-path="${path}"]`);
  }
  // By the Tab key one item is reached, from there the others by the arrow keys.
  #makeReachable(item) {
    for (const one of this.#items()) one.tabIndex = one === item ? 0 : -1;
  }
  #onKey(event) {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const all = this.#items();
    const at = all.indexOf(event.target);
    const by = steps[event.key];
    if (at < 0 || (!by && event.key !== 'Enter' && event.key !== ' ')) return;
    event.preventDefault();
    if (by) all[Math.max(0, Math.min(all.length - 1, at + by))].focus();
    else this.#select(all[at].dataset.path);
  }

  /** Shows the derivation in the notation `depth`, or nothing for null. */
  draw(root, depth) {
    const held = this.element.contains(document.activeElement) ? document.activeElement.dataset.path : null;
    this.element.replaceChildren(...(root ? [branch(root, depth, '', 1)] : []));
    this.element.hidden = !root;
    if (held !== null) this.itemAt(held)?.focus();
  }
  /** Marks the node of this path; null: none. */
  mark(path) {
    const all = this.#items();
    const marked = all.find((one) => one.dataset.path === path);
    for (const one of all) one.setAttribute('aria-selected', String(one === marked));
    if (!this.element.contains(document.activeElement)) this.#makeReachable(marked ?? all[0]);
  }
}

// A node and all below it.
function branch(node, depth, path, level, role = null) {
  const below = Array.isArray(node.children) ? node.children.filter((one) => one && typeof one === 'object') : [];
  const roles = depth === 'CPS' && node.how === 'application' ? ['m', 'n'] : [];
  const inner = below.map((one, i) => branch(one, depth, path ? `${path}.${i}` : `${i}`, level + 1, roles[i]));
  const item = h(
    'div',
    {
      role: 'treeitem',
      class: `node-line ${isHole(node) ? 'hole' : node.how}`,
      'aria-level': level,
      'aria-selected': 'false',
      'aria-expanded': below.length ? 'true' : null,
      tabindex: -1,
      'data-path': path,
    },
    role && h('span', {class: 'role'}, role),
    words(node, depth),
  );
  return h('li', {role: 'none'}, item, below.length > 0 && h('ul', {role: 'group'}, inner));
}

function words(node, depth) {
  const {text, type} = line(node, depth);
  const hole = isHole(node);
  const from = hole ? node.origin.text : told(node.origin);
  const unseen = (sentence) => h('span', {class: 'unseen'}, sentence);
  return [
    h('span', {class: 'term'}, hole && depth !== 'gloss' ? `▢ ${shorter(text)}` : shorter(text)),
    hole && unseen('open'),
    type && h('span', {class: 'type'}, unseen('of type '), type),
    node.rule && h('span', {class: 'badge'}, unseen('raised by '), `↑ ${shown(node.rule)}`),
    from && h('span', {class: 'from'}, `← ${from}`),
  ];
}
