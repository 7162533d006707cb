// Answers and gestures at one press: the session's buttons, its gestures, and any other gesture by its name.
import {h} from '../dom.js';

const with_digit = 9;
// The gestures shown most come first, the others in the server's order.
const first = ['posack', 'negack', 'grab', 'release', 'lift', 'stop', 'nevermind', 'engage', 'disengage'];
const rank = ({event}) => (first.indexOf(event.name) + first.length + 1) % (first.length + 1);

const button = ({label, about, event}, key, send) =>
  h(
    'button',
    {
      type: 'button',
      title: [event.name?.replaceAll('_', ' ') === label ? '' : event.name, about].filter(Boolean).join(': ') || null,
      'aria-keyshortcuts': key ?? null,
      onclick: () => send(event),
      'data-gesture': event.name ?? null,
    },
    label.replaceAll('_', ' '),
    key && h('kbd', {'aria-hidden': 'true'}, key.toUpperCase()),
  );
const group = (name, label, buttons) => h('div', {class: name, role: 'group', 'aria-label': label}, buttons);

/** A form for a gesture by any name. */
function otherGesture(send) {
  const field = h('input', {
    type: 'text',
    'aria-label': 'Another gesture',
    placeholder: 'another, e.g. two fingers',
    autocomplete: 'off',
    'data-testid': 'other-gesture',
    title: 'A gesture that nobody knows yet can be taught: the avatar asks what it means',
  });
  const form = h('form', {class: 'other-gesture'}, field, h('button', {}, 'Show'));
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    const name = field.value.trim().replace(/\s+/g, '_');
    if (!name) return;
    send({kind: 'gesture', name, hand: 'right', phase: 'stroke'});
    field.value = '';
  });
  return form;
}

/** `state`: of the session; `send(event)`. */
export function mountPalette(state, send) {
  const buttons = state.buttons ?? [];
  const gestures = (state.gestures ?? [])
    .filter(({event}) => event?.name !== 'point')
    .toSorted((a, b) => rank(a) - rank(b));
  const digit = (i) => (i < with_digit ? String(i + 1) : null);
  const by_key = new Map([
    ...buttons.map(({key, event}) => [key?.toLowerCase(), event]),
    ...gestures.slice(0, with_digit).map(({event}, i) => [digit(i), event]),
  ]);
  const answers = buttons.map((one) => button(one, one.key, send));
  const shown = gestures.map((one, i) => button(one, digit(i), send));
  const details = h('details', {open: innerWidth > 1000}, h('summary', {}, 'Gestures'));
  details.append(group('gestures', 'Gestures', shown), otherGesture(send));
  return {
    element: h('div', {class: 'palette'}, group('answers', 'Answers', answers), details),
    /** Sends what the key stands for. @returns whether it stands for something */
    onKey(key) {
      const event = by_key.get(key);
      if (event) send(event);
      return Boolean(event);
    },
    keys: [
      ...buttons.filter(({key}) => key).map(({label, key}) => [[key], key.toUpperCase(), label]),
      [['1'], '1 – 9', 'the gestures with these digits'],
    ],
  };
}
