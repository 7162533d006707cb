// All records as a table that holds only the rows in sight.
import {h, panel, brief, grouped} from '../dom.js';
import {lastAtMost} from '../search.js';

const row_px = 22;
const wait_ms = 120; // after a letter, before the records are filtered
// Browsers bound the height of an element: the rows of very many records scroll by faster than they are drawn.
const most_px = 8e6;
const steps = {ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10};

/** Running numbers of the records of a kind: '' for the stops, '*' for all. */
export function ofKind(data, kind) {
  if (kind === '') return data.stops;
  if (kind === '*') return {length: data.size, all: true};
  const number = data.kinds.indexOf(kind);
  const found = [];
  for (let n = 0; n < data.size; ++n) if (data.kind_of[n] === number) found.push(n);
  return Uint32Array.from(found);
}

/** A grid of records of which only the rows in sight are elements. */
class Rows {
  #data;
  #cursor;
  #found = []; // by ofKind()
  #current = -1;
  #rows = h('div', {class: 'rows', role: 'presentation'});

  constructor(data, cursor) {
    this.#data = data;
    this.#cursor = cursor;
    this.element = h(
      'div',
      {class: 'scroller', tabindex: 0, role: 'grid', 'aria-label': 'Records', 'aria-colcount': 4},
      this.#rows,
    );
    this.element.addEventListener('scroll', () => this.paint());
    this.element.addEventListener('keydown', (event) => this.#onKey(event));
    new ResizeObserver(() => this.reveal(false)).observe(this.element);
  }

  get length() {
    return this.#found.length;
  }
  #numberAt(place) {
    return this.#found.all ? place : this.#found[place];
  }
  #placeOf(n) {
    return this.#found.all ? n : lastAtMost(this.#found, n);
  }
  #stretch() {
    return Math.max(1, (this.length * row_px) / most_px);
  }

  #onKey(event) {
    const by = steps[event.key];
    if (!by || !this.length) return;
    event.preventDefault();
    event.stopPropagation();
    const place = Math.max(0, Math.min(this.length - 1, this.#placeOf(this.#current) + by));
    this.#cursor.select(this.#numberAt(place), 'step');
  }

  show(found) {
    this.#found = found;
    this.element.setAttribute('aria-rowcount', this.length);
    this.#rows.style.height = `${Math.min(most_px, this.length * row_px)}px`;
    this.reveal(true);
  }
  /** Marks record n. @returns whether another was marked before */
  mark(n) {
    const moved = this.#current !== n;
    this.#current = n;
    return moved;
  }
  /** Scrolls to the marked record where it is out of sight; `again`: in any case. */
  reveal(again) {
    const {element} = this;
    const top = (Math.max(0, this.#placeOf(this.#current)) * row_px) / this.#stretch();
    if (again || top < element.scrollTop || top + row_px > element.scrollTop + element.clientHeight)
      element.scrollTop = top - (element.clientHeight - row_px) / 2;
    this.paint();
  }
  paint() {
    const {scrollTop, clientHeight} = this.element;
    if (!clientHeight) return;
    const stretch = this.#stretch();
    const first = Math.max(0, Math.floor((scrollTop * stretch) / row_px) - 2);
    const last = Math.min(this.length, first + Math.ceil(clientHeight / row_px) + 5);
    const start = Math.max(0, stretch > 1 ? scrollTop - 2 * row_px : first * row_px);
    const drawn = [];
    for (let place = first; place < last; ++place) drawn.push(this.#row(place, start + (place - first) * row_px));
    const nothing = h('div', {role: 'row', class: 'empty'}, h('span', {role: 'gridcell'}, 'No record matches.'));
    this.#rows.replaceChildren(...(drawn.length ? drawn : [nothing]));
  }
  #row(place, top) {
    const data = this.#data;
    const n = this.#numberAt(place);
    const name = data.kind(n);
    const cell = (kind, content, title) => h('span', {class: kind, role: 'gridcell', title}, content);
    return h(
      'div',
      {
        class: `row kind-${name}`,
        role: 'row',
        'aria-rowindex': place + 1,
        'aria-selected': String(n === this.#current),
        style: {top: `${top}px`},
        onclick: () => this.#cursor.jump(n),
        'data-n': n,
      },
      cell('n', `${n}`),
      cell('t', data.t[n].toFixed(3)),
      cell('kind', name),
      cell('label', brief(data.label(n)), data.raw(n)),
    );
  }
}

class Records {
  #data;
  #client;
  #rows;
  #filter;
  #kind;
  #count = h('span', {class: 'muted', role: 'status', 'data-testid': 'count'});
  #shown = {kind: null, filter: null};

  constructor({data, client, model, cursor}) {
    this.#data = data;
    this.#client = client;
    this.#rows = new Rows(data, cursor);
    this.#filter = this.#filterField(model);
    this.#kind = h(
      'select',
      {'aria-label': 'Kind of record', 'data-testid': 'kind', onchange: () => model.go({kind: this.#kind.value})},
      h('option', {value: ''}, `stops (${grouped(data.stops.length)})`),
      h('option', {value: '*'}, `everything (${grouped(data.size)})`),
      data.kinds.map((name) =>
        h('option', {value: name, title: data.schema.when(name)}, `${name} (${grouped(data.count(name))})`),
      ),
    );
    this.element = panel('records', 'Records', [this.#count, this.#kind, this.#filter], this.#rows.element);
  }

  #filterField(model) {
    let timer = 0;
    const field = h('input', {
      type: 'search',
      placeholder: 'Filter  ( / )',
      'aria-label': 'Filter records by text',
      'data-testid': 'filter',
      spellcheck: 'false',
      autocomplete: 'off',
    });
    field.addEventListener('input', () => {
      clearTimeout(timer);
      timer = setTimeout(() => model.go({filter: field.value}, 'slide'), wait_ms);
    });
    field.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' && event.key !== 'Enter') return;
      this.#rows.element.focus();
      event.preventDefault();
    });
    return field;
  }

  labelsArrived() {
    this.#rows.paint();
  }
  focusFilter() {
    this.#filter.focus();
    this.#filter.select();
  }

  async render({n, kind, filter}) {
    const moved = this.#rows.mark(n);
    const shown = this.#shown;
    if (shown.kind === kind && shown.filter === filter) {
      if (moved) this.#rows.reveal(false);
      return;
    }
    this.#shown = {kind, filter};
    if (this.#filter.value.trim() !== filter.trim()) this.#filter.value = filter;
    this.#kind.value = kind;
    const asked = this.#shown;
    try {
      const found = filter.trim() ? await this.#client.find(filter, kind) : ofKind(this.#data, kind);
      if (this.#shown !== asked) return;
      this.#rows.show(found);
      this.#count.textContent = filter || kind ? `${grouped(found.length)} of ${grouped(this.#data.size)}` : '';
    } catch (problem) {
      this.#count.textContent = problem.message;
    }
  }
}

export const mountRecords = (needs) => new Records(needs);
