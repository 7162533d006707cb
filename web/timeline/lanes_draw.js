// Drawing of the timeline: lanes, overview and cursor, on canvases. Times in seconds, places in pixels.
import {clock} from '../dom.js';
import {lastAtMost} from '../search.js';
import {firstReaching} from './lane_rows.js';

export const gutter_px = 92;
export const axis_px = 17;
export const overview_px = 22;
export const row_px = 15; // the least of a lane
const tall_px = 24; // lanes of this height have larger letters
const most_texts = 200; // of a lane, at a time
const least_room_px = 18; // for a text
const ruler_px = 90; // between the times of a ruler

// Eight hues apart from each other; a state keeps its hue in every run.
const hues = [210, 28, 150, 265, 95, 330, 185, 50];
const known_hues = new Map();
const hueOf = (name) => {
  if (!known_hues.has(name)) {
    let sum = 0;
    for (let i = 0; i < name.length; ++i) sum = (sum * 31 + name.charCodeAt(i)) >>> 0;
    known_hues.set(name, hues[sum % hues.length]);
  }
  return known_hues.get(name);
};

/** A step of 1, 2 or 5 times a power of ten that leaves ticks at least `least` pixels apart. */
function tickStep(span, width, least) {
  const rough = (span / width) * least;
  const power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].find((factor) => factor * power >= rough) * power;
}

/** The part of the time axis that is in sight, in pixels. `zoom` in seconds; `axis` a TimeAxis. */
export class Sight {
  constructor(axis, [from, to], width) {
    Object.assign(this, {axis, from, to, width});
    this.start = axis.of(from);
    this.scale = (width - gutter_px) / Math.max(1e-9, axis.of(to) - this.start);
  }
  x(t) {
    return gutter_px + (this.axis.of(t) - this.start) * this.scale;
  }
  t(x) {
    return this.axis.back(this.start + (x - gutter_px) / this.scale);
  }
}

/**
 * `places`: {top, px} of each row; `marked(side, n)`: whether the record differs from the other run's; `flags`:
 * {n, from}.
 */
export function drawLanes(pen, {rows, places, sight, flags, rest, colour, marked}) {
  const {from, to, width} = sight;
  const x = (t) => sight.x(t);
  const {top: last_top, px: last_px} = places.at(-1) ?? {top: axis_px, px: 0};
  const bottom = last_top + last_px;
  pen.font = '10.5px system-ui, sans-serif';
  pen.textBaseline = 'middle';

  // Rows and their names.
  rows.forEach((row, i) => {
    const {top, px} = places[i];
    if (i % 2 === 0) {
      pen.fillStyle = colour('stripe');
      pen.fillRect(0, top, width, px);
    }
    pen.fillStyle = colour('muted');
    pen.textAlign = 'right';
    pen.fillText(row.name, gutter_px - 8, top + px / 2);
  });

  pen.save();
  pen.beginPath();
  pen.rect(gutter_px, 0, width - gutter_px, bottom);
  pen.clip();

  // Stretches in which physics rested.
  pen.fillStyle = colour('rest');
  for (let i = firstReaching(rest, from); i < rest.lane.n.length && rest.lane.from[i] <= to; ++i)
    pen.fillRect(x(rest.lane.from[i]), axis_px, x(rest.lane.to[i]) - x(rest.lane.from[i]), bottom - axis_px);

  drawTicks(pen, sight, bottom, colour);
  rows.forEach((row, i) => {
    const needs = {...places[i], sight, colour, marked};
    pen.font = `${needs.px >= tall_px ? 13 : 10.5}px system-ui, sans-serif`;
    if (row.kind === 'ruler') drawRuler(pen, row, needs);
    else if (row.kind === 'wave') drawWave(pen, row, needs);
    else if (row.kind === 'level') drawLevel(pen, row, needs);
    else drawItems(pen, row, needs);
  });

  // Flags of trouble, across all lanes; one where several stand in one place.
  pen.fillStyle = colour('bad');
  let told = -Infinity;
  for (let i = firstReaching(flags, from); i < flags.lane.n.length && flags.lane.from[i] <= to; ++i) {
    const at = x(flags.lane.from[i]);
    if (at < told + 3) continue;
    told = at;
    pen.globalAlpha = 0.35;
    pen.fillRect(at - 0.5, axis_px, 1, bottom - axis_px);
    pen.globalAlpha = 1;
    triangle(pen, at, axis_px, 4);
  }
  pen.restore();
}

