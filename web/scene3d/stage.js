// The surface the scene is shown on: drawn here where the browser has WebGL and three.js was built in, else as pictures
// of the server. Keeps to one drawing a frame, and to none while nothing changed or nobody can see it.
import {h} from '../dom.js';
import {coloursOf} from './colours.js';
import {orbit} from './orbit.js';
import {Pictures} from './pictures.js';
import {SceneView} from './view.js';

const flight_ms = 350;
// Where WebGL runs without a graphics card: what moves is drawn coarsely and not with every frame, and sharp at rest.
const slow_ratio = 0.5, slow_every_ms = 40, sharp_after_ms = 250;
const largest_picture = 1280, coarse = 32;  // pixels; sizes of pictures are multiples of the latter

export class Stage {
  #element; #three; #address; #changed; #before; #after; #resized; #lost;
  #frame = 0;
  #dirty = true;
  #seen = false;
  #flight = null;
  #goal = null;
  #closed = false;
  #slow = false;
  #coarse = false;
  #drawn_at = -Infinity;
  #timer = 0;
  #sizes; #sight;
  #theme = '';
  #view = null;
  #pictures = null;

  /**
   * `three`: loads three.js, or null; `address(t, width, height)`: of the server's picture, or null; `before(view)`: called before
   * a frame is drawn, gives whether there is something new to draw; `after(view)`: it was drawn; `resized(view)`;
   * `changed()`: the view was turned by hand; `click(body)`: a body was clicked, or null; `lost()`: called instead of showing
   * the server's pictures; `pointing`: as of orbit().
   */
  constructor({three, address = null, before, after, resized, changed, click = () => {}, lost = null, pointing = false}) {
    this.#three = three;
    this.#address = address;
    this.#before = before;
    this.#after = after;
    this.#resized = resized;
    this.#changed = changed;
    this.#lost = lost;
    this.canvas = h('canvas', {tabindex: 0, role: 'img', 'aria-label': 'The scene', 'data-testid': 'scene-canvas'});
    this.tags = h('div', {class: 'tags', 'aria-hidden': 'true'});
    this.element = this.#element = h('div', {class: 'stage', 'data-testid': 'scene-stage', 'data-shows': 'nothing'}, this.canvas, this.tags);
    this.#sizes = new ResizeObserver(() => this.#resize());
    this.#sight = new IntersectionObserver((entries) => {
      this.#seen = entries.at(-1).isIntersecting;
      if (this.#seen) this.wake();
    });
    this.#sizes.observe(this.#element);
    this.#sight.observe(this.#element);
    // A lost context is not waited for: pictures take over.
    this.canvas.addEventListener('webglcontextlost', () => { if (!this.#closed) this.#toPictures(); });
    orbit(this.canvas, {get: () => this.view, set: (view) => { this.#flight = null; this.view = view; this.#changed(); },
      click: (x, y) => { if (this.#view) click(this.#view.pick(x, y)); }, pointing});
  }

  /** What draws, or null: while it is loading, and where pictures are shown. */
  get drawing() { return this.#view; }
  get draws() { return this.#view?.draws ?? 0; }
  get view() { return this.#view?.view ?? null; }
  set view(view) {
    if (!this.#view || !view) return;
    this.#view.look(view);
    this.touch();
  }

  /** Begins with this scene: loads what is needed to draw it. */
  async open(scene) {
    const context = this.#three && this.#context();
    if (!context) { this.#toPictures(); return; }
    try {
      const THREE = await this.#three();
      if (this.#closed || this.#pictures) return;
      this.#view = new SceneView(THREE, this.canvas, context, scene, coloursOf(this.#element));
      this.#element.dataset.shows = 'drawing';
      this.#resize();
      this.touch();
    } catch {
      if (!this.#closed) this.#toPictures();
    }
  }

  #context() {
    const fast = this.canvas.getContext('webgl2', {alpha: true, antialias: true, failIfMajorPerformanceCaveat: true});
    this.#slow = !fast;
    return fast ?? this.canvas.getContext('webgl2', {alpha: true, antialias: false});
  }

  #toPictures() {
    this.#view?.close();
    this.#view = null;
    if (this.#lost) { this.#lost(); return; }
    this.#element.dataset.shows = 'pictures';
    this.tags.replaceChildren();
    const show = (...children) => {
      this.#element.querySelector('.picture')?.remove();
      this.#element.append(h('div', {class: 'picture'}, ...children));
    };
    const failed = (sentence) => show(h('p', {class: 'empty', 'data-testid': 'scene-no-picture'}, `The scene cannot be drawn here. ${sentence}`));
    this.canvas.hidden = true;
    if (!this.#address) {
      failed('There is no server that could.');
      return;
    }
    this.#pictures = new Pictures({
      address: (t) => {
        const box = this.#element.getBoundingClientRect(), scale = Math.min(devicePixelRatio || 1, largest_picture / Math.max(box.width, box.height, 1));
        const side = (length) => Math.max(coarse, Math.round(length * scale / coarse) * coarse);
        return this.#address(t, side(box.width), side(box.height));
      },
      shown: (image) => {
        image.alt = this.canvas.getAttribute('aria-label');
        image.dataset.testid = 'scene-picture';
        show(image);
      },
      failed,
    });
    this.touch();
  }

  /** Something changed: draws with the next frame. */
  touch() {
    this.#dirty = true;
    this.#request();
  }
  /** Time may have passed: looks with the next frame whether there is something to draw. */
  wake() { this.#request(); }
  describe(sentence) {
    this.canvas.setAttribute('aria-label', sentence);
    const image = this.#element.querySelector('.picture img');
    if (image) image.alt = sentence;
  }

  /** Goes to a view, in a curve unless motion is to be avoided. */
  fly(view) {
    if (!this.#view) return;
    this.#goal = null;
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) { this.view = view; return; }
    this.#flight = {from: this.view, to: view, since: performance.now()};
    this.touch();
  }
  /** Keeps looking at this point; null: no longer. */
  follow(point) {
    this.#goal = point;
    if (point) this.touch();
  }

  #request() {
    if (this.#frame || this.#closed || !this.#seen) return;
    this.#frame = requestAnimationFrame(() => { this.#frame = 0; this.#turn(); });
  }

  #turn() {
    const theme = `${document.documentElement.dataset.theme} ${matchMedia('(prefers-color-scheme: dark)').matches}`;
    if (this.#view && theme !== this.#theme) {
      this.#theme = theme;
      this.#view.recolour(coloursOf(this.#element));
      this.#dirty = true;
    }
    if (this.#before(this.#view, this.#pictures)) this.#dirty = true;
    if (!this.#view || !this.#dirty || !this.#view.size) return;
    if (this.#slow && !this.#paced()) return;
    this.#dirty = false;
    this.#move();
    this.#view.draw();
    this.#after(this.#view);
  }

  /** Whether it is time to draw; sees to it that it will be, and that what came to rest is drawn sharp. */
  #paced() {
    clearTimeout(this.#timer);
    const since = performance.now() - this.#drawn_at, moving = since < sharp_after_ms;
    if (since < slow_every_ms) {
      this.#timer = setTimeout(() => this.wake(), slow_every_ms - since);
      return false;
    }
    if (moving !== this.#coarse) this.#sharpen(moving);
    if (moving) this.#timer = setTimeout(() => this.touch(), sharp_after_ms + slow_every_ms);
    this.#drawn_at = performance.now();
    return true;
  }
  #sharpen(coarse) {
    this.#coarse = coarse;
    this.#view.resize(...this.#view.size, coarse ? slow_ratio : devicePixelRatio || 1);
  }

  #move() {
    if (this.#flight) {
      const {from, to, since} = this.#flight, part = Math.min(1, (performance.now() - since) / flight_ms);
      this.#view.towards(from, to, part);
      if (part === 1) this.#flight = null; else this.touch();
    } else if (this.#goal) {
      const away = this.#goal.map((x, i) => x - this.view.target[i]);
      const near = Math.hypot(...away) < 0.001 || matchMedia('(prefers-reduced-motion: reduce)').matches;
      this.#view.look({...this.view, target: this.view.target.map((x, i) => x + (near ? 1 : 0.2) * away[i])});
      if (!near) this.touch();
    }
  }

  #resize() {
    const {clientWidth, clientHeight} = this.#element;
    if (!clientWidth || !clientHeight) return;
    if (this.#view) {
      this.#coarse = false;
      this.#view.resize(clientWidth, clientHeight, devicePixelRatio || 1);
      this.#resized(this.#view);
    }
    this.touch();
  }

  close() {
    this.#closed = true;
    cancelAnimationFrame(this.#frame);
    clearTimeout(this.#timer);
    this.#sizes.disconnect();
    this.#sight.disconnect();
    this.#pictures?.close();
    this.#view?.close();
    this.#view = null;
  }
}
