// The configurations of an automaton that is in several at once (`--choice explore`): how they branched, and each of them.
import {h, panel, counted} from '../dom.js';
import {branchTree} from '../graph/branch_tree.js';
import {lastAtMost} from '../search.js';

const steps_shown = 12;
const steps_after = 3; // of those, at and after the cursor
const most_records = 5000;
const columns = ['Branch', 'from', 'state', 'weight', 'depth', 'by'];

/** Whether the run ever was in several configurations. */
export const hasBranches = (data) => data.count('branches') > 0;

const told = ({n, branches, dropped, merged, pruned}) =>
  [
    `${counted(branches.length, 'configuration')} since #${n}`,
    dropped?.length && `${dropped.join(', ')} could not go on`,
    merged && `${merged} became one with another`,
    pruned && `${pruned} given up`,
  ]
    .filter(Boolean)
    .join('; ');

class Branches {
  #model;
  #client;
  #summary = h('p', {class: 'muted', 'data-testid': 'branches-told'});
  #tree = h('div', {class: 'branch-scroll'});
  #rows = h('tbody', {});
  #all = null; // promise of the records of the kind `branches`
  #drawn = '';

  constructor({client, model}) {
    this.#client = client;
    this.#model = model;
    const head = h(
      'tr',
      {},
      columns.map((one) => h('th', {scope: 'col'}, one)),
    );
    const table = h('table', {class: 'branch-table', 'data-testid': 'branches'}, h('thead', {}, head), this.#rows);
    const body = h('div', {class: 'body', tabindex: 0, role: 'region', 'aria-label': 'Configurations'});
    body.append(this.#summary, this.#tree, table);
    this.element = panel('branches', 'Branches', null, body);
  }

  // Few enough to be fetched at once, and the same for every instant.
  #records() {
    this.#all ??= this.#client
      .records('branches', 0, most_records)
      .then((records) => records.filter((one) => Array.isArray(one.branches)));
    return this.#all;
  }
  /** Place of the last of `records` up to record n, or -1. */
  #placeAt(records, n) {
    return lastAtMost(
      Float64Array.from(records, (one) => one.n),
      n,
    );
  }
  #toggle(id) {
    this.#model.go({branch: this.#model.selection.branch === id ? null : id});
  }

  #row(one, i, selected) {
    const chosen = one.id === selected;
    const name = h(
      'button',
      {type: 'button', 'aria-pressed': String(chosen), 'data-testid': 'branch', onclick: () => this.#toggle(one.id)},
      `${one.id}${i === 0 ? ' (leading)' : ''}`,
    );
    const weight = h('meter', {min: 0, max: 1, value: one.weight, 'aria-label': `weight of branch ${one.id}`});
    return h(
      'tr',
      {class: chosen ? 'chosen' : null},
      h('td', {}, name),
      h('td', {}, one.parent === one.id ? '' : one.parent),
      h('td', {}, one.state),
      h('td', {}, weight, ` ${Number(one.weight).toFixed(3)}`),
      h('td', {}, one.depth),
      h('td', {}, (one.by ?? []).join(', ')),
    );
  }

  /** To the branch `by` places after the selected one, of those at the cursor. */
  async cycle(by) {
    const {n, branch} = this.#model.selection;
    const records = await this.#records();
    const now = records[this.#placeAt(records, n)];
    if (!now) return;
    const ids = now.branches.map(({id}) => id);
    this.#model.go({branch: ids[(ids.indexOf(branch) + by + ids.length) % ids.length]});
  }

  async render({n, branch}) {
    const records = await this.#records().catch(() => []);
    const place = this.#placeAt(records, n);
    const drawn = `${place} ${branch}`;
    if (this.#drawn === drawn) return;
    this.#drawn = drawn;
    const now = records[place];
    this.#summary.textContent = now ? `${told(now)}.` : 'One configuration.';
    this.#rows.replaceChildren(...(now?.branches ?? []).map((one, i) => this.#row(one, i, branch)));
    const from = Math.max(0, place - steps_shown + steps_after);
    const choose = (id, record) => this.#model.go({branch: id, n: record});
    this.#tree.replaceChildren(branchTree(records.slice(from, from + steps_shown), {now, selected: branch, choose}));
  }
}

export const mountBranches = (needs) => new Branches(needs);
