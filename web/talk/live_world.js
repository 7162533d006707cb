// The contents of a live session's scene: the bodies' poses, where the human points, and which places were understood.
import {isPose} from '../scene3d/motion.js';

const trail_ms = 600;
const flash_ms = 1500;
const watched_ms = 500; // how long a sample that somebody else recorded is shown

export class LiveWorld {
  version = 0;
  poses = new Map();
  pointer = null; // [x, y]
  trail = [];
  clicks = []; // {target}: clicks for the words being typed
  cross = null; // [x, y]: of the keyboard
  understood = []; // [x, y]
  heading = null; // {target, from}: where the avatar takes a thing, [x, y, z], and where the thing was when it began
  #times = []; // of the trail
  #changed;
  #timers = new Set();
  #watched = 0;

  /** `changed()`: there is something new to draw. */
  constructor(changed) {
    this.#changed = changed;
  }

  set(change) {
    Object.assign(this, change);
    ++this.version;
    this.#changed();
  }
  begin(scene) {
    this.poses = new Map(Object.entries(scene?.bodies ?? {}).filter(([, pose]) => isPose(pose)));
    this.set({});
  }
  moved(bodies) {
    for (const [name, pose] of Object.entries(bodies ?? {})) if (isPose(pose)) this.poses.set(name, pose);
    this.set({});
  }

  /** An act has the status: while it goes on, its way is shown. */
  act({program, status, step}) {
    if (step !== undefined) return;
    if (status === 'started') this.set({heading: this.#way(program)});
    else if (status !== 'asked') this.set({heading: null});
  }
  // From the thing to a point, or onto another thing; null for programs that take nothing anywhere.
  #way(program) {
    const [, thing, place] = /^\w+\((\w+), (.+)\)$/.exec(program ?? '') ?? [];
    const from = this.poses.get(thing)?.slice(0, 3);
    const point = /^<([^<>]+)>$/
      .exec(place ?? '')?.[1]
      .split(',')
      .map(Number);
    const other = this.poses.get(/^\w+\((\w+)\)$/.exec(place ?? '')?.[1]);
    const target = point?.length === 3 && point.every(Number.isFinite) ? point : other?.slice(0, 3);
    return from && target ? {target, from} : null;
  }

  /** Where the human points now, or null. */
  point(target) {
    const now = performance.now();
    const first = this.#times.findIndex((at) => now - at < trail_ms);
    this.#times.splice(0, first < 0 ? this.#times.length : first);
    const trail = this.trail.slice(this.trail.length - this.#times.length);
    if (target) {
      trail.push(target);
      this.#times.push(now);
    }
    this.set({pointer: target, trail: target ? trail : []});
    if (!target) this.#times = [];
  }
  /** The same of somebody else: fades by itself. */
  watch(target) {
    this.point(target);
    clearTimeout(this.#watched);
    this.#watched = setTimeout(() => this.point(null), watched_ms);
  }
  flash(place) {
    this.set({understood: [...this.understood, place]});
    const timer = setTimeout(() => {
      this.#timers.delete(timer);
      this.set({understood: this.understood.filter((one) => one !== place)});
    }, flash_ms);
    this.#timers.add(timer);
  }
  close() {
    clearTimeout(this.#watched);
    for (const timer of this.#timers) clearTimeout(timer);
    this.#changed = () => {};
  }
}
