// The way that the automaton took lately, fading, and the token that goes along it.
import {s} from '../dom.js';

const trail_s = 10;
const most_steps = 12;
const move_ms = 320;

const calm = matchMedia('(prefers-reduced-motion: reduce)');

export class Trail {
  token = s('circle', {class: 'token', r: 6, visibility: 'hidden'});
  #data;
  #lit = [];
  #step = -1;
  #frame = 0;

  constructor(data) {
    this.#data = data;
  }

  /** Shows the way to the step at this place of `data.steps`; `edgeOf({from, to})`: the element of an arrow, or undefined. */
  show(step, edgeOf, moves) {
    for (const one of this.#lit) one.classList.remove('trail');
    this.#lit = [];
    const {n} = this.#data.steps;
    const {t} = this.#data;
    for (let i = step - 1; i >= 0 && step - i <= most_steps && t[n[step]] - t[n[i]] <= trail_s; --i) {
      const edge = edgeOf(this.#data.stepAt(i));
      if (!edge || edge.classList.contains('trail')) continue;
      edge.classList.add('trail');
      edge.style.setProperty('--age', ((step - i) / (most_steps + 1)).toFixed(2));
      this.#lit.push(edge);
    }
    const next = step === this.#step + 1;
    this.#step = step;
    if (step < 0 || !next || !moves || calm.matches) this.#rest();
    else this.#move(edgeOf(this.#data.stepAt(step)));
  }
  #rest() {
    cancelAnimationFrame(this.#frame);
    this.token.setAttribute('visibility', 'hidden');
  }
  #move(edge) {
    cancelAnimationFrame(this.#frame);
    const way = edge?.querySelector('.stroke');
    if (!way) return;
    const length = way.getTotalLength();
    const began = performance.now();
    this.token.setAttribute('visibility', 'visible');
    const draw = (now) => {
      const part = Math.min(1, (now - began) / move_ms);
      const {x, y} = way.getPointAtLength(length * part);
      this.token.setAttribute('cx', x);
      this.token.setAttribute('cy', y);
      if (part < 1) this.#frame = requestAnimationFrame(draw);
      else this.#rest();
    };
    this.#frame = requestAnimationFrame(draw);
  }
  close() {
    cancelAnimationFrame(this.#frame);
  }
}
