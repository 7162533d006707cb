// The order of the start page's runs, and those of them that are shown: headings that sort, filters, folders.
import {h} from '../dom.js';
import {verdictOf} from '../run/verdict.js';

const badness = {bad: 0, warn: 1, live: 2, '': 3, good: 4};
/** `of(run)`: the value to sort by; `first`: the direction of the first press. */
const columns = [
  {title: 'Choose', unseen: true},
  {title: 'Scene', unseen: true},
  {title: 'Run', of: (run) => run.name, first: 1},
  {title: 'Verdict', of: (run) => badness[verdictOf(run).kind] ?? 3, first: 1},
  {title: 'Length', of: (run) => run.duration ?? 0, number: true, first: -1},
  {title: 'Said', of: (run) => run.utterances ?? 0, number: true, first: -1},
  {title: 'Acts', of: (run) => run.acts ?? 0, number: true, first: -1},
  {title: 'Refused', of: (run) => run.refusals ?? 0, number: true, first: -1},
  {title: 'Machine, scene', of: (run) => `${run.machine ?? ''} ${run.scene ?? ''}`, first: 1},
  {title: 'Changed', of: (run) => run.changed ?? 0, first: -1},
];
const kinds = {bad: 'failed', warn: 'cut short', good: 'as expected', '': 'complete', live: 'live'};
const filtered = {
  verdict: (run) => kinds[verdictOf(run).kind],
  machine: (run) => run.machine,
  scene: (run) => run.scene,
};
const folderOf = ({name}) => (name.includes('/') ? name.slice(0, name.lastIndexOf('/')) : '');
const compare = (a, b) => (typeof a === 'string' ? a.localeCompare(b, 'en', {numeric: true}) : a - b);

export class Arrangement {
  #changed;
  #column = null; // sorted by; none: the server's order, the newest first
  #sense = 1;
  #folders = h('input', {type: 'checkbox', 'data-testid': 'by-folder', onchange: () => this.#changed()});
  #by_folder = h('label', {hidden: true}, this.#folders, 'by folder');
  #selects = {};

  /** `changed()` is called when the reader wants another order or other runs. */
  constructor(changed) {
    this.#changed = changed;
    for (const name of Object.keys(filtered))
      this.#selects[name] = h('select', {
        'aria-label': `Runs of this ${name}`,
        'data-testid': `filter-${name}`,
        hidden: true,
        onchange: () => this.#changed(),
      });
    this.filters = [...Object.values(this.#selects), this.#by_folder];
    this.heads = columns.map((column) => this.#head(column));
  }

  #head(column) {
    const {title, unseen, number} = column;
    const name = `of-${title.split(',')[0].toLowerCase()}`;
    if (unseen) return h('th', {scope: 'col', class: name}, h('span', {class: 'unseen'}, title));
    const sort = () => {
      this.#sense = this.#column === column ? -this.#sense : column.first;
      this.#column = column;
      this.heads.forEach((head, i) => {
        if (columns[i] === column) head.setAttribute('aria-sort', this.#sense > 0 ? 'ascending' : 'descending');
        else head.removeAttribute('aria-sort');
      });
      this.#changed();
    };
    const button = h('button', {type: 'button', class: 'link', title: `Sort by ${title}`, onclick: sort}, title);
    return h('th', {scope: 'col', class: number ? `number ${name}` : name}, button);
  }

  /** Offers the filters that tell these runs apart. */
  learn(runs) {
    for (const [name, select] of Object.entries(this.#selects)) {
      const values = [...new Set(runs.map(filtered[name]).filter(Boolean))].sort();
      const known = [...select.options].slice(1).map(({value}) => value);
      select.hidden = values.length < 2;
      if (values.join('\n') === known.join('\n')) continue;
      const chosen = select.value;
      const all = h('option', {value: ''}, `any ${name}`);
      select.replaceChildren(all, ...values.map((value) => h('option', {value, selected: value === chosen}, value)));
    }
    this.#by_folder.hidden = new Set(runs.map(folderOf)).size < 2;
  }
  /** Shows all of them again. */
  reset() {
    for (const select of Object.values(this.#selects)) select.value = '';
  }

  /** The runs that fit the filters, in the order that is wanted. */
  arranged(runs) {
    const fits = (run) =>
      Object.entries(this.#selects).every(([name, {value}]) => !value || filtered[name](run) === value);
    const {of} = this.#column ?? {};
    const folders = this.#folders.checked;
    return runs
      .filter(fits)
      .toSorted(
        (a, b) => (folders ? compare(folderOf(a), folderOf(b)) : 0) || (of ? this.#sense * compare(of(a), of(b)) : 0),
      );
  }
  /** A row that names the folder of `run`, where that is another than of the run above; else null. */
  heading(run, above) {
    if (!this.#folders.checked || (above && folderOf(above) === folderOf(run))) return null;
    return h('tr', {class: 'folder'}, h('th', {scope: 'colgroup', colspan: columns.length}, folderOf(run) || 'here'));
  }
}
