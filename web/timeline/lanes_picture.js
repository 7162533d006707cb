// The timeline's two canvases: the lanes, drawn anew only when something in them changed, and the cursor above them.
import {h} from '../dom.js';
import {themeKey} from '../theme.js';
import {firstReaching, reachOf} from './lane_rows.js';
import {
  Sight,
  axis_px,
  busyBins,
  drawCursor,
  drawLanes,
  drawNotes,
  drawOverview,
  gutter_px,
  overview_px,
  row_px,
} from './lanes_draw.js';

const near_px = 3; // an item this close to the pointer is meant
const bin_px = 2; // of the overview
const most_row_px = 44; // of a lane that is not tall
const tall = 3; // times the height of another

const partsOf = (row) => (row.tall ? tall : 1);
const parts = (rows) => rows.reduce((sum, row) => sum + partsOf(row), 0);

const reaching = (lane) => ({lane, reach: reachOf(lane)});

export class LanesPicture {
  #data;
  #window;
  #marked;
  #flags;
  #rest;
  #base = h('canvas', {'aria-hidden': 'true'});
  #over = h('canvas', {'aria-hidden': 'true', class: 'over'});
  #colours = new Map(); // name -> colour
  #drawn = ''; // the state that the lanes were drawn for
  #theme = '';
  #drawn_rows = null;
  #bins = {key: '', counts: null};
  #notes = [];
  /** Pixels. */
  width = 0;
  /** Pixels: from the top to the end of the lanes, and all of it. */
  lanes_px = 0;
  height = 0;
  #rows;
  #places = []; // {top, px} of each row
  #room = 0; // pixels of height that there are

  /** `rows`: as of laneRows(); `shown`: a TimeWindow; `marked(side, n)`: as of drawLanes(). */
  constructor(data, rows, shown, marked) {
    this.#data = data;
    this.#rows = rows;
    this.#window = shown;
    this.#marked = marked;
    this.#flags = reaching(data.lanes.flag);
    this.#rest = reaching(data.lanes.rest);
    this.canvases = [this.#base, this.#over];
    this.#lay();
  }

  /** As of laneRows(); one that is `tall` has three times the height of another. */
  get rows() {
    return this.#rows;
  }
  set rows(rows) {
    if (rows === this.#rows) return;
    this.#rows = rows;
    this.#lay();
  }
  /** The least height of all rows, in pixels. */
  get least_height() {
    return axis_px + parts(this.#rows) * row_px + overview_px;
  }
  /** Gives the lanes so much room in height; more than they need makes them higher. */
  fit(width, room) {
    this.width = width;
    this.#room = room;
    this.#lay();
  }
  #lay() {
    const each = (this.#room - axis_px - overview_px) / Math.max(1, parts(this.#rows));
    const px = Math.max(row_px, Math.min(most_row_px, Math.floor(each)));
    let top = axis_px;
    this.#places = this.#rows.map((row) => {
      const place = {top, px: partsOf(row) * px};
      top += place.px;
      return place;
    });
    this.lanes_px = top;
    this.height = top + overview_px;
  }

  /** The window shown by the lanes; `overview`: the whole run. */
  get sight() {
    return new Sight(this.#window.axis, this.#window.span, this.width);
  }
  get overview() {
    return new Sight(this.#window.axis, this.#window.whole, this.width);
  }

  /** Draws the cursor at `t`, and the lanes if they have changed; `again`: in any case. @returns whether it did */
  paint(t, again) {
    const theme = themeKey();
    const key = `${this.#window.span} ${this.#window.axis.gaps.length} ${this.width} ${this.height} ${theme}`;
    const changed = again || key !== this.#drawn || this.rows !== this.#drawn_rows;
    if (changed) {
      if (theme !== this.#theme) this.#colours.clear();
      this.#theme = theme;
      this.#drawn = key;
      this.#drawn_rows = this.rows;
      this.#paintLanes();
    }
    const at = {x: this.sight.x(t), overview_x: this.overview.x(t), width: this.width, height: this.lanes_px};
    drawCursor(this.#pen(this.#over), {...at, colour: this.#colour('cursor')});
    return changed;
  }
  #paintLanes() {
    const pen = this.#pen(this.#base);
    const {sight, overview: whole} = this;
    const colour = (name) => this.#colour(name);
    const [rows, flags, rest, data] = [this.rows, this.#flags, this.#rest, this.#data];
    drawLanes(pen, {rows, places: this.#places, sight, flags, rest, colour, marked: this.#marked});
    drawNotes(pen, {notes: this.#notes, sight, colour});
    drawOverview(pen, {data, sight, whole, bins: this.#binsOf(sight), top: this.lanes_px, colour});
  }
  #binsOf({axis, width}) {
    const key = `${width} ${axis.gaps.length}`;
    if (this.#bins.key !== key)
      this.#bins = {key, counts: busyBins(this.#data, axis, Math.ceil((width - gutter_px) / bin_px))};
    return this.#bins.counts;
  }

  /** A pen for the canvas, cleared and of the page's size. */
  #pen(canvas) {
    const {width, height} = this;
    const ratio = devicePixelRatio || 1;
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
      canvas.style.width = `${width}px`;
      canvas.style.height = `${height}px`;
    }
    const pen = canvas.getContext('2d');
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    return pen;
  }
  #colour(name) {
    if (!this.#colours.has(name))
      this.#colours.set(name, getComputedStyle(this.#base).getPropertyValue(`--${name}`).trim());
    return this.#colours.get(name);
  }

  /** `notes`: {from, to} in seconds. */
  showNotes(notes) {
    this.#notes = notes;
  }

  /** The item at a place of the picture, in pixels: {row, i, n, from, to}, or null. */
  itemAt({x, y}) {
    const row = this.rows[this.#places.findLastIndex(({top}) => top <= y)];
    if (!row || x < gutter_px || y < axis_px || y >= this.lanes_px) return null;
    const {sight} = this;
    const {lane} = row;
    const from = sight.t(x - near_px);
    const to = sight.t(x + near_px);
    let best = -1;
    for (let i = firstReaching(row, from); i < lane.n.length && lane.from[i] <= to; ++i)
      if (lane.to[i] >= from) best = i;
    return best < 0 ? null : {row, i: best, n: lane.n[best], from: lane.from[best], to: lane.to[best]};
  }
}