/** Marks on the axis where there are notes: {from, to} in seconds, equal for an instant. */
export function drawNotes(pen, {notes, sight, colour}) {
  pen.fillStyle = colour('accent');
  for (const {from, to} of notes) {
    if (to < sight.from || from > sight.to) continue;
    const left = Math.max(gutter_px, sight.x(from));
    const right = Math.min(sight.width, sight.x(to));
    if (right > left) pen.fillRect(left, axis_px - 3, right - left, 2);
    pen.beginPath();
    pen.arc(left, axis_px - 4, 3.5, 0, 2 * Math.PI);
    pen.fill();
  }
}

const triangle = (pen, x, tip, half) => {
  pen.beginPath();
  pen.moveTo(x - half, tip - half * 1.5);
  pen.lineTo(x + half, tip - half * 1.5);
  pen.lineTo(x, tip);
  pen.fill();
};

function drawTicks(pen, sight, bottom, colour) {
  const {axis, from, to, width} = sight;
  const shown = axis.of(to) - axis.of(from);
  const step = tickStep(shown, width - gutter_px, 70);
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const gaps = axis.gaps.filter(([a, b]) => b > from && a < to);
  pen.textAlign = 'left';
  let last = -Infinity;
  // Ticks stand at round times, between the gaps.
  let stretch_from = from;
  for (const [a, b] of [...gaps, [to, to]]) {
    for (let k = Math.ceil(stretch_from / step); k * step <= Math.min(a, to); ++k) {
      const at = sight.x(k * step);
      pen.fillStyle = colour('line');
      pen.fillRect(Math.round(at), 0, 1, bottom);
      if (at - last < 60) continue;
      pen.fillStyle = colour('muted');
      pen.fillText(clock(k * step, digits), at + 4, axis_px / 2);
      last = at;
    }
    if (b > a) drawGap(pen, sight.x(Math.max(a, from)), sight.x(Math.min(b, to)), bottom, colour);
    stretch_from = b;
  }
}

// The times that a row has at places of the axis.
function drawRuler(pen, {time}, {sight, top, px, colour}) {
  pen.textAlign = 'left';
  for (let x = gutter_px; x < sight.width - ruler_px / 2; x += ruler_px) {
    pen.fillStyle = colour('depth');
    pen.fillRect(Math.round(x), top, 1, px);
    pen.fillStyle = colour('muted');
    pen.fillText(clock(time(sight.t(x)), 1), x + 4, top + px / 2);
  }
}

// A zigzag where idle time was left out.
function drawGap(pen, left, right, bottom, colour) {
  pen.fillStyle = colour('veil');
  pen.fillRect(left, axis_px, right - left, bottom - axis_px);
  if (right - left < 3) return;
  pen.strokeStyle = colour('depth');
  pen.beginPath();
  const middle = (left + right) / 2;
  const half = Math.min(3, (right - left) / 2 - 1);
  for (let y = axis_px, side = -1; y <= bottom; y += 4, side = -side) pen.lineTo(middle + side * half, y);
  pen.stroke();
}

function drawItems(pen, row, {sight, top, px, colour, marked}) {
  const {lane} = row;
  const state = row.kind === 'state';
  const barColour = barColours(row, colour);
  const bars = new Bars(pen, top, px);
  let painted = -Infinity;
  let texts = 0;
  for (let i = firstReaching(row, sight.from); i < lane.n.length && lane.from[i] <= sight.to; ++i) {
    if (lane.to[i] < sight.from) continue;
    const place = placeOf(row, i, sight);
    const {left, right, end, under} = place;
    if (under) {
      pen.fillStyle = colour(row.colour);
      pen.fillRect(left, top + px - 3, end - left, 2);
    }
    if (right < painted + 1) {
      // Hidden under the last one: on to the first that is not.
      i = Math.max(i, lastAtMost(lane.from, sight.t(painted)) - 1);
      continue;
    }
    painted = right;
    const differs = marked?.(row.side, lane.n[i]);
    const gap = state && right - left > 4 ? 1 : 0;
    bars.add({left, right: right - gap, colour: barColour(i), apart: gap || differs});
    if (differs) {
      bars.flush();
      hatch(pen, left, top + 1, Math.max(5, right - left - gap), px - 2, colour('warn'));
    }
    if (place.room < least_room_px || row.plain || texts > most_texts) continue;
    const text = cut(pen, row.text(i), place.room);
    if (!text) continue;
    ++texts;
    bars.flush();
    pen.fillStyle = colour(place.inside && !state ? 'on-bar' : 'text');
    pen.fillText(text, place.text_x, top + px / 2 + 0.5);
  }
  bars.flush();
}

