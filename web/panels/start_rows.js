// The rows of a long table: stretches of them, of which only those near the part in sight are there.
import {h} from '../dom.js';

const rows_each = 40;
const row_px = 65; // of a row that has not been drawn yet
const near = '1200px 0px'; // of the window

export class Rows {
  #table;
  #make;
  #drawn;
  #items = [];
  #parts = []; // {body, there: whether its rows are}
  #seen = new IntersectionObserver((entries) => this.#moved(entries), {rootMargin: near});

  /** In `table`; `make(i)`: the rows of item i, elements or null; `drawn()` is called when rows have come. */
  constructor(table, make, drawn) {
    this.#table = table;
    this.#make = make;
    this.#drawn = drawn;
  }

  /** Shows these items, where the reader is. */
  show(items) {
    this.#items = items;
    const count = Math.ceil(items.length / rows_each);
    for (const {body} of this.#parts.splice(count)) {
      this.#seen.unobserve(body);
      body.remove();
    }
    while (this.#parts.length < count) {
      const body = h('tbody', {});
      this.#parts.push({body, there: this.#parts.length === 0});
      this.#table.append(body);
    }
    for (const part of this.#parts) this.#fill(part);
    for (const {body} of this.#parts) this.#seen.observe(body);
    this.#drawn();
  }

  #range(part) {
    const from = this.#parts.indexOf(part) * rows_each;
    return [from, Math.min(this.#items.length, from + rows_each)];
  }
  #fill(part) {
    const [from, to] = this.#range(part);
    const {body, there} = part;
    if (there) {
      const rows = [];
      for (let i = from; i < to; ++i) rows.push(...this.#make(i).filter(Boolean));
      body.replaceChildren(...rows);
      return;
    }
    const height = body.offsetHeight || (to - from) * row_px;
    const room = h('td', {class: 'room', colspan: 10});
    room.style.setProperty('height', `${height}px`);
    body.replaceChildren(h('tr', {'aria-hidden': 'true'}, room));
  }
  #moved(entries) {
    let came = false;
    for (const {target, isIntersecting} of entries) {
      const part = this.#parts.find(({body}) => body === target);
      // The element that has the focus stays.
      if (!part || part.there === isIntersecting || target.contains(document.activeElement)) continue;
      part.there = isIntersecting;
      this.#fill(part);
      came ||= isIntersecting;
    }
    if (came) this.#drawn();
  }

  /** All links of this kind from top to bottom, also those next to the one that has the focus. */
  links(selector) {
    const at = this.#parts.findIndex(({body}) => body.contains(document.activeElement));
    for (const part of [this.#parts[at - 1], this.#parts[at + 1]]) {
      if (at < 0 || !part || part.there) continue;
      part.there = true;
      this.#fill(part);
    }
    return [...this.#table.querySelectorAll(`tbody ${selector}`)];
  }
  close() {
    this.#seen.disconnect();
  }
}
