// Drawing of the timeline: lanes, overview and cursor, on canvases. Times in seconds, places in pixels.
import {brief} from './dom.js';
import {lastAtMost} from './run_data.js';

export const gutter_px = 92, axis_px = 17, overview_px = 22, row_px = 15;

/**
 * The lanes from top to bottom. @returns {{name, colour, items: {from, to, n, text}[], starts: number[]}[]}
 */
export function laneRows(data) {
  const {lanes} = data;
  const row = (name, colour, items, kind = 'bar') => {
    items.sort((a, b) => a.from - b.from);
    // One that goes on while others come and go is drawn as a thin line below them.
    items.forEach((item, i) => { item.under = kind === 'bar' && i + 1 < items.length && items[i + 1].to < item.to && items[i + 1].from > item.from; });
    return {name, colour, kind, items, starts: items.map((item) => item.from), under: items.filter((item) => item.under)};
  };
  const spans = (list) => list.map(([from, to, n, text]) => ({from, to, n, text: brief(text)}));
  const instants = (list) => list.map(([t, n, text]) => ({from: t, to: t, n, text: brief(text)}));
  const acts = lanes.act.map(([from, to, n, program, status]) => ({from, to, n, text: `${brief(program)} ${status}`, bad: status !== 'done'}));
  const depth = lanes.depth.map(([t, n, value], i) =>
    ({from: t, to: i + 1 < lanes.depth.length ? lanes.depth[i + 1][0] : data.duration, n, text: `${value}`, value}));
  return [
    row('human says', 'human', spans(lanes.speech)),
    row('shows', 'human', spans(lanes.gesture)),
    row('points', 'human', lanes.pointing.map(([from, to, n, count]) => ({from, to, n, text: `${count} samples`, plain: true}))),
    row('state', 'state', data.segments.map(({state, from, to, n}) => ({from, to, n, text: state})), 'state'),
    row('stack depth', 'depth', depth, 'depth'),
    row('avatar says', 'avatar', instants(lanes.utterance)),
    row('shows', 'avatar', instants(lanes.move)),
    row('acts', 'act', acts),
    ...(lanes.observed?.length ? [row('as recorded', 'depth', instants(lanes.observed))] : []),
  ];
}

// Eight hues apart from each other; a state keeps its hue in every run.
const hues = [210, 28, 150, 265, 95, 330, 185, 50];
const hueOf = (name) => {
  let sum = 0;
  for (let i = 0; i < name.length; ++i) sum = (sum * 31 + name.charCodeAt(i)) >>> 0;
  return hues[sum % hues.length];
};

/** A step of 1, 2 or 5 times a power of ten that leaves ticks at least `least` pixels apart. */
function tickStep(span, width, least) {
  const rough = span / width * least, power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].find((factor) => factor * power >= rough) * power;
}

export function drawLanes(pen, {data, rows, zoom: [from, to], width, colour}) {
  const x = (t) => gutter_px + (t - from) / (to - from) * (width - gutter_px);
  const bottom = axis_px + rows.length * row_px;
  pen.font = '10.5px system-ui, sans-serif';
  pen.textBaseline = 'middle';

  // Rows and their names.
  rows.forEach((row, i) => {
    if (i % 2 === 0) {
      pen.fillStyle = colour('stripe');
      pen.fillRect(0, axis_px + i * row_px, width, row_px);
    }
    pen.fillStyle = colour('muted');
    pen.textAlign = 'right';
    pen.fillText(row.name, gutter_px - 8, axis_px + (i + 0.5) * row_px);
  });

  pen.save();
  pen.beginPath();
  pen.rect(gutter_px, 0, width - gutter_px, bottom);
  pen.clip();

  // Stretches in which physics rested.
  pen.fillStyle = colour('rest');
  for (const [a, b] of data.lanes.rest) if (b > from && a < to) pen.fillRect(x(a), axis_px, x(b) - x(a), bottom - axis_px);

  // Ticks.
  const step = tickStep(to - from, width - gutter_px, 70);
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  pen.textAlign = 'left';
  for (let k = Math.ceil(from / step); k * step <= to; ++k) {
    pen.fillStyle = colour('line');
    pen.fillRect(Math.round(x(k * step)), 0, 1, bottom);
    pen.fillStyle = colour('muted');
    pen.fillText(`${(k * step).toFixed(digits)} s`, x(k * step) + 4, axis_px / 2);
  }

  rows.forEach((row, i) => {
    const top = axis_px + i * row_px;
    if (row.kind === 'depth') drawDepth(pen, row, {from, to, x, top, colour});
    else drawItems(pen, row, {from, to, x, top, colour, width});
  });

  // What went wrong, across all lanes.
  for (const [t] of data.lanes.flags) {
    if (t < from || t > to) continue;
    pen.fillStyle = colour('bad');
    pen.globalAlpha = 0.35;
    pen.fillRect(x(t) - 0.5, axis_px, 1, bottom - axis_px);
    pen.globalAlpha = 1;
    pen.beginPath();
    pen.moveTo(x(t) - 4, axis_px - 6);
    pen.lineTo(x(t) + 4, axis_px - 6);
    pen.lineTo(x(t), axis_px);
    pen.fill();
  }
  pen.restore();
}

