// Asks one question at a time. Questions that come meanwhile replace each other, so that only the last is asked; an answer
// that comes too late is dropped.
export class Latest {
  #wanted;
  #answered;
  #busy = false;

  /** `ask(key)` gives a promise; `show(answer, key)` and `fail(problem, key)` get what comes of the key wanted last. */
  constructor(ask, show, fail) {
    Object.assign(this, {ask, show, fail});
  }

  want(key) {
    this.#wanted = key;
    if (!this.#busy) this.#run();
  }

  async #run() {
    this.#busy = true;
    while (this.#answered !== this.#wanted) {
      const key = this.#wanted;
      try {
        const answer = await this.ask(key);
        if (key === this.#wanted) this.show(answer, key);
      } catch (problem) {
        if (key === this.#wanted) this.fail(problem, key);
      }
      this.#answered = key;
    }
    this.#busy = false;
  }
}
