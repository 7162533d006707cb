// Where the human talks: a line of text, what was clicked while it was typed, and a microphone where the browser listens.
import {h} from '../dom.js';
import {Draft, placed} from './draft.js';
import {mountMicrophone} from './microphone.js';

/** `send(make)`: as of SessionClient; `clicked(clicks)`: which clicks are kept; `said(sentence)`: for the reader. */
export function mountTalkBox({example, send, clicked, said}) {
  const draft = new Draft(), earlier = [];
  let place = 0;   // in what was said earlier
  const input = h('input', {type: 'text', class: 'talk', 'aria-label': 'Say something', autocomplete: 'off', enterkeyhint: 'send', 'data-testid': 'talk',
    placeholder: example ? `Say something, e.g. “${example}”` : 'Say something', oninput: typed, onkeydown: onKey});
  const chips = h('ul', {class: 'click-chips', 'aria-label': 'Clicks that go with the words', hidden: true});
  const microphone = mountMicrophone({heard: (event) => send(() => [event]), said});
  const element = h('form', {class: 'talk-box', onsubmit: (event) => { event.preventDefault(); speak(); }},
    h('div', {class: 'talk-line'}, input, microphone?.element ?? null, h('button', {class: 'primary', 'data-testid': 'say'}, 'Say')), chips);

  function typed() {
    draft.type(input.value);
    tell();
  }
  function tell() {
    clicked(draft.clicks);
    chips.hidden = !draft.clicks.length;
    chips.replaceChildren(...draft.clicks.map((click, i) => h('li', {'data-testid': 'click-chip'}, h('b', {}, i + 1), ` ${draft.wordOf(click)} → ${placed(click.target)} `,
      h('button', {type: 'button', 'aria-label': `Take click ${i + 1} away`, onclick: () => {
        draft.remove(click);
        tell();
        input.focus();
      }}, '×'))));
  }
  function speak() {
    const text = input.value.trim(), make = draft.take();
    if (!make) return;
    earlier.push(text);
    place = earlier.length;
    input.value = '';
    tell();
    send(make);
  }
  function onKey(event) {
    const by = {ArrowUp: -1, ArrowDown: 1}[event.key];
    if (event.key === 'Escape') input.blur();
    if (!by || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    place = Math.max(0, Math.min(earlier.length, place + by));
    input.value = earlier[place] ?? '';
    typed();
  }

  return {
    element,
    focus: () => input.focus(),
    /** Keeps a click for the words that are being typed, if there are any; null only asks. */
    keeps(target) {
      if (!draft.text.trim()) return false;
      if (target) {
        draft.click(target);
        tell();
      }
      return true;
    },
    close: () => microphone?.close(),
  };
}