function drawItems(pen, row, {from, to, x, top, colour, width}) {
  pen.fillStyle = colour(row.colour);
  for (const item of row.under)
    if (item.from <= to && item.to >= from) pen.fillRect(x(item.from), top + row_px - 3, x(item.to) - x(item.from), 2);
  // Other items overlap little, so few before the window can reach into it.
  const first = Math.max(0, lastAtMost(row.starts, from) - 8);
  let painted = -Infinity;
  for (let i = first; i < row.items.length && row.items[i].from <= to; ++i) {
    const item = row.items[i];
    if (item.under ? item.from < from : item.to < from) continue;
    const left = x(item.from), right = item.under ? left + 2 : Math.max(left + 2, x(item.to));
    if (right < painted + 0.5) continue;  // hidden under the last one
    painted = right;
    const state = row.kind === 'state';
    pen.fillStyle = state ? `hsl(${hueOf(item.text)} ${colour('state-saturation')} ${colour('state-lightness')})` : colour(item.bad ? 'bad' : row.colour);
    const gap = state && right - left > 4 ? 1 : 0;
    pen.fillRect(left, top + 2, right - left - gap, row_px - 4);
    // The text goes inside, or behind an instant as far as the next one leaves room.
    const next = i + 1 < row.items.length ? x(row.items[i + 1].from) : width;
    const inside = item.to > item.from && !item.under && right - left > 24;
    const room = inside ? Math.min(right, width) - Math.max(left, gutter_px) - 6 : next - right - 6;
    if (room < 18 || item.plain) continue;
    const text = cut(pen, item.text, room);
    if (!text) continue;
    pen.fillStyle = inside ? colour(state ? 'text' : 'on-bar') : colour('text');
    pen.fillText(text, (inside ? Math.max(left, gutter_px) : right) + 3, top + row_px / 2 + 0.5);
  }
}

// As much of the text as fits, with a mark where it was cut; nothing when too little would be left.
function cut(pen, text, room) {
  if (pen.measureText(text).width <= room) return text;
  const letters = Math.floor(room / 5.6) - 1;
  return letters >= 4 ? `${text.slice(0, letters)}…` : '';
}

function drawDepth(pen, row, {from, to, x, top, colour}) {
  const most = Math.max(1, ...row.items.map((item) => item.value));
  pen.fillStyle = colour('depth');
  for (let i = Math.max(0, lastAtMost(row.starts, from)); i < row.items.length && row.items[i].from <= to; ++i) {
    const {from: a, to: b, value} = row.items[i];
    const high = value / most * (row_px - 3);
    pen.fillRect(x(a), top + row_px - 1 - high, Math.max(1, x(b) - x(a)), high);
  }
}

/** The whole run in small: how much happened when, and the window that is shown above. */
export function drawOverview(pen, {data, zoom, width, top, colour}) {
  const across = width - gutter_px, x = (t) => gutter_px + t / (data.duration || 1) * across;
  const bins = new Float64Array(Math.max(1, Math.ceil(across / 2)));
  for (const n of data.lanes.interest) bins[Math.min(bins.length - 1, Math.floor(data.t[n] / (data.duration || 1) * bins.length))] += 1;
  const most = Math.max(1, ...bins);
  pen.fillStyle = colour('stripe');
  pen.fillRect(gutter_px, top + 3, across, overview_px - 3);
  pen.fillStyle = colour('depth');
  bins.forEach((count, i) => {
    const high = Math.sqrt(count / most) * (overview_px - 6);
    pen.fillRect(gutter_px + i * 2, top + overview_px - 1 - high, 2, high);
  });
  pen.fillStyle = colour('bad');
  for (const [t] of data.lanes.flags) pen.fillRect(x(t), top + 3, 1, 4);
  pen.fillStyle = colour('veil');
  pen.fillRect(gutter_px, top + 3, x(zoom[0]) - gutter_px, overview_px - 3);
  pen.fillRect(x(zoom[1]), top + 3, gutter_px + across - x(zoom[1]), overview_px - 3);
  pen.strokeStyle = colour('muted');
  pen.strokeRect(x(zoom[0]) + 0.5, top + 3.5, Math.max(2, x(zoom[1]) - x(zoom[0]) - 1), overview_px - 4);
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
