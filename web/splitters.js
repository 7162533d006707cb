// Bars between panels: dragged, or moved by the arrow keys, they give one panel more room and another less. Remembered.
import {h} from './dom.js';
import {kept} from './kept.js';

const least = 10; // percent of the page
const most = 75;
const step = 2;
const long_step = 10;

const sizes = kept('panels', {});

/**
 * A bar that sets the size of `panel` within `main`, in percent, as the style's `--NAME`. `along`: 'width' or 'height';
 * `sense`: 1 where the panel lies before the bar, −1 where it lies behind it; `name`: under which it is kept.
 */
export function splitter({main, panel, label, name, along, sense}) {
  const across = along === 'width';
  const share = () =>
    (100 * panel().getBoundingClientRect()[along]) / Math.max(1, main().getBoundingClientRect()[along]);
  const bar = h('div', {
    class: `splitter ${across ? 'upright' : 'level'}`,
    role: 'separator',
    tabindex: 0,
    'aria-orientation': across ? 'vertical' : 'horizontal',
    'aria-label': `${across ? 'Width' : 'Height'} of ${label}`,
    'aria-valuemin': least,
    'aria-valuemax': most,
    'aria-valuenow': Math.round(sizes.value[name] ?? 30),
    title: 'Drag it, or move it with the arrow keys; Enter: as it was',
    'data-testid': `splitter-${name}`,
  });
  const show = () => {
    const size = sizes.value[name];
    if (size === undefined) main().style.removeProperty(`--${name}`);
    else main().style.setProperty(`--${name}`, `${size}%`);
    bar.setAttribute('aria-valuenow', Math.round(share()));
  };
  const set = (size) => {
    const {[name]: _, ...others} = sizes.value;
    const bounded = size === null ? null : Math.round(10 * Math.max(least, Math.min(most, size))) / 10;
    sizes.set(bounded === null ? others : {...others, [name]: bounded});
    show();
  };
  bar.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    event.preventDefault();
    bar.focus();
    bar.setPointerCapture(event.pointerId);
    const place = (one) => (across ? one.clientX : one.clientY);
    const [from, was] = [place(event), share()];
    const whole = main().getBoundingClientRect()[along];
    const move = (next) => set(was + (sense * 100 * (place(next) - from)) / whole);
    bar.addEventListener('pointermove', move);
    bar.addEventListener('lostpointercapture', () => bar.removeEventListener('pointermove', move), {once: true});
  });
  bar.addEventListener('dblclick', () => set(null));
  bar.addEventListener('focus', () => bar.setAttribute('aria-valuenow', Math.round(share())));
  bar.addEventListener('keydown', (event) => {
    const by = {[across ? 'ArrowLeft' : 'ArrowUp']: -1, [across ? 'ArrowRight' : 'ArrowDown']: 1}[event.key];
    if (event.key === 'Enter') set(null);
    else if (by) set(share() + sense * by * (event.shiftKey ? long_step : step));
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  return {bar, show};
}
