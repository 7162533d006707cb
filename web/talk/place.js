// The scene of a live session as something to point at: in 3D, or as a map; by mouse, finger or keys.
import {h} from '../dom.js';
import {objectNear, placeText} from '../scene3d/scene_text.js';
import {Pointing} from './pointing.js';
import {mountScene3d} from './scene_3d.js';
import {clipped} from './table.js';
import {mountTableMap} from './table_map.js';

const step_m = 0.01, long_step_m = 0.05;
const steps = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};

/** `own`: the scene of the log; `known`: of readTable(); `drawn`: whether it can be drawn in 3D at all; `tell(mapped)`; the rest is of Pointing. */
export function mountPlace({own, known, world, status, drawn, tell, keeps, send, sample}) {
  const caption = h('p', {class: 'caption', 'data-testid': 'live-caption'}), host = h('div', {class: 'place'});
  const element = h('div', {class: 'place-frame'}, host, caption);
  const pointing = new Pointing({send, sample, keeps, shown: (target) => {
    if (target) world.set({cross: null});
    world.point(target);
    describe(target);
  }});
  const views = {};
  let shown = null;

  const describe = (target) => {
    const near = target && objectNear(target, known.objects, world.poses);
    caption.textContent = target ? `You point at ${near ? `the ${known.titles.get(near)}` : placeText([...target, 0])}.` : '';
  };
  const lost = () => {
    drawn = false;
    status.withoutMap();
    if (shown === views.drawing) show('map');
  };

  async function show(name) {
    if (!views[name]) {
      const view = views[name] = name === 'map' ? mountTableMap(known, world) : mountScene3d(own, known, world, lost);
      pointing.listen(view.focusable, (x, y) => view.at(x, y));
      view.focusable.addEventListener('keydown', onKey);
      view.focusable.addEventListener('blur', () => world.set({cross: null}));
    }
    const view = shown = views[name];
    host.replaceChildren(view.element, ...view.controls ? [view.controls] : []);
    tell(name === 'map');
    await (view.opened ??= view.open());
    view.render();
  }

  function onKey(event) {
    if (event.ctrlKey || event.altKey || event.metaKey || !pointing.enabled) return;
    const step = steps[event.key];
    if (!step && !(event.key === 'Enter' && world.cross)) return;
    event.preventDefault();
    if (!step) { pointing.stroke(world.cross); return; }
    const by = event.shiftKey ? long_step_m : step_m, from = world.cross ?? [0, 0];
    world.set({cross: clipped(known.table, from.map((x, i) => x + by * step[i])), pointer: null, trail: []});
    describe(world.cross);
  }

  return {
    element, pointing,
    get view() { return shown; },
    open: () => show(drawn ? 'drawing' : 'map'),
    toggle() { if (drawn) show(shown === views.map ? 'drawing' : 'map'); },
    render: () => shown?.render(),
    close() {
      pointing.close();
      for (const view of Object.values(views)) view.close();
    },
  };
}
