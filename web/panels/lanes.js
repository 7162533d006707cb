// The run over time: the deeds of both, the automaton's states, the stack's depth. On canvases, because there are many.
import {h, panel, clock, counted} from '../dom.js';
import {copyLink} from '../announce.js';
import {calmly} from '../calmly.js';
import {laneChoice} from '../timeline/lane_choice.js';
import {laneRows} from '../timeline/lane_rows.js';
import {listenToMouse} from '../timeline/lanes_mouse.js';
import {LanesPicture} from '../timeline/lanes_picture.js';
import {gutter_px} from '../timeline/lanes_draw.js';
import {Stretch} from '../timeline/stretch.js';
import {TimeAxis, idleGaps} from '../timeline/time_axis.js';
import {TimeWindow} from '../timeline/time_window.js';

const calm_ms = 250; // between drawings for labels that have come
const nearer = 0.6; // of a press of a button
const margin_px = 8; // above and below the lanes

/** The time axes of a run: with idle stretches drawn short, and as long as they were. */
export function axesOf(data) {
  const {speech, gesture, pointing, act} = data.lanes;
  const gaps = idleGaps(data.reached, data.stops, [speech, gesture, pointing, act], data.duration);
  return {short: new TimeAxis(gaps), full: new TimeAxis()};
}

class Lanes {
  #data;
  #cursor;
  #comparison;
  #window;
  #picture;
  #tip = h('div', {class: 'tip', hidden: true, 'aria-hidden': 'true'});
  #slider;
  #host;
  #choice = null; // of lanes; none in a comparison, where lanes stand in pairs
  #stretch;
  #span = h('span', {class: 'muted', 'data-testid': 'span'});
  #gaps = h('input', {type: 'checkbox', 'data-testid': 'gaps'});
  #by_time = h('input', {type: 'checkbox', 'data-testid': 'by-time'});
  #kinds; // the rows: of a comparison by meaning and by time

