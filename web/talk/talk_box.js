// The human's input: a line of text, the clicks while it was typed, and a microphone where the browser listens.
import {h} from '../dom.js';
import {placeText} from '../scene3d/scene_text.js';
import {Draft} from './draft.js';
import {mountMicrophone} from './microphone.js';

class TalkBox {
  #draft = new Draft();
  #earlier = [];
  #place = 0; // in the earlier lines
  #send;
  #clicked;
  #input;
  #microphone;
  #examples = h('div', {class: 'examples', role: 'group', 'aria-label': 'Things to say', 'data-testid': 'examples'});
  #chips = h('ul', {class: 'click-chips', 'aria-label': 'Clicks that go with the words', hidden: true});

  constructor({examples, send, clicked, said, gesture}) {
    this.#send = send;
    this.#clicked = clicked;
    this.#input = h('input', {
      type: 'text',
      class: 'talk',
      'aria-label': 'Say something',
      autocomplete: 'off',
      enterkeyhint: 'send',
      'data-testid': 'talk',
      placeholder: examples.length ? `Say something, e.g. “${examples[0]}”` : 'Say something',
      oninput: () => this.#typed(),
      onkeydown: (event) => {
        if (event.altKey && gesture(event.key)) event.preventDefault();
        else this.#onKey(event);
      },
    });
    this.#examples.append(...examples.map((text) => this.#example(text)));
    this.#microphone = mountMicrophone({heard: (event) => send(() => [event]), said});
    const say = h('button', {class: 'primary', 'data-testid': 'say'}, 'Say');
    const line = h('div', {class: 'talk-line'}, this.#input, this.#microphone?.element ?? null, say);
    this.element = h('form', {class: 'talk-box'}, this.#examples, line, this.#chips);
    this.element.addEventListener('submit', (event) => {
      event.preventDefault();
      this.#speak();
    });
  }

  #typed() {
    this.#draft.type(this.#input.value);
    this.#showClicks();
  }
  #showClicks() {
    const {clicks} = this.#draft;
    this.#clicked(clicks);
    this.#chips.hidden = !clicks.length;
    this.#chips.replaceChildren(...clicks.map((click, i) => this.#chip(click, i + 1)));
  }
  // Says it at one press. The examples go with the first words that are said.
  #example(text) {
    const say = () => {
      this.#input.value = text;
      this.#typed();
      this.#speak();
      this.focus();
    };
    return h('button', {type: 'button', onclick: say}, text);
  }
  #chip(click, number) {
    const remove = h('button', {type: 'button', 'aria-label': `Take click ${number} away`}, '×');
    remove.addEventListener('click', () => {
      this.#draft.remove(click);
      this.#showClicks();
      this.focus();
    });
    const words = ` ${this.#draft.wordOf(click)} → ${placeText(click.target)} `;
    return h('li', {'data-testid': 'click-chip', title: click.target.join(', ')}, h('b', {}, number), words, remove);
  }
  #speak() {
    const text = this.#input.value.trim();
    const make = this.#draft.take();
    if (!make) return;
    this.#examples.hidden = true;
    this.#earlier.push(text);
    this.#place = this.#earlier.length;
    this.#input.value = '';
    this.#showClicks();
    this.#send(make);
  }
  #onKey(event) {
    const by = {ArrowUp: -1, ArrowDown: 1}[event.key];
    if (event.key === 'Escape') this.#input.blur();
    if (!by || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    this.#place = Math.max(0, Math.min(this.#earlier.length, this.#place + by));
    this.#input.value = this.#earlier[this.#place] ?? '';
    this.#typed();
  }

  focus() {
    this.#input.focus();
  }
  /** Keeps a click for the words that are being typed, if there are any; null only asks. @returns whether there are */
  keeps(target) {
    if (!this.#draft.text.trim()) return false;
    if (target) {
      this.#draft.click(target);
      this.#showClicks();
    }
    return true;
  }
  close() {
    this.#microphone?.close();
  }
}

/**
 * `examples`: sentences to begin with; `send(make)`: as of SessionClient; `clicked(clicks)`: the clicks that are kept; `said(sentence)`: for the
 * reader; `gesture(key)`: shows the gesture of a key that is pressed with Alt, and whether there is one.
 */
export const mountTalkBox = (needs) => new TalkBox(needs);
