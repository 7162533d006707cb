// The rows of the stack panel: each symbol after the last change, and before it.
import {h, brief, shown, text} from '../dom.js';
import {keyOf} from '../terms/cells.js';
import {operationWords} from '../terms/stack_words.js';

const sign = {added: '+', removed: '−', changed: '~', same: ''};
const spoken = {added: 'added', removed: 'removed', changed: 'changed', same: 'unchanged'};
const slotsOf = (symbol) => (symbol?.slots && typeof symbol.slots === 'object' ? symbol.slots : {});
// A value in words, with the log's own form on hover.
function valueShown(value, symbol) {
  const told = typeof value === 'string' ? symbol?.told?.[value] : undefined;
  return told === undefined ? h('span', {class: 'term'}, brief(text(value))) : h('span', {title: shown(value)}, told);
}
const missing = (value) => value === undefined || value === null;

function changeOf(was, now) {
  if (missing(was)) return 'added';
  if (missing(now)) return 'removed';
  return JSON.stringify(was) === JSON.stringify(now) ? 'same' : 'changed';
}

const list = (items) => h('ul', {}, items);
const pair = (name, value) => [h('span', {class: 'name'}, name), h('span', {class: 'value'}, value)];

/**
 * A row of stackRows() as an element. `view`: {known(symbol, slot): the server's cell or undefined, jump(n, words, props):
 * a link to a record, choose(cell), ago(t): the age of an instant in words}.
 */
export const stackRow = (row, view) => h('li', {class: 'row-pair'}, before(row), after(row, view));

function before({change, before: symbol, after: next}) {
  if (!symbol) return h('div', {class: 'absent', 'aria-hidden': 'true'});
  const now = slotsOf(next);
  const kindOf = (slot, value) => (change === 'changed' && changeOf(value, now[slot]) !== 'same' ? 'left' : 'same');
  return h(
    'div',
    {class: `symbol was was-${change}`},
    h(
      'div',
      {class: 'title'},
      h('b', {}, change === 'changed' ? 'before' : `symbol ${symbol.id}`),
      change === 'removed' && h('span', {class: 'gone'}, '− removed'),
    ),
    list(
      Object.entries(slotsOf(symbol)).map(([slot, value]) =>
        h(
          'li',
          {class: `cell ${kindOf(slot, value)}`},
          h('div', {class: 'pair'}, pair(slot, valueShown(value, symbol))),
        ),
      ),
    ),
  );
}

function after({change, before: old, after: symbol}, view) {
  if (!symbol) return removed(old, view);
  const was = change === 'changed' ? slotsOf(old) : {};
  const now = slotsOf(symbol);
  const names = [...new Set([...Object.keys(now), ...Object.keys(was)])];
  // A pushed symbol takes slots over from the one below: only the slots that it has set are new.
  const marks = (slot) =>
    change === 'changed' || (change === 'added' && Object.hasOwn(symbol.slots_changed ?? {}, slot));
  const cells = names.map((slot) => cell(view, symbol, {slot, was: was[slot], now: now[slot], marks: marks(slot)}));
  return h(
    'div',
    {class: `symbol ${change}`, 'data-testid': 'symbol'},
    title(symbol, change, view),
    names.length ? list(cells) : h('p', {class: 'muted none'}, 'all slots empty'),
  );
}

function removed(symbol, view) {
  const cells = Object.entries(slotsOf(symbol)).map(([slot, was]) =>
    cell(view, symbol, {slot, was, now: null, marks: true}),
  );
  return h('div', {class: 'symbol removed narrow'}, title(symbol, 'removed', view), list(cells));
}

const title = (symbol, change, view) =>
  h(
    'div',
    {class: 'title'},
    h('span', {class: 'sign'}, sign[change]),
    h('b', {}, `symbol ${symbol.id}`),
    h('span', {class: 'unseen'}, ` ${spoken[change]}`),
    view.jump(symbol.made, `made at #${symbol.made}`),
  );

// A cell after the change, with its value before if that differs. `marks`: the change is shown.
function cell(view, symbol, {slot, was, now, marks}) {
  const known = view.known(symbol, slot);
  const change = marks ? changeOf(was, now) : 'same';
  const name = [
    sign[change] && h('span', {class: 'sign'}, sign[change]),
    change !== 'same' && h('span', {class: 'unseen'}, `${spoken[change]} `),
    slot,
  ];
  const value = [
    change !== 'same' && !missing(was) && h('del', {}, valueShown(was, symbol)),
    ' ',
    !missing(now) && h('span', {class: 'now'}, valueShown(now, symbol)),
  ];
  const content =
    missing(now) || !known
      ? h('div', {class: 'pair'}, pair(name, value))
      : h(
          'button',
          {
            type: 'button',
            class: 'pair',
            'data-cell': keyOf(known),
            'aria-pressed': 'false',
            onclick: () => view.choose(known),
          },
          pair(name, value),
        );
  return h('li', {class: `cell ${change}`}, content, known && now !== undefined && origin(view, known, slot));
}

// The time and the source of the cell's value.
const origin = (view, known, slot) =>
  h(
    'p',
    {class: 'meta'},
    view.jump(known.set, `set at #${known.set}`, {'aria-label': `set at #${known.set}: ${slot}`}),
    `, ${view.ago(known.t)}`,
    known.expression !== null && ` ← ${brief(text(known.expression))}`,
    known.origin && `, from ${known.origin.text}`,
  );

/** The stack's last change in words, from the record that made it. */
export function changeWords(record) {
  if (!record) return [];
  const {what, sets: all} = operationWords(record.kind === 'correction' ? record.kind : record.operation);
  const sets = all.filter(([, value]) => value !== 'null');
  const terms = sets.map(([slot, value], i) => [
    i > 0 && ', ',
    h('span', {class: 'term'}, `${slot} ← ${brief(value)}`),
  ]);
  return [`, ${what}`, sets.length > 0 && h('span', {class: 'sets'}, ' (', terms, ')')];
}
