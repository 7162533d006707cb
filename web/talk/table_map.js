// The table from above, for browsers that cannot draw in 3D and for those who like it better: the human sits below.
import {h, s} from '../dom.js';
import {targetOf} from './table.js';

const margin_m = 0.03; // around the table
const beyond_m = 0.12; // behind it, for the avatar's hand
const text_m = {wide: 0.022, narrow: 0.036};
const narrow_px = 800;

const words = (text, x, y, props) => s('text', {x, y, 'text-anchor': 'middle', ...props}, text);
const dot = ([x, y]) =>
  s(
    'g',
    {class: 'pointer', transform: `translate(${x} ${-y})`},
    s('circle', {r: 0.018}),
    s('circle', {class: 'core', r: 0.006}),
  );
const cross = ([x, y]) => s('path', {class: 'cross', d: `M${x - 0.03} ${-y}h0.06M${x} ${-y - 0.03}v0.06`});
const understood = ([x, y]) => s('circle', {class: 'understood', cx: x, cy: -y, r: 0.035});

/** The angle by which a pose turns about the vertical, in degrees. */
function turnOf([, , , w, i, j, k]) {
  return (Math.atan2(2 * (w * k + i * j), 1 - 2 * (j * j + k * k)) * 180) / Math.PI;
}

/** An object seen from above, with its title; `letter`: the height of the text, in metres. */
function thing(pose, outline, title, letter) {
  const {left, right, near, far, round, colour} = outline;
  const half = [(right - left) / 2, (far - near) / 2];
  const middle = [(left + right) / 2, -(near + far) / 2];
  const shape = round
    ? s('circle', {cx: middle[0], cy: middle[1], r: Math.max(...half)})
    : s('rect', {x: middle[0] - half[0], y: middle[1] - half[1], width: 2 * half[0], height: 2 * half[1], rx: 0.003});
  shape.style.fill = `rgb(${colour.join()})`;
  const below = (round ? Math.max(...half) : Math.min(...half)) + 1.1 * letter;
  return s(
    'g',
    {class: 'thing', transform: `translate(${pose[0]} ${-pose[1]})`},
    s('g', {transform: `rotate(${-turnOf(pose)})`}, shape),
    words(title, 0, below, {class: 'name', 'font-size': letter}),
  );
}

class TableMap {
  #known;
  #world;
  #letter = innerWidth < narrow_px ? text_m.narrow : text_m.wide;
  #things = s('g');
  #marks = s('g');
  #frame = 0;
  #drawn = -1; // version of the world
  controls = null;

  constructor(known, world) {
    this.#known = known;
    this.#world = world;
    const {left, right, near, far} = known.table;
    const size = [right - left + 2 * margin_m, far - near + margin_m + beyond_m];
    this.picture = s(
      'svg',
      {
        class: 'table-map',
        tabindex: 0,
        role: 'img',
        'aria-label': 'The table from above. Arrow keys move a cross on it, Enter points there.',
        'data-testid': 'table-map',
        viewBox: `${left - margin_m} ${-far - beyond_m} ${size.join(' ')}`,
      },
      s('rect', {class: 'table-top', x: left, y: -far, width: right - left, height: far - near, rx: 0.01}),
      this.#things,
      this.#marks,
    );
    this.focusable = this.picture;
    this.element = h('div', {class: 'stage map', 'data-testid': 'scene-stage', 'data-shows': 'map'}, this.picture);
  }

  #draw() {
    this.#frame = 0;
    const {version, poses, pointer, clicks} = this.#world;
    if (this.#drawn === version) return;
    this.#drawn = version;
    const {objects, outlines, titles} = this.#known;
    const there = objects.filter((name) => poses.has(name));
    const things = there.map((name) => thing(poses.get(name), outlines.get(name), titles.get(name), this.#letter));
    this.#things.replaceChildren(...things, ...this.#hand());
    this.#marks.replaceChildren(
      ...this.#world.understood.map(understood),
      ...(pointer ? [dot(pointer)] : []),
      ...(this.#world.cross ? [cross(this.#world.cross)] : []),
      ...clicks.flatMap(({target}, i) => [dot(target), this.#number(target, i + 1)]),
    );
  }
  #hand() {
    const hand = this.#world.poses.get(this.#known.hand);
    if (!hand) return [];
    const title = words('avatar’s hand', 0, -0.028, {class: 'name', 'font-size': this.#letter});
    return [s('g', {class: 'hand', transform: `translate(${hand[0]} ${-hand[1]})`}, s('circle', {r: 0.02}), title)];
  }
  #number([x, y], number) {
    return words(String(number), x, -y - 0.025, {class: 'number', 'font-size': this.#letter});
  }

  async open() {
    this.#draw();
  }
  /** The point of the table under a place of the window, or null. */
  at(x, y) {
    const box = this.picture.getScreenCTM();
    if (!box) return null;
    const place = new DOMPoint(x, y).matrixTransform(box.inverse());
    return targetOf(this.#known.table, [place.x, -place.y]);
  }
  render() {
    this.#frame ||= requestAnimationFrame(() => this.#draw());
  }
  close() {
    cancelAnimationFrame(this.#frame);
  }
}

/** `known`: of readTable(); `world`: a LiveWorld. */
export const mountTableMap = (known, world) => new TableMap(known, world);
