// The stack at the cursor, top first: before and after its last change, and of each cell its age, its origin, its reader.
import {h, panel, counted} from '../dom.js';
import {Latest} from '../terms/latest.js';
import {CellTracker, keyOf, slotOf} from '../terms/cells.js';
import {age, stackRows} from '../terms/stack_words.js';
import {changeWords, stackRow} from './stack_rows.js';

class StackPanel {
  #data;
  #client;
  #model;
  #jump;
  #body = h('div', {class: 'symbols', tabindex: 0, role: 'region', 'aria-label': 'Symbols, top first'});
  #depth = h('span', {class: 'muted', 'data-testid': 'depth'});
  #line = h('p', {class: 'cell-line', 'data-testid': 'cell-line', role: 'status', hidden: true});
  #tracker = new CellTracker();
  #shown = null; // {n, stack, record, cells}: as the server told it last
  #selected = null; // of its cells
  #unfolded = false;
  #latest = new Latest(
    (wanted) => this.#ask(...wanted.split(' ').map(Number)),
    (answer) => {
      this.#shown = answer;
      this.#draw();
    },
    (problem) => this.#body.replaceChildren(h('p', {class: 'trouble'}, problem.message)),
  );

  constructor({data, client, model, jump}) {
    this.#data = data;
    this.#client = client;
    this.#model = model;
    this.#jump = jump;
    this.element = panel('stack', 'Stack', this.#depth, [this.#body, this.#line]);
  }

  async #ask(n, branch) {
    const client = this.#client;
    // A branch that has ended has no stack here: the leading one's is shown.
    const stack_asked = branch === undefined ? client.stack(n) : client.stack(n, branch).catch(() => client.stack(n));
    const [stack, explained] = await Promise.all([stack_asked, client.explain(n).catch(() => null)]);
    const record = stack.at === null ? null : await client.record(stack.at).catch(() => null);
    return {n, stack, record, cells: Array.isArray(explained?.cells) ? explained.cells : []};
  }

  #link(n, words, props) {
    return h('button', {type: 'button', class: 'link', onclick: () => this.#jump(n), ...props}, words ?? `#${n}`);
  }
  #ago(t) {
    return age(this.#data.t[this.#shown.n] - t);
  }
  // By stackRow().
  #view = {
    known: (symbol, slot) => this.#shown.cells.find((one) => one.symbol === symbol.id && one.slot === slot),
    jump: (n, words, props) => this.#link(n, words, props),
    choose: (cell) => this.#model.go({cell: this.#selected === cell ? '' : keyOf(cell)}),
    ago: (t) => this.#ago(t),
  };

  #draw() {
    const {stack} = this.#shown;
    const body = this.#body;
    this.#depth.textContent = depthWords(stack);
    if (stack.at === null) {
      body.replaceChildren(h('p', {class: 'empty'}, 'The automaton has not moved yet.'));
      return;
    }
    const held = body.contains(document.activeElement);
    const held_cell = document.activeElement?.dataset?.cell;
    body.replaceChildren(...this.#content().filter(Boolean));
    if (held) this.#focus(held_cell);
    this.#mark();
  }
  #content() {
    const {stack, record} = this.#shown;
    const {rows, folded} = stackRows(stack);
    const open = this.#unfolded || this.#chosenAmong(rows.slice(rows.length - folded));
    const shown = folded && !open ? rows.slice(0, rows.length - folded) : rows;
    const change = this.#link(stack.at, `#${stack.at} ${this.#data.label(stack.at)}`, {
      title: this.#data.raw(stack.at),
    });
    return [
      h('p', {class: 'note', 'data-testid': 'operation'}, change, changeWords(record)),
      h('div', {class: 'heads', 'aria-hidden': 'true'}, h('span', {}, 'before'), h('span', {}, 'after')),
      h(
        'ol',
        {class: 'stack-rows'},
        shown.map((row) => stackRow(row, this.#view)),
      ),
      folded > 0 && this.#fold(folded, open),
      !stack.symbols.length && h('p', {class: 'empty'}, 'The stack is empty.'),
    ];
  }
  #chosenAmong(rows) {
    const chosen = this.#tracker.find(this.#shown.cells, this.#model.selection.cell);
    return Boolean(chosen) && rows.some((row) => row.after?.id === chosen.symbol);
  }
  // Hides or shows the symbols that did not change.
  #fold(folded, open) {
    const props = {type: 'button', class: 'link fold', 'data-testid': 'fold', 'aria-expanded': String(open)};
    const button = h('button', props, `${open ? '▾' : '▸'} ${folded} unchanged below`);
    button.addEventListener('click', () => {
      this.#unfolded = !open;
      this.#draw();
      this.#body.querySelector('.fold')?.focus();
    });
    return button;
  }
  // Focuses the cell of the same slot, else the whole.
  #focus(cell) {
    const all = [...this.#body.querySelectorAll('[data-cell]')];
    const same = cell && all.find((one) => slotOf(one.dataset.cell) === slotOf(cell));
    (same || this.#body).focus();
  }

  // Marks the cell that is selected, and tells its history in the line below.
  #mark() {
    const wanted = this.#model.selection.cell;
    const selected = (this.#selected = this.#tracker.find(this.#shown.cells, wanted));
    for (const one of this.#body.querySelectorAll('[data-cell]')) {
      const on = Boolean(selected) && one.dataset.cell === keyOf(selected);
      one.setAttribute('aria-pressed', String(on));
      one.closest('.cell').classList.toggle('chosen', on);
    }
    this.#line.hidden = !wanted;
    if (!wanted) return;
    const clear = h('button', {type: 'button', class: 'link', 'aria-label': 'No cell'}, '✕');
    clear.addEventListener('click', () => this.#model.go({cell: ''}));
    const history = selected ? this.#history(selected) : [h('b', {}, slotOf(wanted)), ' is not on the stack here. '];
    this.#line.replaceChildren(...history, clear);
  }
  #history({slot, set, t, changes, read}) {
    const numbers = changes.map((n, i) => [i > 0 && ', ', this.#link(n)]);
    return [
      h('b', {}, slot),
      ' set at ',
      this.#link(set),
      `, ${this.#ago(t)}`,
      changes.length > 0 && ['; before that changed at ', numbers],
      read === null ? '; not read nearby' : ['; read last at ', this.#link(read)],
      '. ',
    ]
      .flat(Infinity)
      .filter(Boolean);
  }

  render({n, branch}) {
    this.#latest.want(branch === null ? `${n}` : `${n} ${branch}`);
    if (this.#shown) this.#mark();
  }
  labelsArrived() {
    if (this.#shown) this.#draw();
  }
}

function depthWords({at, branch, depth, depth_before}) {
  if (at === null) return '';
  const from = depth_before === depth ? '' : `${depth_before} → `;
  return `${branch ? `branch ${branch.id}, ` : ''}${from}${counted(depth, 'symbol')}`;
}

export const mountStack = (needs) => new StackPanel(needs);
