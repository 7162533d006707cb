// A picture in an SVG element that wheel and mouse zoom and move. Left alone it shows all of the picture, or where that
// would be too small to read the part of interest.

const farthest = 0.2; // scales
const nearest = 4;
const fitted_nearest = 1.3;
const legible = 1; // the letters of the picture are then as small as letters of a page may be
const wheel_rate = 0.0015; // of the logarithm of the scale, for each unit that the wheel turns
const drag_px = 4; // moved less, a press is a click
const edge_px = 40; // of the host, where nothing of interest should lie

const middle = ({from, to}) => (from + to) / 2;

export class PanZoom {
  #svg;
  #view;
  #x = 0;
  #y = 0;
  #scale = 1;
  /** Whether the picture is placed by fit() and follow(), not by the reader. */
  fitted = true;
  /** Whether all of it is in sight as fit() placed it. */
  whole = true;

  /** `view`: the group in `svg` that moves; `svg` fills its parent. */
  constructor(svg, view) {
    this.#svg = svg;
    this.#view = view;
    svg.addEventListener('wheel', (event) => this.#wheel(event), {passive: false});
    svg.addEventListener('pointerdown', (event) => this.#press(event));
    // A drag that ends on a part of the picture does not press it.
    const afterDrag = (event) => {
      if (svg.classList.contains('dragged')) event.stopPropagation();
    };
    svg.addEventListener('click', afterDrag, true);
  }

  get #room() {
    const {clientWidth: width, clientHeight: height} = this.#svg.parentElement;
    return {width, height};
  }

  /** Shows a picture of this size: all of it, if it can be read then. */
  fit({width, height}) {
    const room = this.#room;
    if (!room.width) return;
    const scale = Math.min(room.width / width, room.height / height, fitted_nearest);
    this.whole = scale >= legible;
    this.#scale = Math.max(legible, scale);
    this.#x = (room.width - width * this.#scale) / 2;
    this.#y = (room.height - height * this.#scale) / 2;
    this.fitted = true;
    this.#glide(false);
  }
  /**
   * Moves a picture of this size, too large to be shown as a whole, so that the boxes, {x, y, w, h} about their middles,
   * are in sight: the first in any case, of the others as many as there is room for. `calmly`: in a short glide.
   */
  follow(boxes, {width, height}, calmly) {
    if (this.whole || !boxes.length) return;
    const room = this.#room;
    const across = inSight(boxes, 'x', 'w', room.width / this.#scale);
    const down = inSight(boxes, 'y', 'h', room.height / this.#scale);
    this.#x = placed(room.width, width * this.#scale, middle(across) * this.#scale);
    this.#y = placed(room.height, height * this.#scale, middle(down) * this.#scale);
    this.#glide(calmly);
  }
  /** Whether the element, placed over the picture, covers one of the boxes in it, {x, y, w, h} about their middles. */
  covered({offsetLeft: left, offsetTop: top, offsetWidth: width, offsetHeight: height}, boxes) {
    const apart = (at, size, from, length) => at + size / 2 <= from || at - size / 2 >= from + length;
    return boxes.some(
      ({x, y, w, h}) =>
        !apart(x * this.#scale + this.#x, w * this.#scale, left, width) &&
        !apart(y * this.#scale + this.#y, h * this.#scale, top, height),
    );
  }
  /** Moves the picture until this point of it is in sight. */
  reveal({x, y}) {
    const {width, height} = this.#room;
    const across = x * this.#scale + this.#x;
    const down = y * this.#scale + this.#y;
    if (across < edge_px || across > width - edge_px) this.#x += width / 2 - across;
    if (down < edge_px || down > height - edge_px) this.#y += height / 2 - down;
    this.#glide(true);
  }
  #glide(calmly) {
    this.#view.classList.toggle('gliding', calmly);
    this.#apply();
  }
  #apply() {
    this.#view.style.transform = `translate(${this.#x}px, ${this.#y}px) scale(${this.#scale})`;
  }

  // The point under the mouse stays there.
  #wheel(event) {
    event.preventDefault();
    const box = this.#svg.getBoundingClientRect();
    const x = event.clientX - box.left;
    const y = event.clientY - box.top;
    const scale = Math.max(farthest, Math.min(nearest, this.#scale * Math.exp(-event.deltaY * wheel_rate)));
    this.#x = x - (x - this.#x) * (scale / this.#scale);
    this.#y = y - (y - this.#y) * (scale / this.#scale);
    this.#scale = scale;
    this.fitted = false;
    this.#glide(false);
  }
  #press(event) {
    if (event.button !== 0) return;
    let {clientX: x, clientY: y} = event;
    let far = 0;
    const move = (moved) => {
      far += Math.abs(moved.clientX - x) + Math.abs(moved.clientY - y);
      if (far < drag_px) return;
      this.#svg.classList.add('dragged');
      this.#x += moved.clientX - x;
      this.#y += moved.clientY - y;
      x = moved.clientX;
      y = moved.clientY;
      this.fitted = false;
      this.#glide(false);
    };
    const done = () => {
      removeEventListener('pointermove', move);
      setTimeout(() => this.#svg.classList.remove('dragged'));
    };
    addEventListener('pointermove', move);
    addEventListener('pointerup', done, {once: true});
  }
}

// The stretch that holds the first box and as many of the next as fit into `room`.
function inSight(boxes, place, size, room) {
  let held = null;
  for (const box of boxes) {
    const from = Math.min(box[place] - box[size] / 2, held?.from ?? Infinity);
    const to = Math.max(box[place] + box[size] / 2, held?.to ?? -Infinity);
    if (!held || to - from <= room - edge_px) held = {from, to};
  }
  return held;
}
// The shift of a picture of this size that brings its place `at` to the middle, without leaving room empty at its ends.
const placed = (room, size, at) =>
  size <= room ? (room - size) / 2 : Math.max(room - size, Math.min(0, room / 2 - at));
