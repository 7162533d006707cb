// All records as a table that holds only the rows in sight.
import {h, panel, brief, grouped} from '../dom.js';
import {lastAtMost} from '../run_data.js';

const row_px = 22;

/** Running numbers of the records that match: `kind` '' for the stops, '*' for all; every word of `filter` occurs. */
export function matching(data, kind, filter) {
  const words = filter.toLowerCase().replaceAll('λ', '\\').split(/\s+/).filter(Boolean);
  const number = data.kinds.indexOf(kind);
  const fits = (n) => {
    if (kind !== '' && kind !== '*' && data.lanes.kind[n] !== number) return false;
    if (!words.length) return true;
    const line = `${data.kind(n)} ${data.label(n)}`.toLowerCase();
    return words.every((word) => line.includes(word));
  };
  if (kind === '') return data.lanes.interest.filter(fits);
  const found = [];
  for (let n = 0; n < data.size; ++n) if (fits(n)) found.push(n);
  return found;
}

export function mountRecords(app) {
  const {data} = app;
  const filter = h('input', {type: 'search', placeholder: 'Filter  ( / )', 'aria-label': 'Filter records by text', 'data-testid': 'filter',
    spellcheck: 'false', autocomplete: 'off', oninput: () => app.model.go({filter: filter.value}, 'slide'),
    onkeydown: (event) => { if (event.key === 'Escape' || event.key === 'Enter') { scroller.focus(); event.preventDefault(); } }});
  const counts = data.summary.counts;
  const kind = h('select', {'aria-label': 'Kind of record', 'data-testid': 'kind', onchange: () => app.model.go({kind: kind.value})},
    h('option', {value: ''}, `stops (${grouped(data.lanes.interest.length)})`),
    h('option', {value: '*'}, `everything (${grouped(data.size)})`),
    data.kinds.map((name) => h('option', {value: name}, `${name} (${grouped(counts[name])})`)));
  const count = h('span', {class: 'muted', 'data-testid': 'count'});
  const rows = h('div', {class: 'rows', role: 'presentation'});
  const scroller = h('div', {class: 'scroller', tabindex: 0, role: 'grid', 'aria-label': 'Records', 'aria-colcount': 4, onscroll: () => paint()}, rows);
  const element = panel('records', 'Records', [count, kind, filter], scroller);
  const looked = {kind: null, filter: null};
  let found = [], current = -1;

  const cell = (name, content) => h('span', {class: name, role: 'gridcell'}, content);
  const row = (place) => {
    const n = found[place];
    const name = data.kind(n);
    return h('div', {class: `row kind-${name}`, role: 'row', 'aria-rowindex': place + 1, 'aria-selected': String(n === current),
                     style: {top: `${place * row_px}px`}, onclick: () => app.jump(n), 'data-n': n},
      cell('n', `${n}`), cell('t', data.t[n].toFixed(3)), cell('kind', name), cell('label', brief(data.label(n))));
  };
  const paint = () => {
    const first = Math.max(0, Math.floor(scroller.scrollTop / row_px) - 4);
    const last = Math.min(found.length, Math.ceil((scroller.scrollTop + scroller.clientHeight) / row_px) + 4);
    const drawn = [];
    for (let place = first; place < last; ++place) drawn.push(row(place));
    rows.replaceChildren(...drawn.length ? drawn : [h('div', {role: 'row', class: 'empty'}, h('span', {role: 'gridcell'}, 'No record matches.'))]);
  };
  new ResizeObserver(paint).observe(scroller);
  return {
    element,
    focusFilter() { filter.focus(); filter.select(); },
    render(selection) {
      const fresh = looked.kind !== selection.kind || looked.filter !== selection.filter;
      if (fresh) {
        looked.kind = selection.kind;
        looked.filter = selection.filter;
        found = matching(data, selection.kind, selection.filter);
        scroller.setAttribute('aria-rowcount', found.length);
        rows.style.height = `${found.length * row_px}px`;
        count.textContent = selection.filter || selection.kind ? `${grouped(found.length)} of ${grouped(data.size)}` : '';
        if (filter.value !== selection.filter) filter.value = selection.filter;
        kind.value = selection.kind;
      }
      if (!fresh && current === selection.n) return;
      current = selection.n;
      const place = Math.max(0, lastAtMost(found, current));
      const top = place * row_px;
      if (fresh || top < scroller.scrollTop || top + row_px > scroller.scrollTop + scroller.clientHeight)
        scroller.scrollTop = top - (scroller.clientHeight - row_px) / 2;
      paint();
    },
  };
}
