// The pace of drawing where WebGL runs without a graphics card: a moving picture is drawn coarsely and not with every
// frame, and sharp at rest.

const slow_every_ms = 100; // a page that is scrubbed has the time between for itself
const sharp_after_ms = 250;

export class Pace {
  #wake;
  #touch;
  #timer = 0;
  #drawn_at = -Infinity;
  /** Whether the last picture was to be coarse. */
  coarse = false;

  /** `wake()`: looks again whether there is something to draw; `touch()`: draws again. */
  constructor(wake, touch) {
    this.#wake = wake;
    this.#touch = touch;
  }

  /** Whether it is time to draw; if not, it wakes when it is. What came to rest is drawn again, sharp. */
  due() {
    clearTimeout(this.#timer);
    const since = performance.now() - this.#drawn_at;
    if (since < slow_every_ms) {
      this.#timer = setTimeout(this.#wake, slow_every_ms - since);
      return false;
    }
    this.coarse = since < sharp_after_ms;
    if (this.coarse) this.#timer = setTimeout(this.#touch, sharp_after_ms + slow_every_ms);
    this.#drawn_at = performance.now();
    return true;
  }
  close() {
    clearTimeout(this.#timer);
  }
}
