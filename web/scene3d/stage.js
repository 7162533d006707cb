// The surface that shows the scene: drawn here where the browser has WebGL and three.js was built in, else as pictures of
// the server. Draws at most once a frame, and not at all while nothing changed or nobody can see it.
import {h} from '../dom.js';
import {themeKey} from '../theme.js';
import {CameraMotion} from './camera_motion.js';
import {coloursOf} from './colours.js';
import {orbit} from './orbit.js';
import {Pace} from './pace.js';
import {Pictures, pictureSize} from './pictures.js';
import {SceneView} from './view.js';

const coarse_ratio = 0.5; // of the screen's pixels

export class Stage {
  #three;
  #address;
  #tell; // {before, after, resized, changed, click, lost}
  #frame = 0;
  #dirty = true;
  #seen = false;
  #closed = false;
  #slow = false; // WebGL without a graphics card
  #coarse = false;
  #camera = new CameraMotion();
  #pace = new Pace(
    () => this.wake(),
    () => this.touch(),
  );
  #sizes = new ResizeObserver(() => this.#resize());
  #sight = new IntersectionObserver((entries) => {
    this.#seen = entries.at(-1).isIntersecting;
    if (this.#seen) this.wake();
  });
  #theme = '';
  #view = null;
  #pictures = null;

  canvas = h('canvas', {tabindex: 0, role: 'img', 'aria-label': 'The scene', 'data-testid': 'scene-canvas'});
  tags = h('div', {class: 'tags', 'aria-hidden': 'true'});
  element = h('div', {class: 'stage', 'data-testid': 'scene-stage', 'data-shows': 'nothing'}, this.canvas, this.tags);

  /**
   * `three`: loads three.js, or null; `address(t, width, height)`: of the server's picture, or null; `before(view)`: called
   * before a frame is drawn, gives whether there is something new to draw; `after(view)`: it was drawn; `resized(view)`;
   * `changed()`: the view was turned by hand; `click(body)`: a body was clicked, or null; `lost()`: called instead of
   * showing the server's pictures; `pointing`, `grab`: as of orbit().
   */
  constructor({three, address = null, pointing = false, grab, ...tell}) {
    this.#three = three;
    this.#address = address;
    this.#tell = tell;
    this.#sizes.observe(this.element);
    this.#sight.observe(this.element);
    // Pictures take over from a lost context at once.
    this.canvas.addEventListener('webglcontextlost', () => {
      if (!this.#closed) this.#toPictures();
    });
    orbit(this.canvas, {
      get: () => this.view,
      set: (view) => this.#turnedTo(view),
      click: (x, y) => {
        if (this.#view) tell.click?.(this.#view.pick(x, y));
      },
      grab,
      pointing,
    });
  }

  /** The SceneView that draws, or null: while it is loading, and where pictures are shown. */
  get drawing() {
    return this.#view;
  }
  get draws() {
    return this.#view?.draws ?? 0;
  }
  get view() {
    return this.#view?.view ?? null;
  }
  set view(view) {
    if (!this.#view || !view) return;
    this.#view.look(view);
    this.touch();
  }
  #turnedTo(view) {
    this.#camera.land();
    this.view = view;
    this.#tell.changed();
  }

  /** Begins with this scene: loads what is needed to draw it. */
  async open(scene) {
    const context = this.#three && this.#context();
    if (!context) {
      this.#toPictures();
      return;
    }
    try {
      const THREE = await this.#three();
      if (this.#closed || this.#pictures) return;
      this.#view = new SceneView(THREE, this.canvas, context, scene, coloursOf(this.element));
      this.element.dataset.shows = 'drawing';
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
    if (this.#tell.lost) {
      this.#tell.lost();
      return;
    }
    this.element.dataset.shows = 'pictures';
    this.tags.replaceChildren();
    this.canvas.hidden = true;
    if (!this.#address) {
      this.#refuse('There is no server that could.');
      return;
    }
    this.#pictures = new Pictures({
      address: (t) => this.#address(t, ...pictureSize(this.element)),
      shown: (image) => {
        image.alt = this.canvas.getAttribute('aria-label');
        image.dataset.testid = 'scene-picture';
        this.#showPicture(image);
      },
      failed: (sentence) => this.#refuse(sentence),
    });
    this.touch();
  }
  #showPicture(content) {
    this.element.querySelector('.picture')?.remove();
    this.element.append(h('div', {class: 'picture'}, content));
  }
  #refuse(sentence) {
    const words = `The scene cannot be drawn here. ${sentence}`;
    this.#showPicture(h('p', {class: 'empty', 'data-testid': 'scene-no-picture'}, words));
  }

  /** Something changed: draws with the next frame. */
  touch() {
    this.#dirty = true;
    this.wake();
  }
  /** Time may have passed: looks with the next frame whether there is something to draw. */
  wake() {
    if (this.#frame || this.#closed || !this.#seen) return;
    this.#frame = requestAnimationFrame(() => {
      this.#frame = 0;
      this.#turn();
    });
  }
  describe(sentence) {
    this.canvas.setAttribute('aria-label', sentence);
    const image = this.element.querySelector('.picture img');
    if (image) image.alt = sentence;
  }

  /** Goes to a view, in a curve unless motion is to be avoided. */
  fly(view) {
    if (!this.#view) return;
    if (this.#camera.fly(this.view, view)) this.touch();
    else this.view = view;
  }
  /** Keeps looking at this point; null: no longer. */
  follow(point) {
    this.#camera.follow(point);
    if (point) this.touch();
  }

  #turn() {
    const theme = themeKey();
    if (this.#view && theme !== this.#theme) {
      this.#theme = theme;
      this.#view.recolour(coloursOf(this.element));
      this.#dirty = true;
    }
    if (this.#tell.before(this.#view, this.#pictures)) this.#dirty = true;
    if (!this.#view || !this.#dirty || !this.#view.size) return;
    if (this.#slow && !this.#paced()) return;
    this.#dirty = false;
    if (this.#camera.move(this.#view)) this.touch();
    this.#view.draw();
    this.#tell.after(this.#view);
  }
  #paced() {
    if (!this.#pace.due()) return false;
    if (this.#pace.coarse !== this.#coarse) this.#setSharpness(this.#pace.coarse);
    return true;
  }
  #setSharpness(coarse) {
    this.#coarse = coarse;
    this.#view.resize(...this.#view.size, coarse ? coarse_ratio : devicePixelRatio || 1);
  }

  #resize() {
    const {clientWidth, clientHeight} = this.element;
    if (!clientWidth || !clientHeight) return;
    if (this.#view) {
      this.#coarse = false;
      this.#view.resize(clientWidth, clientHeight, devicePixelRatio || 1);
      this.#tell.resized(this.#view);
    }
    this.touch();
  }

  close() {
    this.#closed = true;
    cancelAnimationFrame(this.#frame);
    this.#pace.close();
    this.#sizes.disconnect();
    this.#sight.disconnect();
    this.#pictures?.close();
    this.#view?.close();
    this.#view = null;
  }
}