// barColour(i): of the item's bar. States have hues of their own.
function barColours(row, colour) {
  const fill = colour(row.colour);
  if (row.kind !== 'state') return (i) => (row.bad?.(i) ? colour('bad') : fill);
  const shade = `${colour('state-saturation')} ${colour('state-lightness')}`;
  return (i) => `hsl(${hueOf(row.text(i))} ${shade})`;
}

// Where an item is drawn, in pixels: its bar from `left` to `right`, its end, the room for its text and where that begins.
function placeOf({lane, kind}, i, sight) {
  const left = sight.x(lane.from[i]);
  const end = sight.x(lane.to[i]);
  const next = i + 1 < lane.n.length ? sight.x(lane.from[i + 1]) : sight.width;
  // An item that goes on while the next begins leaves it room, and goes on as a thin line below.
  const under = kind !== 'state' && end > next + 1;
  const right = Math.max(left + 2, under ? Math.min(end, Math.max(next - 1, left + 2)) : end);
  // The text goes inside, or behind an instant as far as the next item leaves room.
  const inside = lane.to[i] > lane.from[i] && right - left > 24;
  const start = inside ? Math.max(left, gutter_px) : right;
  const room = (inside ? Math.min(right, sight.width) : next) - start - 6;
  return {left, right, end, under, inside, room, text_x: start + 3};
}

// Draws bars; those that touch and have one colour are drawn as one.
class Bars {
  #pen;
  #top;
  #px;
  #left = 0;
  #right = -Infinity;
  #colour = '';

