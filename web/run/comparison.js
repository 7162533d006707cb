// Two runs, A and B, compared: the counterpart of each record, and the differences. Pure; knows no page.
import {laneRows, reachOf} from '../timeline/lane_rows.js';
import {lastAtMost} from '../search.js';

export class Comparison {
  /** `side`: {id, data, client, labels} of B; `told`: what the server's diff says. */
  constructor(data, side, told) {
    this.own = data;
    this.side = side;
    this.told = told;
    this.hunks = told.differences;
    this.marks = {a: marksOf(this.hunks, 'a'), b: marksOf(this.hunks, 'b')};
    this.anchors = anchorsOf(data, side.data, told.pairs ?? []);
    this.first = told.first;
    /** The record of A to begin at. */
    this.start = this.first === null || this.first === undefined ? null : this.recordOf(this.first);
    const rows = laneRows(side.data);
    /** The lanes of B: `meaning`: inputs in common stand where A has them; `time`: at B's own times. */
    this.rows = {meaning: rows.map((row) => this.#inOwnTime(row)), time: rows};
  }

  marked = (side, n) => this.marks[side ?? 'a']?.has(n) ?? false;

  /** The record of A where a difference is shown: its own, else where B's has its counterpart. */
  recordOf(hunk) {
    const {a, b} = this.hunks[hunk];
    return a.length ? leading(a) : this.toOwn(leading(b));
  }
  /** The record of B that a selection shows: the difference's own when that is what is selected, else the counterpart. */
  otherOf({n, hunk}) {
    const shown = this.hunks[hunk];
    return shown?.b.length && this.recordOf(hunk) === n ? leading(shown.b) : this.toOther(n);
  }

  toOther(n) {
    return counterpart(this.own, this.side.data, this.anchors.a, this.anchors.b, n);
  }
  toOwn(n) {
    return counterpart(this.side.data, this.own, this.anchors.b, this.anchors.a, n);
  }

  /** A time of B as a time of A: common inputs stand at the same place. */
  timeToOwn(t) {
    return moved(this.anchors.times_b, this.anchors.times_a, t);
  }
  timeToOther(t) {
    return moved(this.anchors.times_a, this.anchors.times_b, t);
  }

  #inOwnTime(row) {
    const map = (times) => Float64Array.from(times, (t) => this.timeToOwn(t));
    const lane = {...row.lane, from: map(row.lane.from), to: map(row.lane.to)};
    return {...row, lane, reach: reachOf(lane)};
  }
}

// The most telling of a difference's records: the event rather than the symbols that it made.
const leading = (records) => (records.find(({kind}) => kind !== 'symbol') ?? records[0]).n;

function marksOf(hunks, side) {
  const marks = new Set();
  for (const hunk of hunks) for (const {n} of hunk[side]) marks.add(n);
  return marks;
}

// The first records belong together, and the inputs in common.
function anchorsOf(own, other, pairs) {
  const a = [0];
  const b = [0];
  const times_a = [0];
  const times_b = [0];
  for (const [n, m] of pairs) {
    if (n >= own.size || m >= other.size || n <= a.at(-1) || m <= b.at(-1)) continue;
    a.push(n);
    b.push(m);
    if (own.t[n] <= times_a.at(-1) || other.t[m] <= times_b.at(-1)) continue;
    times_a.push(own.t[n]);
    times_b.push(other.t[m]);
  }
  return {a, b, times_a, times_b};
}

// The record as far behind the common input before, if that is of the same kind; else the record at that time.
function counterpart(from, to, from_anchors, to_anchors, n) {
  const i = lastAtMost(from_anchors, n);
  const guess = to_anchors[i] + n - from_anchors[i];
  const end = i + 1 < to_anchors.length ? to_anchors[i + 1] : to.size;
  if (guess < end && to.kind(guess) === from.kind(n)) return guess;
  const t = moved(
    from_anchors.map((one) => from.reached[one]),
    to_anchors.map((one) => to.reached[one]),
    from.reached[n],
  );
  return Math.max(to_anchors[i], Math.min(end - 1, to.at(t)));
}

function moved(from, to, t) {
  const i = Math.max(0, lastAtMost(from, t));
  if (i + 1 >= from.length) return to[i] + t - from[i];
  return to[i] + ((t - from[i]) / (from[i + 1] - from[i])) * (to[i + 1] - to[i]);
}
