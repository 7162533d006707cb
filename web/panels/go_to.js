// Goes to a record, an instant or a state that is typed in: 137 or #137, 12.48s or 1:02, the name of a state.
import {dialog, h} from '../dom.js';
import {lastAtMost} from '../search.js';

// The last record up to time t that is worth stopping at; before the first of them the first.
function stopBefore(data, t) {
  const {stops} = data;
  if (!stops.length) return data.at(t);
  return stops[Math.max(0, lastAtMost(stops, data.at(t)))];
}

/** The record that the text means, seen from record n, or null. */
export function placeOf(data, text, n) {
  const stopAt = (t) => stopBefore(data, t);
  const record = /^#?(\d+)$/.exec(text);
  if (record) return Number(record[1]) < data.size ? Number(record[1]) : null;
  const clock = /^(\d+):(\d{1,2}(?:\.\d+)?)$/.exec(text);
  const seconds = /^(\d+(?:\.\d+)?)\s*s?$/.exec(text);
  if (clock) return stopAt(Number(clock[1]) * 60 + Number(clock[2]));
  if (seconds) return stopAt(Number(seconds[1]));
  const state = data.graph.states.find(({id}) => id.toLowerCase().startsWith(text.toLowerCase()));
  if (!state || !text) return null;
  const wanted = data.names.indexOf(state.id);
  const {to, n: numbers} = data.steps;
  const from = data.step(n) + 1;
  for (let i = 0; i < numbers.length; ++i) {
    const place = (from + i) % numbers.length;
    if (to[place] === wanted) return numbers[place];
  }
  return null;
}

export function goToDialog({cursor}) {
  const field = h('input', {
    type: 'text',
    'aria-label': 'Record, instant or state',
    placeholder: '#137, 12.48 s or a state',
    'data-testid': 'go-to',
    spellcheck: 'false',
    autocomplete: 'off',
    onkeydown: (event) => {
      if (event.key === 'Enter') {
        event.preventDefault();
        go();
      }
    },
  });
  const trouble = h(
    'p',
    {class: 'trouble', role: 'alert', hidden: true},
    'There is no such record, instant or state in this run.',
  );
  const element = dialog(
    {class: 'dialog', 'aria-label': 'Go to'},
    h('h2', {}, 'Go to'),
    field,
    trouble,
    h(
      'div',
      {class: 'dialog-buttons'},
      h('button', {type: 'button', onclick: () => element.close()}, 'Close'),
      h('button', {type: 'button', class: 'primary', onclick: () => go()}, 'Go'),
    ),
  );
  const go = () => {
    const n = placeOf(cursor.data, field.value.trim(), cursor.n);
    trouble.hidden = n !== null;
    if (n === null) return;
    element.close();
    cursor.jump(n);
  };
  return {
    element,
    open() {
      field.value = '';
      trouble.hidden = true;
      element.showModal();
      field.focus();
    },
  };
}
