// Turning, shifting and approaching a view by mouse, touch and keys. Changes the view it is given and says so.
import {axes} from './framing.js';

const steepest = (89 * Math.PI) / 180;
const clamp = (x, low, high) => Math.max(low, Math.min(high, x));

export const turned = (view, azimuth, elevation) => ({
  ...view,
  azimuth: view.azimuth + azimuth,
  elevation: clamp(view.elevation + elevation, -steepest, steepest),
});
export const approached = (view, factor) => ({...view, distance: clamp(view.distance * factor, 0.05, 50)});
/** Shifted by parts of the picture's height, right and up in the picture. */
export function shifted(view, by_right, by_up) {
  const {right, up} = axes(view);
  const height = 2 * view.distance * Math.tan(view.fovy / 2);
  return {...view, target: view.target.map((x, i) => x + height * (by_right * right[i] + by_up * up[i]))};
}

const step = Math.PI / 24;
const on_key = {
  ArrowLeft: (view) => turned(view, -step, 0),
  ArrowRight: (view) => turned(view, step, 0),
  ArrowUp: (view) => turned(view, 0, -step),
  ArrowDown: (view) => turned(view, 0, step),
  '+': (view) => approached(view, 0.85),
  '=': (view) => approached(view, 0.85),
  '-': (view) => approached(view, 1 / 0.85),
};
const on_shift_key = {
  ArrowLeft: (view) => shifted(view, -0.08, 0),
  ArrowRight: (view) => shifted(view, 0.08, 0),
  ArrowUp: (view) => shifted(view, 0, 0.08),
  ArrowDown: (view) => shifted(view, 0, -0.08),
};

/**
 * Drag turns (with Shift, the right button or two fingers: shifts), wheel and pinch approach, arrow keys turn (with
 * Shift: shift), + and − approach. `get` gives the view, `set` takes the new one; `click(x, y)`: a press that was none
 * of these, in pixels of the element; `grab(x, y)`: what moves instead of the view where the mouse is pressed there, as
 * {move(x, y), drop(x, y)}, or null. `pointing`: the left button, one finger and bare arrow keys belong to somebody else;
 * with Shift or the right button dragging turns, two fingers turn and approach, Alt makes the arrow keys turn.
 */
export function orbit(element, {get, set, click, grab = () => null, pointing = false}) {
  const down = new Map(); // pointers and where they are
  let moved = 0;
  let held = null; // as of grab()
  const place = (event) => {
    const box = element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const height = () => Math.max(element.clientHeight, 1);
  const spread = () => {
    const [a, b] = [...down.values()];
    return Math.max(Math.hypot(a.x - b.x, a.y - b.y), 1);
  };

  element.addEventListener('pointerdown', (event) => {
    if (pointing && event.pointerType !== 'touch' && event.button === 0 && !event.shiftKey) return;
    if (!down.size) moved = 0;
    held = !down.size && event.button === 0 && !event.shiftKey ? grab(...place(event)) : null;
    down.set(event.pointerId, {x: event.clientX, y: event.clientY});
    element.setPointerCapture(event.pointerId);
  });
  element.addEventListener('pointermove', (event) => {
    const last = down.get(event.pointerId);
    if (!last) element.style.cursor = grab(...place(event)) ? 'grab' : '';
    if (!last) return;
    const dx = event.clientX - last.x;
    const dy = event.clientY - last.y;
    const before = down.size === 2 ? spread() : 0;
    last.x = event.clientX;
    last.y = event.clientY;
    moved += Math.abs(dx) + Math.abs(dy);
    if (moved < 4 || (pointing && event.pointerType === 'touch' && down.size < 2)) return;
    const shifts = !pointing && (down.size === 2 || event.shiftKey || event.buttons & 2);
    if (held) {
      held.move(...place(event));
      return;
    }
    let view = get();
    view = shifts
      ? shifted(view, -dx / height() / down.size, dy / height() / down.size)
      : turned(view, ((-dx / height()) * 3) / down.size, ((-dy / height()) * 3) / down.size);
    if (before) view = approached(view, before / spread());
    set(view);
  });
  const up = (event) => {
    if (held && down.has(event.pointerId) && moved >= 4) held.drop(...place(event));
    held = null;
    if (!down.delete(event.pointerId) || down.size || moved >= 4 || event.type !== 'pointerup' || event.button !== 0)
      return;
    click(...place(event));
  };
  element.addEventListener('pointerup', up);
  element.addEventListener('pointercancel', up);
  element.addEventListener('contextmenu', (event) => event.preventDefault());
  approach(element, {get, set, pointing});
}

// Approaching by wheel and keys, turning and shifting by keys.
function approach(element, {get, set, pointing}) {
  element.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      set(approached(get(), Math.exp(clamp(event.deltaY, -200, 200) / 600)));
    },
    {passive: false},
  );
  element.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey !== (pointing && event.key.startsWith('Arrow'))) return;
    const change = (event.shiftKey && on_shift_key[event.key]) || on_key[event.key];
    if (!change) return;
    event.preventDefault();
    set(change(get()));
  });
}
