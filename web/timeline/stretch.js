// A stretch of time that the reader has drawn over the timeline: what happened in it, and what can be done with it.
import {h, clock, counted} from '../dom.js';
import {lastAtMost} from '../search.js';

const told = [
  ['speech', 'sentence of the human', 'sentences of the human'],
  ['gesture', 'gesture'],
  ['utterance', 'sentence of the avatar', 'sentences of the avatar'],
  ['act', 'act'],
  ['flag', 'trouble'],
];

/** What began between two instants, in words. Pure. */
export function contentOf(lanes, [from, to]) {
  const count = ({from: begins}) => lastAtMost(begins, to) - lastAtMost(begins, from - 1e-9);
  const parts = told.map(([lane, one, many]) => [count(lanes[lane]), one, many]).filter(([number]) => number > 0);
  return parts.map(([number, one, many]) => counted(number, one, many)).join(', ') || 'nothing was said or done';
}

export class Stretch {
  band = h('div', {class: 'stretch', hidden: true});
  card = h('div', {class: 'stretch-card', role: 'status', hidden: true, 'data-testid': 'stretch'});
  #lanes;
  #acts;
  #span = null; // [from, to], seconds

  /** `acts`: {zoom(span), note(span), link(span), save(span)}; `save` may take a while, and fail. */
  constructor(lanes, acts) {
    this.#lanes = lanes;
    this.#acts = acts;
  }

  /** While it is drawn: `x` gives the place of an instant, in pixels. */
  draw(span, x) {
    this.#span = span.toSorted((a, b) => a - b);
    this.place(x);
  }
  /** Puts the band where its instants are now. */
  place(x) {
    this.band.hidden = !this.#span;
    if (!this.#span) return;
    const [left, right] = this.#span.map(x);
    this.band.style.setProperty('left', `${left}px`);
    this.band.style.setProperty('width', `${Math.max(1, right - left)}px`);
  }
  /** It is drawn: tells about it, and offers what can be done. */
  done() {
    const span = this.#span;
    const button = (text, act) =>
      h(
        'button',
        {
          type: 'button',
          onclick: async () => {
            this.clear();
            try {
              await act(span);
            } catch (problem) {
              this.#tell(h('span', {class: 'trouble'}, `${text} did not work: ${problem.message}`));
            }
          },
        },
        text,
      );
    const [from, to] = span.map((t) => clock(t, 2));
    this.#tell(
      h('span', {}, `${from} – ${to}, ${(span[1] - span[0]).toFixed(1)} s: ${contentOf(this.#lanes, span)}`),
      button('Zoom', this.#acts.zoom),
      button('Note', this.#acts.note),
      button('Copy link', this.#acts.link),
      button('Export this stretch', this.#acts.save),
    );
  }
  #tell(...parts) {
    const away = h('button', {type: 'button', 'aria-label': 'Put away', onclick: () => this.clear()}, '×');
    this.card.replaceChildren(...parts, away);
    this.card.hidden = false;
  }
  clear() {
    this.#span = null;
    this.band.hidden = this.card.hidden = true;
  }
}
