// From the time of a run to its place on the time axis, and back: idle stretches are drawn short.
import {lastAtMost} from '../search.js';

const idle_s = 2; // longer pauses are shortened
const shown_s = 0.7; // to this

/** A way to place times that grows with them; `gaps`: [[from, to]…] that are drawn short. */
export class TimeAxis {
  constructor(gaps = []) {
    this.gaps = gaps;
    this.times = [0];
    this.places = [0];
    let saved = 0;
    for (const [from, to] of gaps) {
      const short = Math.min(shown_s, to - from);
      this.times.push(from, to);
      this.places.push(from - saved, from - saved + short);
      saved += to - from - short;
    }
  }

  of(t) {
    return through(this.times, this.places, t);
  }
  back(place) {
    return through(this.places, this.times, place);
  }
}

function through(from, to, value) {
  const i = lastAtMost(from, value);
  if (i < 0) return to[0] + value - from[0];
  if (i + 1 >= from.length) return to[i] + value - from[i];
  const width = from[i + 1] - from[i];
  return width > 0 ? to[i] + ((value - from[i]) / width) * (to[i + 1] - to[i]) : to[i];
}

/**
 * Where nothing happens for long: between the stops (at `t[stop]`, in order), as far as no item of a lane goes on.
 * `spans`: {from, to} of those lanes, each in order of `from`.
 */
export function idleGaps(t, stops, spans, duration) {
  const places = spans.map(() => ({next: 0, busy_until: 0}));
  const gaps = [];
  let last = 0;
  const step = (now) => {
    if (now - last > idle_s) {
      // From the last instant something began before, to the next beginning, unless it is within something.
      let from = last;
      spans.forEach((span, i) => {
        const place = places[i];
        while (place.next < span.from.length && span.from[place.next] < now) {
          place.busy_until = Math.max(place.busy_until, span.to[place.next]);
          ++place.next;
        }
        from = Math.max(from, Math.min(now, place.busy_until));
      });
      if (now - from > idle_s) gaps.push([from, now]);
    }
    last = Math.max(last, now);
  };
  for (const n of stops) step(t[n]);
  step(duration);
  return gaps;
}
