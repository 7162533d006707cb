// Big type on the live page, for a room that looks at a projector. The choice is remembered.
import {kept} from '../kept.js';

const root = document.documentElement;
const choice = kept('big-type', false);

export const bigType = {
  get on() {
    return choice.value;
  },
  /** As it was chosen. */
  show() {
    root.classList.toggle('big-type', choice.value === true);
  },
  /** @returns whether it is on */
  toggle() {
    choice.set(!choice.value);
    bigType.show();
    return choice.value;
  },
};
