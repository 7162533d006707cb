// The small pictures of the start page.
import {h} from '../dom.js';

/** Pictures are drawn by the server, which takes a while: one after the other, those that came into sight last first, so that nothing else waits. */
export class Pictures {
  #waiting = [];
  #busy = false;
  #seen = new IntersectionObserver((entries) => {
    for (const {target, isIntersecting} of entries) {
      if (!isIntersecting) continue;
      this.#seen.unobserve(target);
      this.#waiting.push(target);
    }
    this.#next();
  });
  #known = new Map();

  picture(address) {
    if (!this.#known.has(address)) {
      const image = h('img', {class: 'thumbnail', alt: '', width: 60, height: 60});
      image.wanted = address;
      this.#known.set(address, image);
      this.#seen.observe(image);
    }
    return this.#known.get(address);
  }
  close() {
    this.#seen.disconnect();
    this.#waiting = [];
  }
  #next() {
    if (this.#busy) return;
    const image = this.#waiting.pop();
    if (!image) return;
    // Scrolled past: when it comes again.
    if (!image.isConnected) {
      this.#seen.observe(image);
      this.#next();
      return;
    }
    const done = (drawn) => {
      this.#busy = false;
      if (!drawn) image.remove();
      this.#next();
    };
    this.#busy = true;
    image.onload = () => done(true);
    image.onerror = () => done(false);
    image.src = image.wanted;
  }
}
