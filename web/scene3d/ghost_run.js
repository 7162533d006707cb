// Another run as a ghost in a stage: its bodies are fetched, and its poses looked up as they are needed.
import {Motion} from './motion.js';

export class GhostRun {
  #other;
  #stage;
  #motion;
  #geoms = null; // known once the scene has come
  #last = new Map(); // its poses that were known last
  #closed = false;

  /**
   * `other`: {client, timeOf(n)}, where timeOf gives the instant of the other run that belongs to record n of this one, or
   * null where there is none. `opened`: a promise, the stage shows its own scene.
   */
  constructor(other, stage, opened) {
    this.#other = other;
    this.#stage = stage;
    this.#motion = new Motion({
      fetch: (from, to) => other.client.poses(from, to),
      duration: () => Infinity,
      arrived: () => stage.wake(),
    });
    /** Resolves when its bodies are in the stage. */
    this.opened = this.#open(opened);
  }

  async #open(opened) {
    const scene = await this.#other.client.scene().catch(() => null);
    await opened;
    if (this.#closed || !scene) return;
    this.#geoms = scene.geoms;
    this.#stage.drawing?.haunt(scene.geoms);
    this.#stage.touch();
  }

  /** Map of body to pose at what belongs to record n; null while nothing is known. */
  posesAt(n) {
    if (!this.#geoms) return null;
    const t = this.#other.timeOf(n);
    if (typeof t !== 'number') return new Map();
    const window = this.#motion.at(t);
    if (window) this.#last = window.poses(t);
    return this.#last;
  }

  close() {
    this.#closed = true;
    this.#motion.close();
  }
}
