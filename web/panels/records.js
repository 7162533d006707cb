// All records as a table that holds only the rows in sight.
import {h, panel, brief, grouped} from '../dom.js';
import {lastAtMost} from '../run/run_data.js';

const row_px = 22, wait_ms = 120;

/** Running numbers of the records of a kind: '' for the stops, '*' for all. */
export function ofKind(data, kind) {
  if (kind === '') return data.stops;
  if (kind === '*') return {length: data.size, all: true};
  const number = data.kinds.indexOf(kind), found = [];
  for (let n = 0; n < data.size; ++n) if (data.kind_of[n] === number) found.push(n);
  return Uint32Array.from(found);
}

export function mountRecords(app) {
  const {data, client} = app;
  let timer = 0;
  const filter = h('input', {type: 'search', placeholder: 'Filter  ( / )', 'aria-label': 'Filter records by text', 'data-testid': 'filter',
    spellcheck: 'false', autocomplete: 'off', oninput: () => {
      clearTimeout(timer);
      timer = setTimeout(() => app.model.go({filter: filter.value}, 'slide'), wait_ms);
    },
    onkeydown: (event) => { if (event.key === 'Escape' || event.key === 'Enter') { scroller.focus(); event.preventDefault(); } }});
  const kind = h('select', {'aria-label': 'Kind of record', 'data-testid': 'kind', onchange: () => app.model.go({kind: kind.value})},
    h('option', {value: ''}, `stops (${grouped(data.stops.length)})`),
    h('option', {value: '*'}, `everything (${grouped(data.size)})`),
    data.kinds.map((name) => h('option', {value: name}, `${name} (${grouped(data.count(name))})`)));
  const count = h('span', {class: 'muted', role: 'status', 'data-testid': 'count'});
  const rows = h('div', {class: 'rows', role: 'presentation'});
  const scroller = h('div', {class: 'scroller', tabindex: 0, role: 'grid', 'aria-label': 'Records', 'aria-colcount': 4, onscroll: () => paint(),
    onkeydown: (event) => {
      const by = {ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10}[event.key];
      if (!by || !found.length) return;
      event.preventDefault();
      event.stopPropagation();
      const place = Math.max(0, Math.min(found.length - 1, placeOf(current) + by));
      app.select(at(place), 'step');
    }}, rows);
  const element = panel('records', 'Records', [count, kind, filter], scroller);
  const looked = {kind: null, filter: null};
  let found = [], current = -1, height = 0;

  const at = (place) => (found.all ? place : found[place]);
  const placeOf = (n) => (found.all ? n : lastAtMost(found, n));
  // Browsers bound how tall a page may be: the rows of very many records are scrolled through faster than drawn.
  const most_px = 8e6;
  const stretch = () => Math.max(1, found.length * row_px / most_px);
  const topOf = (place) => place * row_px / stretch();

  const cell = (name, content) => h('span', {class: name, role: 'gridcell'}, content);
  const row = (place, top) => {
    const n = at(place), name = data.kind(n);
    return h('div', {class: `row kind-${name}`, role: 'row', 'aria-rowindex': place + 1, 'aria-selected': String(n === current),
                     style: {top: `${top}px`}, onclick: () => app.jump(n), 'data-n': n},
      cell('n', `${n}`), cell('t', data.t[n].toFixed(3)), cell('kind', name), cell('label', brief(data.label(n))));
  };
  const paint = () => {
    if (!scroller.clientHeight) return;
    const first = Math.max(0, Math.floor(scroller.scrollTop * stretch() / row_px) - 2);
    const last = Math.min(found.length, first + Math.ceil(scroller.clientHeight / row_px) + 5);
    const drawn = [];
    const start = Math.max(0, stretch() > 1 ? scroller.scrollTop - 2 * row_px : first * row_px);
    for (let place = first; place < last; ++place) drawn.push(row(place, start + (place - first) * row_px));
    rows.replaceChildren(...drawn.length ? drawn : [h('div', {role: 'row', class: 'empty'}, h('span', {role: 'gridcell'}, 'No record matches.'))]);
  };
  const reveal = (again) => {
    const place = Math.max(0, placeOf(current)), top = topOf(place);
    if (again || top < scroller.scrollTop || top + row_px > scroller.scrollTop + scroller.clientHeight)
      scroller.scrollTop = top - (scroller.clientHeight - row_px) / 2;
    paint();
  };
  const show = (numbers, selection) => {
    found = numbers;
    height = Math.min(most_px, found.length * row_px);
    scroller.setAttribute('aria-rowcount', found.length);
    rows.style.height = `${height}px`;
    count.textContent = selection.filter || selection.kind ? `${grouped(found.length)} of ${grouped(data.size)}` : '';
    reveal(true);
  };
  new ResizeObserver(() => reveal(false)).observe(scroller);
  return {
    element,
    labelsArrived: () => paint(),
    focusFilter() { filter.focus(); filter.select(); },
    async render(selection) {
      const moved = current !== selection.n;
      current = selection.n;
      if (looked.kind === selection.kind && looked.filter === selection.filter) {
        if (moved) reveal(false);
        return;
      }
      looked.kind = selection.kind;
      looked.filter = selection.filter;
      if (filter.value.trim() !== selection.filter.trim()) filter.value = selection.filter;
      kind.value = selection.kind;
      if (!selection.filter.trim()) { show(ofKind(data, selection.kind), selection); return; }
      try {
        const numbers = await client.find(selection.filter, selection.kind);
        if (looked.filter === selection.filter && looked.kind === selection.kind) show(numbers, selection);
      } catch (problem) {
        count.textContent = problem.message;
      }
    },
  };
}
