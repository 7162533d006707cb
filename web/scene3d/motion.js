// Where every body was at any instant, from windows of `poses` that are fetched as they are needed and a little ahead,
// and kept within bounds. Pure: knows neither page nor three. Metres, seconds, frame W; a pose is [x, y, z, qw, qx, qy, qz].
import {lastAtMost} from '../search.js';

// A log has at most 30 poses a second: across a wider gap a body stood still and moved in the end.
export const longest_step_s = 0.05;
const lead_s = 2 * longest_step_s; // fetched on either side of a window, so that the way across its ends is known
const most_numbers = 2e6; // kept of all windows together: 16 MB

export const isPose = (pose) =>
  Array.isArray(pose) &&
  pose.length === 7 &&
  pose.every(Number.isFinite) &&
  Math.hypot(pose[3], pose[4], pose[5], pose[6]) > 0.5;
export const isPoint = (point) => Array.isArray(point) && point.length === 3 && point.every(Number.isFinite);

/** The pose a part (0 … 1) of the way from `a` to `b`: straight, and turning evenly the shorter way. */
export function between(a, b, part) {
  if (part <= 0) return a;
  if (part >= 1) return b;
  const out = new Array(7);
  for (let i = 0; i < 3; ++i) out[i] = a[i] + part * (b[i] - a[i]);
  let cosine = a[3] * b[3] + a[4] * b[4] + a[5] * b[5] + a[6] * b[6];
  const sign = cosine < 0 ? -1 : 1;
  cosine = Math.min(1, sign * cosine);
  const angle = Math.acos(cosine);
  const sine = Math.sin(angle);
  const [of_a, of_b] =
    sine < 1e-6 ? [1 - part, part] : [Math.sin((1 - part) * angle) / sine, Math.sin(part * angle) / sine];
  for (let i = 3; i < 7; ++i) out[i] = of_a * a[i] + sign * of_b * b[i];
  const norm = Math.hypot(out[3], out[4], out[5], out[6]);
  for (let i = 3; i < 7; ++i) out[i] /= norm;
  return out;
}

/** One answer of `poses`, in a form that is quick to query. */
export class Window {
  /** `from` … `to`: the instants it is good for; the answer may reach beyond. */
  constructor(answer, from, to) {
    this.from = from;
    this.to = to;
    this.start = new Map(Object.entries(answer?.start ?? {}).filter(([, pose]) => isPose(pose)));
    this.tracks = new Map();
    this.numbers = 7 * this.start.size;
    for (const change of list(answer?.changes)) {
      if (!Array.isArray(change) || !Number.isFinite(change[0])) continue;
      for (const [body, pose] of Object.entries(change[1] ?? {})) if (isPose(pose)) this.#add(body, change[0], pose);
    }
    this.pointing = list(answer?.pointing)
      .filter((one) => Number.isFinite(one?.from) && Number.isFinite(one?.to))
      .map((one) => ({
        ...one,
        origin: isPoint(one.origin) ? one.origin : null,
        samples: list(one.samples).filter(
          (sample) => Array.isArray(sample) && sample.length === 4 && sample.every(Number.isFinite),
        ),
      }))
      .filter((one) => one.samples.length);
    this.acts = list(answer?.acts)
      .filter((one) => Number.isFinite(one?.from) && Number.isFinite(one?.to))
      .map((one) => ({...one, target: isPoint(one.target) ? one.target : null}));
    for (const one of this.pointing) this.numbers += 4 * one.samples.length;
  }

