// The steps in which a term is worked out: a line to go through them, and the term with the part that is next.
import {h} from '../dom.js';
import {Printer, shorter} from '../terms/term.js';

export class Steps {
  bar = h('div', {class: 'step-bar', 'data-testid': 'steps', hidden: true});
  expression = h('code', {class: 'expression', 'data-testid': 'expression', hidden: true});
  #states = []; // by stepsAt()
  #place = 0;

  show(states) {
    this.#states = states;
    this.#place = 0;
    this.#draw();
  }
  /** Whether there is anything to step through. */
  get any() {
    return this.#states.length > 1;
  }
  stepBy(by) {
    this.#place = Math.max(0, Math.min(this.#states.length - 1, this.#place + by));
    this.#draw();
  }

  #draw() {
    this.bar.hidden = this.expression.hidden = !this.any;
    if (!this.any) return;
    const {term, redex, rule, haskell} = this.#states[this.#place];
    const end = this.#states.length - 1;
    const ended = this.#place === end;
    const held = document.activeElement?.dataset?.by;
    const words = `${this.#place} of ${end}${ended ? ': worked out' : `: next ${rule}`}`;
    this.bar.replaceChildren(
      this.#button(-1, '‹', 'Step back (Alt+←)', this.#place === 0),
      this.#button(1, '›', 'Step on (Alt+→)', ended),
      h('span', {'data-testid': 'step', role: 'status'}, words),
    );
    const pieces = new Printer({sign: 'λ', mark: redex, haskell}).pieces(term);
    this.expression.replaceChildren(
      ...pieces.map(({text, marked}) => (marked ? h('mark', {class: 'redex'}, shorter(text)) : shorter(text))),
    );
    if (held) this.bar.querySelector(`[data-by="${held}"]`)?.focus();
  }
  #button(by, sign, label, disabled) {
    const props = {type: 'button', 'data-by': by, 'aria-label': label, 'aria-disabled': String(disabled)};
    return h('button', {...props, onclick: () => this.stepBy(by)}, sign);
  }
}