  /**
   * `comparison`: with the run that this one is compared with, or null. Each lane is then drawn twice, this run's above.
   * `note(records)`, `save(span)`: the uses of a selected stretch.
   */
  constructor({data, model, cursor, comparison, note, save}) {
    this.#data = data;
    this.#cursor = cursor;
    this.#comparison = comparison;
    const own = laneRows(data);
    this.#kinds = comparison
      ? {meaning: doubled(own, comparison, 'meaning'), time: doubled(own, comparison, 'time')}
      : {meaning: own};
    const axes = axesOf(data);
    this.#window = new TimeWindow(data.duration, axes, model);
    this.#picture = new LanesPicture(data, this.#kinds.meaning, this.#window, comparison?.marked);
    this.#stretch = new Stretch(data.lanes, {
      zoom: (zoom) => model.go({zoom}, 'slide'),
      note: (span) => note(span.map((t) => data.at(t))),
      link: (zoom) => {
        model.settle({zoom});
        this.#paint();
        copyLink();
      },
      save,
    });
    this.#slider = this.#mountSlider();
    this.#gaps.addEventListener('change', () => model.go({gaps: !this.#gaps.checked}));
    this.#by_time.addEventListener('change', () => model.go({by_time: this.#by_time.checked}));
    this.#host = h('div', {class: 'canvases'}, this.#slider, this.#stretch.card);
    if (!comparison) this.#choice = laneChoice(own, (rows) => this.#choose(rows));
    this.element = panel('lanes', 'Timeline', this.#controls(axes.short.gaps.length), this.#host);
    if (this.#choice) this.#choose(this.#choice.rows);
    listenToMouse(this.#slider, {
      picture: this.#picture,
      shown: this.#window,
      stretch: this.#stretch,
      seek: (t, how) => cursor.select(data.at(Math.max(0, Math.min(data.duration, t))), how),
      open: (item) => this.#open(item),
      tell: (item, place) => this.#tell(item, place),
    });
    new ResizeObserver(() => this.#resized()).observe(this.#host);
  }

  #mountSlider() {
    const slider = h(
      'div',
      {
        class: 'timeline',
        role: 'slider',
        tabindex: 0,
        'aria-label': 'Time',
        'aria-valuemin': 0,
        'aria-valuemax': this.#data.duration.toFixed(3),
        'aria-orientation': 'horizontal',
        'data-testid': 'timeline',
      },
      this.#picture.canvases,
      this.#stretch.band,
      this.#tip,
    );
    return slider;
  }
  #controls(pauses) {
    const button = (label, title, shown, act) =>
      h('button', {type: 'button', title, 'aria-label': label, onclick: act}, shown);
    const short = `${counted(pauses, 'pause')} short`;
    return [
      h('span', {class: 'muted coach'}, '← → step · Space play · ? all keys'),
      this.#span,
      this.#comparison &&
        h('label', {title: 'B at its own times, not where A has the same inputs'}, this.#by_time, 'by time'),
      pauses > 0 && h('label', {title: 'Draw idle time short (G)'}, this.#gaps, short),
      button('Zoom in', 'Zoom in (W)', '+', () => this.zoomBy(nearer)),
      button('Zoom out', 'Zoom out (S)', '−', () => this.zoomBy(1 / nearer)),
      button(null, 'The whole run (0)', 'All', () => this.all()),
      this.#choice?.element,
    ];
  }

  #choose(rows) {
    this.#kinds = {meaning: rows};
    this.#picture.rows = rows;
    this.#resized();
  }
  // Where there is more room than the lanes need they are higher.
  #resized() {
    this.#slider.style.setProperty('min-height', `${this.#picture.least_height}px`);
    this.#picture.fit(this.#slider.clientWidth, this.#host.clientHeight - this.#stretch.card.offsetHeight - margin_px);
    this.#paint();
  }
  #paint(again = false) {
    if (!this.#picture.width || !this.#picture.paint(this.#cursor.time, again)) return;
    const [from, to] = this.#window.span.map((t) => clock(t, 1));
    this.#span.textContent = `${from} – ${to} of ${clock(this.#data.duration, 1)}`;
    this.#stretch.place((t) => this.#picture.sight.x(t));
  }

  #open({row, n}) {
    this.#cursor.jump(row.side === 'b' ? this.#comparison.toOwn(n) : n);
  }
  // Words about an item next to the pointer.
  #tell(item, place) {
    this.#tip.hidden = !place || place.x < gutter_px;
    if (this.#tip.hidden) return;
    this.#tip.textContent = item ? itemText(item) : this.#instantText(place);
    const left = Math.min(place.x + 12, this.#picture.width - this.#tip.offsetWidth - 4);
    this.#tip.style.setProperty('left', `${left}px`);
    this.#tip.style.setProperty('top', `${place.y > this.#picture.lanes_px / 2 ? place.y - 28 : place.y + 16}px`);
  }

  // The instant under the pointer, and the automaton's state then.
  #instantText({x, y}) {
    const along = y >= this.#picture.lanes_px ? this.#picture.overview : this.#picture.sight;
    const t = Math.max(0, Math.min(this.#data.duration, along.t(x)));
    return [clock(t, 2), this.#data.state(this.#data.at(t))].filter(Boolean).join(', ');
  }

  get rows() {
    return this.#picture.rows;
  }
  zoomBy(factor) {
    this.#window.zoomBy(factor, this.#data.t[this.#cursor.n]);
  }
  panBy(part) {
    this.#window.panBy(part);
  }
  all() {
    this.#window.showAll();
  }
  /** Where an instant is drawn, in pixels from the left. */
  placeOf(t) {
    return this.#picture.sight.x(t);
  }
  /** Where notes stand: {from, to} in seconds. */
  showNotes(notes) {
    this.#picture.showNotes(notes);
    this.#paint(true);
  }

  labelsArrived = calmly(() => this.#paint(true), calm_ms);

  render({n, gaps, by_time}) {
    const data = this.#data;
    this.#by_time.checked = by_time;
    this.#picture.rows = this.#kinds[by_time ? 'time' : 'meaning'] ?? this.#kinds.meaning;
    this.#gaps.checked = !gaps;
    this.#slider.setAttribute('aria-valuenow', data.t[n].toFixed(3));
    this.#slider.setAttribute('aria-valuetext', `${clock(data.t[n], 2)}, ${data.state(n) ?? ''}`);
    this.#paint();
  }
}

function itemText({row, i, from, to}) {
  const span = `${clock(from, 2)}${to > from ? ` – ${clock(to, 2)}` : ''}`;
  return `${row.name}: ${row.text(i)}, ${span}`;
}

const none = {n: new Uint32Array(), from: new Float64Array(), to: new Float64Array()};
const same = (a) => (b) => a.name === b.name && a.colour === b.colour;
const empty = (row) => ({...row, lane: none, reach: none.to});
// The times of B above the lanes, then each lane of A with that of B below it, as far as either has anything.
function doubled(own, comparison, by) {
  const others = comparison.rows[by];
  const time = by === 'time' ? (t) => t : (t) => comparison.timeToOther(t);
  const ruler = {name: 'time of B', side: 'ruler', kind: 'ruler', lane: none, reach: none.to, time, text: () => ''};
  const missing = others.filter((row) => !own.some(same(row))).map(empty);
  const pairs = [...own, ...missing]
    .map((row) => [
      {...row, name: `A ${row.name}`, side: 'a'},
      {...(others.find(same(row)) ?? empty(row)), name: 'B', side: 'b'},
    ])
    .filter(([a, b]) => a.lane.n.length || b.lane.n.length);
  return [ruler, ...pairs.flat()];
}

export const mountLanes = (needs) => new Lanes(needs);
