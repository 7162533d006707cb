// The scene as the server draws it, one picture after another: where the browser cannot draw it. At most one request at
// a time and one every 300 ms; the latest request wins.

const pause_ms = 300;
const largest_px = 1280;
const multiple_px = 32; // sizes are multiples of this, so that a small change of the window asks for no new picture

export class Pictures {
  #address;
  #shown;
  #failed;
  #wanted = '';
  #asked = '';
  #busy = false;
  #last = -Infinity;
  #timer = 0;
  #closed = false;

  /** `address(t)`: of the picture; `shown(image)`, `failed(sentence)`: what became of it. */
  constructor({address, shown, failed}) {
    this.#address = address;
    this.#shown = shown;
    this.#failed = failed;
  }

  want(t) {
    this.#wanted = this.#address(t);
    this.#next();
  }

  #next() {
    if (this.#closed || this.#busy || this.#timer || this.#wanted === this.#asked) return;
    const wait = this.#last + pause_ms - performance.now();
    if (wait > 0)
      this.#timer = setTimeout(() => {
        this.#timer = 0;
        this.#next();
      }, wait);
    else this.#load();
  }

  async #load() {
    this.#busy = true;
    this.#last = performance.now();
    const address = (this.#asked = this.#wanted);
    const image = new Image();
    image.src = address;
    try {
      await image.decode();
      if (!this.#closed) this.#shown(image);
    } catch {
      const sentence = await reason(address);
      if (!this.#closed) this.#failed(sentence);
    }
    this.#busy = false;
    this.#next();
  }

  close() {
    this.#closed = true;
    clearTimeout(this.#timer);
  }
}

/** Why there is no picture: an image does not tell. */
async function reason(address) {
  try {
    const response = await fetch(address, {headers: {Accept: 'application/json'}});
    const body = response.ok ? null : await response.json();
    return body?.error?.message ?? 'The picture could not be read.';
  } catch {
    return 'The server does not answer.';
  }
}

/** [width, height] of a picture that fills the element. */
export function pictureSize(element) {
  const {width, height} = element.getBoundingClientRect();
  const scale = Math.min(devicePixelRatio || 1, largest_px / Math.max(width, height, 1));
  return [width, height].map((length) =>
    Math.max(multiple_px, Math.round((length * scale) / multiple_px) * multiple_px),
  );
}