  #add(body, t, pose) {
    let track = this.tracks.get(body);
    if (!track) this.tracks.set(body, (track = {t: [], poses: []}));
    if (track.t.length && track.t.at(-1) > t) return;
    track.t.push(t);
    track.poses.push(pose);
    this.numbers += 8;
  }

  /** Map of body to pose at t: exact at what was logged, on the way in between, at rest across gaps. */
  poses(t) {
    const poses = new Map(this.start);
    for (const [body, track] of this.tracks) {
      const place = lastAtMost(track.t, t);
      const before = place < 0 ? (this.start.get(body) ?? track.poses[0]) : track.poses[place];
      if (place + 1 === track.t.length) {
        poses.set(body, before);
        continue;
      }
      const until = track.t[place + 1];
      const since = Math.max(place < 0 ? -Infinity : track.t[place], until - longest_step_s);
      poses.set(body, between(before, track.poses[place + 1], (t - since) / (until - since)));
    }
    return poses;
  }

  /** Who points at t, each with the samples of the last `trail_s` seconds, the newest last. */
  pointingAt(t, trail_s = 0.6) {
    return this.pointing
      .filter((one) => one.from <= t && t <= one.to)
      .map((one) => {
        const until = one.samples.filter(([at]) => at <= t);
        const shown = until.length ? until : one.samples.slice(0, 1);
        return {
          ...one,
          target: shown.at(-1).slice(1),
          trail: shown.filter(([at]) => at > t - trail_s).map((sample) => sample.slice(1)),
        };
      });
  }
  actsAt(t) {
    return this.acts.filter((one) => one.from <= t && t <= one.to);
  }
}
const list = (value) => (Array.isArray(value) ? value : []);

export class Motion {
  #fetch;
  #duration;
  #arrived;
  #width;
  #now;
  #kept = []; // windows, the one used last at the end
  #wanted = null;
  #busy = false;
  #retry_at = 0;

  /**
   * `fetch(from, to)` gives a promise of an answer of `poses`; `duration()` the end of the run, which may grow;
   * `arrived()` is called when there is more to show. `width`: seconds of a window.
   */
  constructor({fetch, duration, arrived, width = 8, now = () => performance.now()}) {
    this.#fetch = fetch;
    this.#duration = duration;
    this.#arrived = arrived;
    this.#width = width;
    this.#now = now;
    this.problem = '';
  }

  get numbers() {
    return this.#kept.reduce((sum, one) => sum + one.numbers, 0);
  }

  /** The window that tells of t, or null while it is on its way. */
  at(t) {
    t = Math.max(0, Math.min(this.#duration(), t));
    this.#wanted = t;
    const here = this.#covering(t);
    if (here) this.#kept.push(...this.#kept.splice(this.#kept.indexOf(here), 1));
    if (!here || this.#ahead(here, t) !== null) this.#go();
    return here ?? null;
  }

  close() {
    this.#wanted = null;
    this.#kept = [];
    this.#arrived = () => {};
  }

  #covering(t) {
    return this.#kept.find((one) => one.from <= t && t <= one.to);
  }

  /** Where the next window begins that playing on will need, or null. */
  #ahead(here, t) {
    if (here.to >= this.#duration() || t < here.to - this.#width / 2) return null;
    return this.#covering(here.to + 1e-6) ? null : here.to;
  }

  async #go() {
    if (this.#busy || this.#now() < this.#retry_at) return;
    this.#busy = true;
    while (this.#wanted !== null) {
      const t = this.#wanted;
      const here = this.#covering(t);
      const from = here ? this.#ahead(here, t) : this.#begin(t);
      if (from === null) break;
      const to = from + this.#width;
      const end = this.#duration();
      try {
        const answer = await this.#fetch(Math.max(0, from - lead_s), to + lead_s);
        this.problem = '';
        const told = Number.isFinite(answer?.next) ? answer.next : to;
        // Good for an instant at least, so that the next request lies farther on.
        this.#keep(new Window(answer, from, Math.max(from + 1e-3, Math.min(to, told, end))));
      } catch (problem) {
        this.problem = problem?.message ?? String(problem);
        this.#retry_at = this.#now() + 2000;
        break;
      } finally {
        this.#arrived();
      }
    }
    this.#busy = false;
  }

  /** Windows lie side by side where they can; where one was cut short before t, the next begins at t. */
  #begin(t) {
    const grid = Math.floor(t / this.#width) * this.#width;
    return this.#kept.some((one) => one.from <= grid && grid <= one.to) ? t : grid;
  }

  #keep(window) {
    this.#kept.push(window);
    while (this.#kept.length > 1 && (this.numbers > most_numbers || this.#kept.length > 40)) this.#kept.shift();
  }
}
