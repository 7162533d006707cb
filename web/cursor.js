// The cursor in the run that is shown: moves it and plays the run. The model holds the record, the cursor the instant
// while it plays.

export class Cursor {
  /** The run's RunData; null while no run is shown. */
  data = null;
  playing = false;
  /** Seconds of the run for each second of playing. */
  speed = 1;
  #time = null; // while playing, seconds
  #model;
  #moved;

  /** `moved()` is called when playing has begun, gone on without reaching another record, or ended. */
  constructor(model, moved) {
    this.#model = model;
    this.#moved = moved;
  }

  get n() {
    return this.data.clamp(this.#model.selection.n);
  }
  /** The instant shown, in seconds. */
  get time() {
    return this.#time ?? this.data.t[this.n];
  }

  /**
   * Moves to record n and scrolls the timeline if n would leave it. `how`: as of Model.go; `more`: further changes of
   * the selection.
   */
  select(n, how, more = {}) {
    n = this.data.clamp(n);
    const {zoom} = this.#model.selection;
    const t = this.data.t[n];
    const change = {n, ...more};
    if (!this.playing) this.#time = null;
    if (zoom && (t < zoom[0] || t > zoom[1])) change.zoom = this.data.windowAround(t, zoom[1] - zoom[0]);
    this.#model.go(change, how);
  }
  jump = (n, more) => this.select(n, 'jump', more);

  /** Moves `by` stops of the arrow keys. */
  stepBy(by) {
    this.#moveAmong(this.data.stops, by, 'step');
  }
  transitionBy(by) {
    this.#moveAmong(this.data.steps.n, by, 'step');
  }
  /** Moves `by` among the records that say that something went wrong. */
  flagBy(by) {
    this.#moveAmong(this.data.lanes.flag.n, by, 'jump');
  }
  #moveAmong(stops, by, how) {
    this.stop();
    this.select(this.data.stop(stops, this.#model.selection.n, by), how);
  }

  /** Goes to the record's cause (`back`) or its first effect, if there is one. */
  follow(back) {
    const {n} = this.#model.selection;
    const to = back ? this.data.cause(n) : (this.data.effects(n)[0] ?? -1);
    if (to >= 0) this.jump(to);
  }

  /** Plays; while playing, stops. */
  play() {
    if (this.playing) {
      this.stop();
      return;
    }
    if (this.#model.selection.n >= this.data.size - 1) this.jump(0);
    this.playing = true;
    this.#time = this.data.t[this.#model.selection.n];
    this.#run(this.#model.selection.n, performance.now());
    this.#moved();
  }
  // Requests the next frame: `n` is the record shown last, at `last` milliseconds.
  #run(n, last) {
    requestAnimationFrame((now) => {
      if (!this.playing) return;
      const {data} = this;
      if (this.#model.selection.n !== n) this.#time = data.t[this.n]; // the reader went elsewhere
      this.#time += ((now - last) / 1000) * this.speed;
      n = Math.max(data.at(this.#time), this.#model.selection.n);
      if (n === this.#model.selection.n) this.#moved();
      else this.select(n, 'slide');
      if (this.#time >= data.duration) this.stop();
      else this.#run(n, now);
    });
  }
  stop() {
    this.#time = null;
    if (!this.playing) return;
    this.playing = false;
    this.#moved();
  }
}
