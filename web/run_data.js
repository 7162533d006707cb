// A run as the panels ask about it: where, when and what, from the lanes' columns. Pure; knows no page.

/** Place of the last element of sorted `numbers` that is at most `value`, or -1. */
export function lastAtMost(numbers, value) {
  let low = 0, high = numbers.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (numbers[middle] <= value) low = middle + 1; else high = middle;
  }
  return low - 1;
}

export class RunData {
  constructor({summary, graph, lanes}) {
    this.summary = summary;
    this.graph = graph;
    this.lanes = lanes;
    this.size = lanes.t.length;
    this.t = Float64Array.from(lanes.t);
    // Some records are written a little after the instant they speak of; searching needs times in order.
    this.reached = this.t.slice();
    for (let n = 1; n < this.size; ++n) this.reached[n] = Math.max(this.reached[n], this.reached[n - 1]);
    this.kinds = lanes.kinds;
    this.duration = this.size ? this.reached[this.size - 1] : 0;
    this.steps = lanes.transitions;
    this.segments = stateSegments(this.steps, this.reached, graph.start, this.duration);
  }

  kind(n) { return this.kinds[this.lanes.kind[n]]; }
  label(n) { return this.lanes.label[n] || (this.kind(n) === 'input' ? 'pointing' : ''); }
  cause(n) { return this.lanes.cause[n]; }
  clamp(n) { return Math.max(0, Math.min(this.size - 1, n)); }

  /** The last record at time t. */
  at(t) { return Math.max(0, lastAtMost(this.reached, t)); }

  /** Place in `steps` of the last transition at record n, or -1. */
  step(n) { return lastAtMost(this.steps.n, n); }
  state(n) {
    const step = this.step(n);
    return step < 0 ? this.graph.start : this.steps.to[step];
  }
  depth(n) {
    const step = this.step(n);
    return step < 0 ? 0 : this.steps.depth[step];
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
    for (let i = n + 1; i < this.size && found.length < 50; ++i) if (this.lanes.cause[i] === n) found.push(i);
    return found;
  }

  /** One sentence about record n, for those who hear the page. */
  sentence(n) {
    return `Record ${n}, ${this.t[n].toFixed(2)} seconds, ${this.kind(n)}: ${this.label(n)}. State ${this.state(n)}.`;
  }
}

/** [{state, from, to, n}]: what the automaton was in, stretches of no length left out, equal neighbours joined. */
function stateSegments(steps, t, start, duration) {
  const segments = [];
  const add = (state, from, to, n) => {
    const last = segments.at(-1);
    if (last && last.state === state) last.to = to;
    else if (to > from) segments.push({state, from, to, n});
  };
  if (start) add(start, 0, steps.n.length ? t[steps.n[0]] : duration, 0);
  steps.n.forEach((n, i) => add(steps.to[i], t[n], i + 1 < steps.n.length ? t[steps.n[i + 1]] : duration, n));
  return segments;
}
