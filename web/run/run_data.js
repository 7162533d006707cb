// A run as the panels query it, from its columns: places, times, states, causes. Pure; knows no page.
import {lastAtMost} from '../search.js';
import {laneOf} from './columns.js';
import {Schema} from './schema.js';

const most_effects = 50;

export class RunData {
  /** `columns` as readColumns gives them; `schema` as /api/schema does; `media`: the recordings; `labels`: as of labels.js. */
  constructor({
    summary,
    graph,
    schema,
    columns: {columns, kinds, names, records, duration, complete},
    labels,
    media = [],
  }) {
    this.summary = summary;
    this.graph = graph;
    this.schema = new Schema(schema);
    this.kinds = kinds;
    this.names = names;
    this.size = records;
    this.duration = duration;
    this.complete = complete;
    this.labels = labels;
    this.media = media.map((one) => ({...one, sound: {peaks: null, problem: ''}}));
    this.t = columns.t;
    this.kind_of = columns.kind;
    this.cause_of = columns.cause;
    this.stops = columns.stop;
    this.confidence = columns.confidence;
    // Some records are written a little after the instant they speak of; searching needs times in order.
    this.reached = inOrder(this.t);
    this.steps = laneOf(columns, 'step');
    this.lanes = {};
    for (const name of [
      'speech',
      'gesture',
      'pointing',
      'gaze',
      'utterance',
      'move',
      'act',
      'observed',
      'rest',
      'flag',
      'branches',
      'confidence',
      'depth',
    ])
      this.lanes[name] = laneOf(columns, name);
    this.misses = new Set(summary.as_observed?.misses);
    this.lanes.flag = withInstants(this.lanes.flag, this.misses, this.t);
    this.lanes.state = stateLane(this.steps, this.reached, names, graph.start, duration);
  }

  kind(n) {
    return this.kinds[this.kind_of[n]];
  }
  label(n) {
    return this.labels.label(n);
  }
  /** The label as logged, where the words are others; else null. */
  raw(n) {
    return this.labels.raw(n);
  }
  text(n) {
    return this.labels.text(n);
  }
  /** The words of an utterance; dots follow those that are not final. */
  said(n) {
    return this.label(n).endsWith('(not final)') ? `${this.text(n)} …` : this.text(n);
  }
  cause(n) {
    return this.cause_of[n];
  }
  clamp(n) {
    return Math.max(0, Math.min(this.size - 1, n));
  }
  count(kind) {
    return this.summary.counts?.[kind] ?? 0;
  }

  /** The last record at time t. */
  at(t) {
    return Math.max(0, lastAtMost(this.reached, t));
  }

  /** The stretch of `width` seconds with t in its first third, moved into the run: [from, to]. */
  windowAround(t, width) {
    const from = Math.max(0, Math.min(this.duration - width, t - width / 3));
    return [from, from + width];
  }

  /** Place in `steps` of the last transition at record n, or -1. */
  step(n) {
    return lastAtMost(this.steps.n, n);
  }
  state(n) {
    const step = this.step(n);
    return step < 0 ? this.graph.start : this.names[this.steps.to[step]];
  }
  depth(n) {
    const step = this.step(n);
    return step < 0 ? 0 : this.steps.depth[step];
  }
  /** {id, from, to} of the step at this place. */
  stepAt(place) {
    const {id, from, to, n} = this.steps;
    return {n: n[place], id: this.names[id[place]], from: this.names[from[place]], to: this.names[to[place]]};
  }

  /** The stop `by` places after (before, when negative) record n among the sorted `stops`. */
  stop(stops, n, by) {
    if (!stops.length) return n;
    const here = lastAtMost(stops, n);
    const exact = here >= 0 && stops[here] === n;
    const place = by > 0 ? here + by : here + by + (exact ? 0 : 1);
    return stops[Math.max(0, Math.min(stops.length - 1, place))];
  }

  /** Running numbers of the records that `n` brought about. */
  effects(n) {
    const found = [];
    for (let i = n + 1; i < this.size && found.length < most_effects; ++i) if (this.cause_of[i] === n) found.push(i);
    return found;
  }

  /** One sentence about record n, for those who hear the page. */
  sentence(n) {
    return `Record ${n}, ${this.t[n].toFixed(2)} seconds, ${this.kind(n)}: ${this.label(n)}. State ${this.state(n)}.`;
  }
}

// The same times, each at least the one before; the array itself where they are in order already.
function inOrder(t) {
  let sorted = t;
  for (let n = 1; n < t.length; ++n) {
    if (sorted[n] >= sorted[n - 1]) continue;
    if (sorted === t) sorted = t.slice();
    sorted[n] = sorted[n - 1];
  }
  return sorted;
}

// The lane with these records as well, each at its instant.
function withInstants(lane, records, t) {
  if (!records.size) return lane;
  const n = Uint32Array.from(new Set([...lane.n, ...records])).sort();
  const at = Float64Array.from(n, (one) => t[one]);
  return {n, from: at, to: at};
}

/** {n, from, to, state}: what the automaton was in, stretches of no length left out, equal neighbours joined. */
function stateLane(steps, t, names, start, duration) {
  const most = steps.n.length + 1;
  const lane = {
    n: new Uint32Array(most),
    from: new Float64Array(most),
    to: new Float64Array(most),
    name: new Int32Array(most),
  };
  let count = 0;
  const add = (name, from, to, n) => {
    if (count && lane.name[count - 1] === name) lane.to[count - 1] = to;
    else if (to > from) {
      [lane.n[count], lane.from[count], lane.to[count], lane.name[count]] = [n, from, to, name];
      ++count;
    }
  };
  if (start) add(names.indexOf(start), 0, steps.n.length ? t[steps.n[0]] : duration, 0);
  for (let i = 0; i < steps.n.length; ++i)
    add(steps.to[i], t[steps.n[i]], i + 1 < steps.n.length ? t[steps.n[i + 1]] : duration, steps.n[i]);
  return {
    n: lane.n.subarray(0, count),
    from: lane.from.subarray(0, count),
    to: lane.to.subarray(0, count),
    name: lane.name.subarray(0, count),
    start,
  };
}
