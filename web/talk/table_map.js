// The table from above, for browsers that cannot draw in 3D and for those who like it better: the human sits below.
import {h, s} from '../dom.js';
import {targetOf} from './table.js';

const margin_m = 0.03, beyond_m = 0.12;   // around the table; behind it, for the avatar's hand
const text_m = {wide: 0.022, narrow: 0.036}, narrow_px = 800;

export function mountTableMap(known, world) {
  const {left, right, near, far} = known.table, letter = innerWidth < narrow_px ? text_m.narrow : text_m.wide;
  const things = s('g'), marks = s('g');
  const picture = s('svg', {class: 'table-map', tabindex: 0, role: 'img', 'aria-label': 'The table from above. Arrow keys move a cross on it, Enter points there.', 'data-testid': 'table-map',
    viewBox: `${left - margin_m} ${-far - beyond_m} ${right - left + 2 * margin_m} ${far - near + margin_m + beyond_m}`},
    s('rect', {class: 'table-top', x: left, y: -far, width: right - left, height: far - near, rx: 0.01}), things, marks);
  const element = h('div', {class: 'stage map', 'data-testid': 'scene-stage', 'data-shows': 'map'}, picture);
  let frame = 0, drawn = -1;

  const words = (text, x, y, kind) => s('text', {class: kind, x, y, 'font-size': letter, 'text-anchor': 'middle'}, text);
  function thing(name) {
    const pose = world.poses.get(name), outline = known.outlines.get(name);
    if (!pose) return null;
    const [x, y, , w, i, j, k] = pose, turn = Math.atan2(2 * (w * k + i * j), 1 - 2 * (j * j + k * k)) * 180 / Math.PI;
    const half = [(outline.right - outline.left) / 2, (outline.far - outline.near) / 2], middle = [(outline.left + outline.right) / 2, -(outline.near + outline.far) / 2];
    const shape = outline.round ? s('circle', {cx: middle[0], cy: middle[1], r: Math.max(...half)})
      : s('rect', {x: middle[0] - half[0], y: middle[1] - half[1], width: 2 * half[0], height: 2 * half[1], rx: 0.003});
    shape.style.fill = `rgb(${outline.colour.join()})`;
    return s('g', {class: 'thing', transform: `translate(${x} ${-y})`}, s('g', {transform: `rotate(${-turn})`}, shape),
      words(known.titles.get(name), 0, (outline.round ? Math.max(...half) : Math.min(...half)) + 1.1 * letter, 'name'));
  }
  const dot = ([x, y], kind) => s('g', {class: kind, transform: `translate(${x} ${-y})`}, s('circle', {r: 0.018}), s('circle', {class: 'core', r: 0.006}));
  const cross = ([x, y]) => s('path', {class: 'cross', d: `M${x - 0.03} ${-y}h0.06M${x} ${-y - 0.03}v0.06`});

  function draw() {
    frame = 0;
    if (drawn === world.version) return;
    drawn = world.version;
    const hand = world.poses.get(known.hand);
    things.replaceChildren(...known.objects.map(thing).filter(Boolean),
      ...hand ? [s('g', {class: 'hand', transform: `translate(${hand[0]} ${-hand[1]})`}, s('circle', {r: 0.02}), words('avatar’s hand', 0, -0.028, 'name'))] : []);
    marks.replaceChildren(...world.understood.map((place) => s('circle', {class: 'understood', cx: place[0], cy: -place[1], r: 0.035})),
      ...world.pointer ? [dot(world.pointer, 'pointer')] : [], ...world.cross ? [cross(world.cross)] : [],
      ...world.clicks.flatMap(({target}, i) => [dot(target, 'pointer'), words(String(i + 1), target[0], -target[1] - 0.025, 'number')]));
  }

  return {
    element, picture, focusable: picture, controls: null,
    async open() { draw(); },
    at(x, y) {
      const box = picture.getScreenCTM();
      if (!box) return null;
      const place = new DOMPoint(x, y).matrixTransform(box.inverse());
      return targetOf(known.table, [place.x, -place.y]);
    },
    render() { if (!frame) frame = requestAnimationFrame(draw); },
    close() { cancelAnimationFrame(frame); },
  };
}
