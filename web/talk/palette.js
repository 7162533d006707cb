// What can be answered and shown with one press: the session's buttons, its gestures, and any other gesture by its name.
import {h} from '../dom.js';

const with_digit = 9;
// What is shown most comes first, the rest as the server has it.
const first = ['posack', 'negack', 'grab', 'release', 'lift', 'stop', 'nevermind', 'engage', 'disengage'];
const rank = ({event}) => (first.indexOf(event.name) + first.length + 1) % (first.length + 1);

/** `state`: of the session; `send(event)`. */
export function mountPalette(state, send) {
  const buttons = state.buttons ?? [], gestures = (state.gestures ?? []).filter(({event}) => event?.name !== 'point').toSorted((a, b) => rank(a) - rank(b));
  const by_key = new Map([...buttons.map(({key, event}) => [key?.toLowerCase(), event]), ...gestures.slice(0, with_digit).map(({event}, i) => [String(i + 1), event])]);
  const button = ({label, about, event}, key) => h('button', {type: 'button', title: about || null, 'aria-keyshortcuts': key ?? null, onclick: () => send(event), 'data-gesture': event.name ?? null},
    label.replaceAll('_', ' '), key && h('kbd', {'aria-hidden': 'true'}, key.toUpperCase()));
  const other = h('input', {type: 'text', 'aria-label': 'Another gesture', placeholder: 'another, e.g. two fingers', autocomplete: 'off', 'data-testid': 'other-gesture',
    title: 'A gesture that nobody knows yet can be taught: the avatar asks what it means'});
  const show = (event) => {
    event.preventDefault();
    const name = other.value.trim().replace(/\s+/g, '_');
    if (!name) return;
    send({kind: 'gesture', name, hand: 'right', phase: 'stroke'});
    other.value = '';
  };
  const element = h('div', {class: 'palette'},
    h('div', {class: 'answers', role: 'group', 'aria-label': 'Answers'}, buttons.map((one) => button(one, one.key))),
    h('details', {open: innerWidth > 1000}, h('summary', {}, 'Gestures'),
      h('div', {class: 'gestures', role: 'group', 'aria-label': 'Gestures'}, gestures.map((one, i) => button(one, i < with_digit ? String(i + 1) : null))),
      h('form', {class: 'other-gesture', onsubmit: show}, other, h('button', {}, 'Show'))));
  return {
    element,
    /** Whether the key stands for something here; then it is sent. */
    onKey(key) {
      const event = by_key.get(key);
      if (event) send(event);
      return Boolean(event);
    },
    keys: [...buttons.filter(({key}) => key).map(({label, key}) => [[key], key.toUpperCase(), label]), [['1'], '1 – 9', 'the gestures with these digits']],
  };
}
