// The camera's own motion: a flight to another view, or following a point.

const flight_ms = 350;
const arrived_m = 0.001;
const follow_rate = 0.2; // of the way that is left, with each frame

const still = () => matchMedia('(prefers-reduced-motion: reduce)').matches;

export class CameraMotion {
  #flight = null; // {from, to, since}
  #goal = null; // the point that is followed

  /** Goes from one view to another. @returns whether there is motion: none where the reader wants none */
  fly(from, to) {
    this.#goal = null;
    if (still()) return false;
    this.#flight = {from, to, since: performance.now()};
    return true;
  }
  /** Keeps looking at this point; null: no longer. */
  follow(point) {
    this.#goal = point;
  }
  /** The reader turns the view by hand. */
  land() {
    this.#flight = null;
  }

  /** Moves the camera of `view`, a SceneView. @returns whether it is to be moved again with the next frame */
  move(view) {
    if (this.#flight) return this.#flyOn(view);
    if (!this.#goal) return false;
    const {target} = view.view;
    const away = this.#goal.map((x, i) => x - target[i]);
    const near = Math.hypot(...away) < arrived_m || still();
    view.look({...view.view, target: target.map((x, i) => x + (near ? 1 : follow_rate) * away[i])});
    return !near;
  }
  #flyOn(view) {
    const {from, to, since} = this.#flight;
    const part = Math.min(1, (performance.now() - since) / flight_ms);
    view.towards(from, to, part);
    if (part === 1) this.#flight = null;
    return part < 1;
  }
}