  constructor(pen, top, px) {
    this.#pen = pen;
    this.#top = top;
    this.#px = px;
  }
  /** `apart`: this bar is drawn by itself. */
  add({left, right, colour, apart}) {
    if (colour !== this.#colour || left > this.#right + 0.5 || apart) this.flush();
    if (this.#right < this.#left) [this.#left, this.#colour] = [left, colour];
    this.#right = right;
  }
  flush() {
    if (this.#right <= this.#left) return;
    this.#pen.fillStyle = this.#colour;
    this.#pen.fillRect(this.#left, this.#top + 2, this.#right - this.#left, this.#px - 4);
    this.#right = -Infinity;
  }
}

// A frame with strokes across: a difference is not shown by colour alone.
function hatch(pen, left, top, width, height, colour) {
  pen.strokeStyle = colour;
  pen.lineWidth = 1.5;
  pen.strokeRect(left, top, width, height);
  pen.beginPath();
  for (let x = left + 3; x < left + width; x += 5) {
    pen.moveTo(x, top + height);
    pen.lineTo(Math.min(x + 4, left + width), top);
  }
  pen.globalAlpha = 0.55;
  pen.stroke();
  pen.globalAlpha = 1;
  pen.lineWidth = 1;
}

// As much of the text as fits, with a mark where it was cut; nothing when too little would be left.
function cut(pen, text, room) {
  if (text.length > room || pen.measureText(text).width > room) {
    const letters = Math.floor((10 * room) / pen.measureText('aeionrst.p').width) - 1;
    return letters >= 4 ? `${text.slice(0, letters)}…` : '';
  }
  return text;
}

function drawLevel(pen, row, {sight, top, px, colour}) {
  const {from, to} = sight;
  const {lane} = row;
  pen.fillStyle = colour(row.colour);
  let painted = -Infinity;
  for (let i = Math.max(0, firstReaching(row, from) - 1); i < lane.n.length && lane.from[i] <= to; ++i) {
    const left = sight.x(lane.from[i]);
    const right = Math.max(left + 1.5, sight.x(lane.to[i]));
    if (right < painted + 0.5) {
      i = Math.max(i, lastAtMost(lane.from, sight.t(painted)) - 1);
      continue;
    }
    painted = right;
    const high = (row.value(i) / row.most) * (px - 3);
    pen.fillRect(left, top + px - 1 - high, right - left, high);
  }
}

// The loudest of each pixel, around the middle of the lane; or why there is nothing.
function drawWave(pen, {sound, colour: name}, {sight, top, px, colour}) {
  const middle = top + px / 2;
  if (!sound.peaks) {
    pen.fillStyle = colour('muted');
    pen.textAlign = 'left';
    pen.fillText(sound.problem, gutter_px + 4, middle + 0.5);
    return;
  }
  const {values, per_second, offset} = sound.peaks;
  const placeAt = (x) => (sight.t(x) + offset) * per_second;
  pen.fillStyle = colour(name);
  for (let x = gutter_px, from = placeAt(x); x < sight.width; ++x) {
    const to = placeAt(x + 1);
    let loudest = -1;
    for (let i = Math.max(0, Math.floor(from)); i < Math.min(values.length, Math.max(to, from + 1)); ++i)
      loudest = Math.max(loudest, values[i]);
    from = to;
    if (loudest < 0) continue;
    const high = Math.max(0.5, (loudest / 100) * (px / 2 - 1));
    pen.fillRect(x, middle - high, 1, 2 * high);
  }
}

/** How much happens when, for the overview: stops a bin, over the whole axis. */
export function busyBins(data, axis, bins) {
  const counts = new Float64Array(Math.max(1, bins));
  const scale = counts.length / Math.max(1e-9, axis.of(data.duration));
  // A sample is as good where there are very many.
  const stride = Math.max(1, Math.floor(data.stops.length / 50000));
  for (let i = 0; i < data.stops.length; i += stride)
    counts[Math.min(counts.length - 1, Math.floor(axis.of(data.t[data.stops[i]]) * scale))] += 1;
  return counts;
}

/** The whole run in small: how much happened when, and the window that is shown above. */
export function drawOverview(pen, {data, sight, whole, bins, top, colour}) {
  const {width} = sight;
  const across = width - gutter_px;
  const most_busy = bins.reduce((a, b) => Math.max(a, b), 1);
  pen.fillStyle = colour('stripe');
  pen.fillRect(gutter_px, top + 3, across, overview_px - 3);
  pen.fillStyle = colour('depth');
  bins.forEach((count, i) => {
    const high = Math.sqrt(count / most_busy) * (overview_px - 6);
    pen.fillRect(gutter_px + i * 2, top + overview_px - 1 - high, 2, high);
  });
  pen.fillStyle = colour('bad');
  const flags = data.lanes.flag.from;
  const stride = Math.max(1, Math.floor(flags.length / 2000));
  for (let i = 0; i < flags.length; i += stride) pen.fillRect(whole.x(flags[i]), top + 3, 1, 4);
  const left = whole.x(sight.from);
  const right = whole.x(sight.to);
  pen.fillStyle = colour('veil');
  pen.fillRect(gutter_px, top + 3, left - gutter_px, overview_px - 3);
  pen.fillRect(right, top + 3, gutter_px + across - right, overview_px - 3);
  pen.strokeStyle = colour('muted');
  pen.strokeRect(left + 0.5, top + 3.5, Math.max(2, right - left - 1), overview_px - 4);
  pen.fillStyle = colour('muted');
  pen.textAlign = 'right';
  pen.fillText('whole run', gutter_px - 8, top + 3 + (overview_px - 3) / 2);
}

export function drawCursor(pen, {x, overview_x, width, height, colour}) {
  pen.fillStyle = colour;
  pen.fillRect(overview_x - 0.5, height + 3, 1.5, overview_px - 3);
  if (x < gutter_px - 1 || x > width + 1) return;
  pen.fillRect(x - 0.75, 0, 1.5, height);
  pen.beginPath();
  pen.moveTo(x - 5, 0);
  pen.lineTo(x + 5, 0);
  pen.lineTo(x, 7);
  pen.fill();
}
