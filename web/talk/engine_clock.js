// The engine's time, from the server's last word about it. Pure.

export class EngineClock {
  #t = 0;
  #at = 0;
  #now;

  constructor(now = () => performance.now()) {
    this.#now = now;
    this.running = false;
    this.speed = 1;
  }

  /** The server's word: {t, running, speed}; what is left out stays. */
  told({t, running = this.running, speed = this.speed}) {
    this.#t = t;
    this.#at = this.#now();
    Object.assign(this, {running, speed});
  }
  /** Something has happened at t: it cannot be earlier now. */
  atLeast(t) {
    if (t > this.now) this.told({t});
  }

  /** Seconds. */
  get now() {
    return this.#t + (this.running ? ((this.#now() - this.#at) / 1000) * this.speed : 0);
  }
}
