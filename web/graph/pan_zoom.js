// A picture in an SVG element that wheel and mouse zoom and move.

const farthest = 0.2; // scales
const nearest = 4;
const fitted_nearest = 1.3;
const wheel_rate = 0.0015; // of the logarithm of the scale, for each unit that the wheel turns
const drag_px = 4; // moved less, a press is a click
const edge_px = 40; // of the host, where nothing of interest should lie

export class PanZoom {
  #svg;
  #view;
  #x = 0;
  #y = 0;
  #scale = 1;
  /** Whether the whole picture is shown as fit() placed it. */
  fitted = true;

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

  /** Shows a picture of this size as a whole. */
  fit({width, height}) {
    const {clientWidth, clientHeight} = this.#svg.parentElement;
    if (!clientWidth) return;
    this.#scale = Math.min(clientWidth / width, clientHeight / height, fitted_nearest);
    this.#x = (clientWidth - width * this.#scale) / 2;
    this.#y = (clientHeight - height * this.#scale) / 2;
    this.fitted = true;
    this.#apply();
  }
  /** Moves the picture until this point of it is in sight. */
  reveal({x, y}) {
    const {clientWidth, clientHeight} = this.#svg.parentElement;
    const across = x * this.#scale + this.#x;
    const down = y * this.#scale + this.#y;
    if (across < edge_px || across > clientWidth - edge_px) this.#x += clientWidth / 2 - across;
    if (down < edge_px || down > clientHeight - edge_px) this.#y += clientHeight / 2 - down;
    this.#apply();
  }
  #apply() {
    this.#view.setAttribute('transform', `translate(${this.#x} ${this.#y}) scale(${this.#scale})`);
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
    this.#apply();
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
      this.#apply();
    };
    const done = () => {
      removeEventListener('pointermove', move);
      setTimeout(() => this.#svg.classList.remove('dragged'));
    };
    addEventListener('pointermove', move);
    addEventListener('pointerup', done, {once: true});
  }
}
