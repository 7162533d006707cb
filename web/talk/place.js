// The scene of a live session as something to point at: in 3D, or as a map; by mouse, finger or keys.
import {h} from '../dom.js';
import {objectNear, placeText} from '../scene3d/scene_text.js';
import {Pointing} from './pointing.js';
import {mountScene3d} from './scene_3d.js';
import {clipped} from './table.js';
import {mountTableMap} from './table_map.js';

const step_m = 0.01;
const long_step_m = 0.05;
const steps = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};

class Place {
  #known;
  #world;
  #drawn;
  #tell;
  #lost;
  #mounts; // name -> makes the view
  #views = {};
  #caption = h('p', {class: 'caption', 'data-testid': 'live-caption'});
  #host = h('div', {class: 'place'});
  element = h('div', {class: 'place-frame'}, this.#host, this.#caption);
  /** The view that is shown: as mountScene3d() or mountTableMap() gives it; null before there is one. */
  view = null;

  constructor({own, known, world, drawn, tell, lost, keeps, send, sample}) {
    this.#known = known;
    this.#world = world;
    this.#drawn = drawn;
    this.#tell = tell;
    this.#lost = lost;
    this.pointing = new Pointing({send, sample, keeps, shown: (target) => this.#pointed(target)});
    this.#mounts = {
      map: () => mountTableMap(known, world),
      drawing: () => mountScene3d(own, known, world, () => this.#withoutDrawing()),
    };
  }

  // The human points at `target`; null: no longer.
  #pointed(target) {
    if (target) this.#world.set({cross: null});
    this.#world.point(target);
    this.#describe(target);
  }
  #describe(target) {
    const near = target && objectNear(target, this.#known.objects, this.#world.poses);
    const thing = target && (near ? `the ${this.#known.titles.get(near)}` : placeText([...target, 0]));
    this.#caption.textContent = target ? `You point at ${thing}.` : '';
  }

  // The scene cannot be drawn: the map is all there is.
  #withoutDrawing() {
    this.#drawn = false;
    this.#lost();
    if (this.view === this.#views.drawing) this.#show('map');
  }
  async #show(name) {
    const view = (this.view = this.#views[name] ??= this.#mount(name));
    this.#host.replaceChildren(view.element, ...(view.controls ? [view.controls] : []));
    this.#tell(name === 'map');
    await (view.opened ??= view.open());
    view.render();
  }
  #mount(name) {
    const view = this.#mounts[name]();
    this.pointing.listen(view.focusable, (x, y) => view.at(x, y));
    view.focusable.addEventListener('keydown', (event) => this.#onKey(event));
    view.focusable.addEventListener('blur', () => this.#world.set({cross: null}));
    return view;
  }

  #onKey(event) {
    if (event.ctrlKey || event.altKey || event.metaKey || !this.pointing.enabled) return;
    const {cross} = this.#world;
    const step = steps[event.key];
    if (!step && !(event.key === 'Enter' && cross)) return;
    event.preventDefault();
    if (step) this.#moveCross(step, event.shiftKey ? long_step_m : step_m);
    else this.pointing.stroke(cross);
  }
  #moveCross(step, by) {
    const to = (this.#world.cross ?? [0, 0]).map((x, i) => x + by * step[i]);
    this.#world.set({cross: clipped(this.#known.table, to), pointer: null, trail: []});
    this.#describe(this.#world.cross);
  }

  /** Resolves when the scene is there. */
  open() {
    return this.#show(this.#drawn ? 'drawing' : 'map');
  }
  /** Changes between drawing and map. */
  toggle() {
    if (this.#drawn) this.#show(this.view === this.#views.map ? 'drawing' : 'map');
  }
  render() {
    this.view?.render();
  }
  close() {
    this.pointing.close();
    for (const view of Object.values(this.#views)) view.close();
  }
}

/**
 * `own`: the scene of the log; `known`: of readTable(); `world`: a LiveWorld; `drawn`: whether it can be drawn in 3D at
 * all; `tell(mapped)`: drawing or map is shown; `lost()`: it cannot be drawn; the rest as of Pointing.
 */
export const mountPlace = (needs) => new Place(needs);
