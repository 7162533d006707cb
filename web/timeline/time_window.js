// The stretch of time that the timeline shows, and how it is zoomed and moved. Seconds of the run; places are those on
// the time axis, where idle time may be short.

const least_s = 0.05; // as far as one can zoom in

export class TimeWindow {
  #duration;
  #axes;
  #model;

  /** `axes`: {short, full}, as of axesOf(). */
  constructor(duration, axes, model) {
    this.#duration = duration;
    this.#axes = axes;
    this.#model = model;
  }

  get axis() {
    return this.#model.selection.gaps ? this.#axes.full : this.#axes.short;
  }
  /** [from, to] */
  get span() {
    return this.#model.selection.zoom ?? this.whole;
  }
  get whole() {
    return [0, this.#duration || 1];
  }
  /** The span as places. */
  get places() {
    return this.span.map((t) => this.axis.of(t));
  }

  /** Shows the stretch between two places, moved into the run. */
  showPlaces([from, to]) {
    const end = this.axis.of(this.#duration || 1);
    const wide = Math.min(end, to - from);
    const start = Math.max(0, Math.min(end - wide, from));
    this.#model.go({zoom: this.#timesOf(start, start + wide)}, 'slide');
  }
  #timesOf(from, to) {
    const least = Math.min(least_s, this.#duration || 1);
    const start = Math.max(0, Math.min(this.#duration - least, this.axis.back(from)));
    const end = Math.min(this.#duration || 1, this.axis.back(to));
    return [start, Math.max(start + least, end)];
  }
  /** Shows `factor` times as much around the instant `at`; around the middle where that is out of sight. */
  zoomBy(factor, at) {
    const [from, to] = this.places;
    const place = this.axis.of(at);
    const middle = place >= from && place <= to ? place : (from + to) / 2;
    this.showPlaces([middle - (middle - from) * factor, middle + (to - middle) * factor]);
  }
  /** Moves by a part of the width. */
  panBy(part) {
    const [from, to] = this.places;
    const by = (to - from) * part;
    this.showPlaces([from + by, to + by]);
  }
  showAll() {
    this.#model.go({zoom: this.whole}, 'slide');
  }
}
