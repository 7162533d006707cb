// How the term behind the record (or behind the selected cell of the stack) came about: a tree of applications, from the
// words and gestures up, in words, as λ-terms or in continuation-passing style, with the steps of working it out.
import {h, s, panel} from '../dom.js';
import {Latest} from '../terms/latest.js';
import {CellTracker, keyOf} from '../terms/cells.js';
import {depths, described, line, nodeAt, sources, stepsAt} from '../terms/derivation.js';
import {arrowsTo} from '../terms/arrows.js';
import {shorter} from '../terms/term.js';
import {Steps} from './derivation_steps.js';
import {DerivationTree} from './derivation_tree.js';

const depth_names = {gloss: 'words', λ: 'λ', CPS: 'CPS'};
const depth_titles = {gloss: 'words: what was said and shown', λ: 'λ-notation', CPS: 'CPS: continuation-passing style'};
const depth_keys = {ArrowUp: -1, ArrowDown: 1};
const step_keys = {ArrowLeft: -1, ArrowRight: 1};

class Derivation {
  #client;
  #model;
  #jump;
  #subject = h('p', {class: 'subject', 'data-testid': 'subject'});
  #steps = new Steps();
  #chips = h('ul', {class: 'chips', 'data-testid': 'chips', 'aria-label': 'Words and gestures it came from'});
  // An empty `term` of the selection means no node: the root's is 'root'.
  #tree = new DerivationTree((path) => this.#model.go({term: path || 'root'}));
  #curves = s('svg', {class: 'curves', 'aria-hidden': 'true'});
  #inner;
  #chosen = h('p', {class: 'chosen-node', 'data-testid': 'node', hidden: true});
  #depths = depths.map((one) => this.#depthButton(one));
  #group = h('div', {class: 'depths', role: 'group', 'aria-label': 'Depth (Alt+↑, Alt+↓)'}, this.#depths);
  #depth = 'gloss';
  #tracker = new CellTracker();
  #found = false;
  #root = null; // of the derivation that is shown
  #resized = new ResizeObserver(() => this.#bend());
  #latest = new Latest(
    (wanted) => this.#ask(wanted),
    (answer) => this.#show(answer),
    (problem) => {
      this.#root = null;
      this.#draw();
      this.#subject.replaceChildren(h('span', {class: 'trouble'}, problem.message));
    },
  );

  constructor({client, model, jump}) {
    this.#client = client;
    this.#model = model;
    this.#jump = jump;
    const about = h('div', {class: 'about'}, this.#subject, this.#steps.bar);
    const parts = [about, this.#steps.expression, this.#chips, this.#tree.element, this.#curves];
    this.#inner = h('div', {class: 'inner'}, parts);
    const body = h('div', {class: 'terms', tabindex: 0, role: 'region', 'aria-label': 'Term'}, this.#inner);
    this.element = panel('derivation', 'Derivation', this.#group, [body, this.#chosen]);
    document.addEventListener('keydown', this.#onKeys);
    this.#resized.observe(this.#inner);
    this.#draw();
  }

  #depthButton(depth) {
    const title = depth_titles[depth];
    const props = {type: 'button', 'data-testid': `depth-${depth_names[depth]}`, 'aria-label': title, title};
    return h('button', {...props, onclick: () => this.#setDepth(depth)}, depth_names[depth]);
  }
  #setDepth(depth) {
    this.#depth = depth;
    this.#draw();
  }
  #onKeys = (event) => {
    if (!event.altKey || event.ctrlKey || event.metaKey || event.target.closest?.('dialog')) return;
    const deeper = depth_keys[event.key];
    const along = this.#steps.any && step_keys[event.key];
    if (!this.#root || (!deeper && !along)) return;
    event.preventDefault();
    if (along) this.#steps.stepBy(along);
    else this.#setDepth(depths[Math.max(0, Math.min(depths.length - 1, depths.indexOf(this.#depth) + deeper))]);
  };

  // `wanted`: record and cell. @returns the derivation behind the cell, or where none is known behind the record
  async #ask(wanted) {
    const space = wanted.indexOf(' ');
    const key = wanted.slice(space + 1);
    const explained = await this.#client.explain(Number(wanted.slice(0, space)));
    const cell = key ? this.#tracker.find(explained.cells, key) : null;
    const of_cell = cell ? await this.#client.explain(cell.set, keyOf(cell)).catch(() => null) : null;
    return {explained, cell: of_cell ? cell : null, root: (of_cell ?? explained).derivation};
  }
  #show({explained, cell, root}) {
    const same = this.#found && JSON.stringify(root) === JSON.stringify(this.#root);
    this.#found = true;
    this.#root = root && typeof root === 'object' ? root : null;
    this.#subject.replaceChildren(...this.#subjectOf(explained, cell));
    if (same) this.#mark();
    else this.#draw();
  }
  #subjectOf({kind, about}, cell) {
    if (cell) return [`The value of ${cell.slot}, set at `, this.#link(cell.set)];
    return this.#root ? [`Behind ${kind} `, this.#link(about)] : ['No term is behind this record.'];
  }
  #link(n, words = `#${n}`) {
    return h('button', {type: 'button', class: 'link', onclick: () => this.#jump(n)}, words);
  }

  #draw() {
    for (const [i, one] of this.#depths.entries()) one.setAttribute('aria-pressed', String(depths[i] === this.#depth));
    this.#steps.show(stepsAt(this.#root, this.#depth));
    this.#chips.replaceChildren(...(this.#root ? sources(this.#root) : []).map((one) => this.#chip(one)));
    this.#tree.draw(this.#root, this.#depth);
    this.#chips.hidden = !this.#chips.children.length;
    this.#group.hidden = !this.#root;
    this.#mark();
  }
  // A word or gesture; `paths`: the leaves that came from it.
  #chip({kind, paths, n, text}) {
    const props = {type: 'button', class: `chip ${kind}`, 'data-paths': paths.join(' '), 'data-testid': 'chip'};
    const button = h('button', {...props, onclick: () => this.#jump(n)}, text, h('span', {class: 'n'}, ` #${n}`));
    return h('li', {}, button);
  }

  /** Path of the selected node, or null. */
  #selectedPath() {
    const {term} = this.#model.selection;
    return term ? (term === 'root' ? '' : term) : null;
  }
  #mark() {
    const path = this.#selectedPath();
    const node = path === null ? null : nodeAt(this.#root, path);
    this.#tree.mark(node ? path : null);
    this.#chosen.hidden = !node;
    if (node) this.#chosen.replaceChildren(...this.#about(node));
    this.#bend();
  }
  #about(node) {
    return [
      h('span', {class: 'term'}, shorter(line(node, 'λ').text)),
      ': ',
      shorter(described(node)) || 'nothing more is known of it',
      ' ',
      Number.isInteger(node.n) && this.#link(node.n, `applied at #${node.n}`),
      ' ',
      Number.isInteger(node.origin?.n) && this.#link(node.origin.n, `told at #${node.origin.n}`),
    ].filter(Boolean);
  }

  // Curves from each word or gesture to its leaves; those below the selected node are strong.
  #bend() {
    const path = this.#selectedPath();
    const below = (leaf) => path !== null && (leaf === path || path === '' || leaf.startsWith(`${path}.`));
    const curves = [...this.#chips.querySelectorAll('.chip')].flatMap((chip) =>
      chip.dataset.paths.split(' ').map((leaf) => ({
        chip,
        leaf: this.#tree.itemAt(leaf),
        kind: chip.className,
        strong: below(leaf),
      })),
    );
    arrowsTo(this.#curves, this.#inner, curves);
  }

  render({n, cell}) {
    this.#latest.want(`${n} ${cell ?? ''}`);
    if (this.#found) this.#mark();
  }
  close() {
    document.removeEventListener('keydown', this.#onKeys);
    this.#resized.disconnect();
  }
}

export const mountDerivation = (needs) => new Derivation(needs);
