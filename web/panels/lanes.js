// The run over time: who did what when, the automaton's states, the stack's depth. Canvas, because there is much of it.
import {h, panel, counted} from '../dom.js';
import {calmly} from '../calmly.js';
import {firstReaching, laneRows, reachOf} from '../timeline/lane_rows.js';
import {Sight, busyBins, drawLanes, drawOverview, drawNotes, drawCursor, gutter_px, axis_px, overview_px, row_px} from '../timeline/lanes_draw.js';
import {TimeAxis, idleGaps} from '../timeline/time_axis.js';

const least_s = 0.05;  // as far as one can zoom in
const calm_ms = 250;   // between drawings for labels that have come

/** The time axes of a run: with idle stretches drawn short, and as long as they were. */
export function axesOf(data) {
  const {speech, gesture, pointing, act} = data.lanes;
  return {short: new TimeAxis(idleGaps(data.reached, data.stops, [speech, gesture, pointing, act], data.duration)), full: new TimeAxis()};
}

/**
 * `comparison`, where two runs are shown: {rows: the other run's, placed in this one's time, marked(side, n)}. Each
 * lane is then drawn twice, this run's above.
 */
export function mountLanes(app, comparison = null) {
  const {data} = app;
  const own = laneRows(data);
  const rows = comparison ? doubled(own, comparison.rows) : own;
  const flags = {lane: data.lanes.flag, reach: reachOf(data.lanes.flag)}, rest = {lane: data.lanes.rest, reach: reachOf(data.lanes.rest)};
  const axes = axesOf(data);
  const lanes_px = axis_px + rows.length * row_px;
  const base = h('canvas', {'aria-hidden': 'true'});
  const over = h('canvas', {'aria-hidden': 'true', class: 'over'});
  const tip = h('div', {class: 'tip', hidden: true, 'aria-hidden': 'true'});
  const slider = h('div', {class: 'timeline', role: 'slider', tabindex: 0, 'aria-label': 'Time', 'aria-valuemin': 0, 'aria-valuemax': data.duration.toFixed(3),
    'aria-orientation': 'horizontal', 'data-testid': 'timeline'}, base, over, tip);
  const span = h('span', {class: 'muted', 'data-testid': 'span'});
  const gaps = h('input', {type: 'checkbox', 'data-testid': 'gaps', onchange: () => app.model.go({gaps: !gaps.checked})});

  let notes = [], width = 0, selection = app.model.selection, drawn = '', bins = null, bins_of = null;
  const axis = () => (selection.gaps ? axes.full : axes.short);
  const zoom = () => selection.zoom ?? [0, data.duration || 1];
  const sight = () => new Sight(axis(), zoom(), width);
  const whole = () => new Sight(axis(), [0, data.duration || 1], width);

  // Stretches are moved and scaled as they are drawn: along the axis.
  const shownAs = ([from, to]) => {
    const least = Math.min(least_s, data.duration || 1);
    const start = Math.max(0, Math.min(data.duration - least, axis().back(from))), end = Math.min(data.duration || 1, axis().back(to));
    return [start, Math.max(start + least, end)];
  };
  const onAxis = () => zoom().map((t) => axis().of(t));
  const zoomTo = (places, how = 'slide') => {
    const end = axis().of(data.duration || 1), wide = Math.min(end, places[1] - places[0]), from = Math.max(0, Math.min(end - wide, places[0]));
    app.model.go({zoom: shownAs([from, from + wide])}, how);
  };
  const zoomBy = (factor, at = data.t[selection.n]) => {
    const [from, to] = onAxis(), place = axis().of(at);
    const middle = place >= from && place <= to ? place : (from + to) / 2;
    zoomTo([middle - (middle - from) * factor, middle + (to - middle) * factor]);
  };
  const panBy = (part) => {
    const [from, to] = onAxis(), by = (to - from) * part;
    zoomTo([from + by, to + by]);
  };
  const all = () => app.model.go({zoom: [0, data.duration || 1]}, 'slide');
  const element = panel('lanes', 'Timeline', [h('span', {class: 'muted coach'}, '← → step · Space play · ? all keys'), span,
    axes.short.gaps.length > 0 && h('label', {title: 'Draw idle time short (G)'}, gaps, `${counted(axes.short.gaps.length, 'pause')} short`),
    h('button', {type: 'button', title: 'Zoom in (W)', 'aria-label': 'Zoom in', onclick: () => zoomBy(0.6)}, '+'),
    h('button', {type: 'button', title: 'Zoom out (S)', 'aria-label': 'Zoom out', onclick: () => zoomBy(1 / 0.6)}, '−'),
    h('button', {type: 'button', title: 'The whole run (0)', onclick: all}, 'All')], h('div', {class: 'canvases'}, slider));

  const context = (canvas) => {
    const ratio = devicePixelRatio || 1, height = lanes_px + overview_px;
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
  };
  const colours = new Map();
  const colour = (name) => {
    if (!colours.has(name)) colours.set(name, getComputedStyle(slider).getPropertyValue(`--${name}`).trim());
    return colours.get(name);
  };
  const paint = (again = false) => {
    if (!width) return;
    const theme = `${document.documentElement.dataset.theme} ${matchMedia('(prefers-color-scheme: dark)').matches}`;
    const key = `${zoom()} ${selection.gaps} ${width} ${theme}`;
    const seen = sight(), entire = whole();
    if (again || key !== drawn) {
      if (!drawn.endsWith(theme)) colours.clear();
      drawn = key;
      if (bins_of !== `${width} ${selection.gaps}`) {
        bins_of = `${width} ${selection.gaps}`;
        bins = busyBins(data, axis(), Math.ceil((width - gutter_px) / 2));
      }
      const pen = context(base);
      drawLanes(pen, {rows, sight: seen, flags, rest, colour, marked: comparison?.marked});
      drawNotes(pen, {notes, sight: seen, colour});
      drawOverview(pen, {data, sight: seen, whole: entire, bins, top: lanes_px, colour});
      span.textContent = `${zoom()[0].toFixed(1)} – ${zoom()[1].toFixed(1)} s of ${data.duration.toFixed(1)} s`;
    }
    const t = app.time ?? data.t[selection.n];
    drawCursor(context(over), {x: seen.x(t), overview_x: entire.x(t), width, height: lanes_px, colour: colour('cursor')});
  };

  // What lies under the pointer: an item of its row, or nothing.
  const itemAt = (x, y) => {
    const row = rows[Math.floor((y - axis_px) / row_px)];
    if (!row || x < gutter_px || y < axis_px || y >= lanes_px) return null;
    const seen = sight(), from = seen.t(x - 3), to = seen.t(x + 3), {lane} = row;
    let best = -1;
    for (let i = firstReaching(row, from); i < lane.n.length && lane.from[i] <= to; ++i) if (lane.to[i] >= from) best = i;
    return best < 0 ? null : {row, i: best, n: lane.n[best], from: lane.from[best], to: lane.to[best]};
  };
  const place = (event) => {
    const box = slider.getBoundingClientRect();
    return {x: event.clientX - box.left, y: event.clientY - box.top};
  };
  const scrub = (x, how) => app.select(data.at(Math.max(0, Math.min(data.duration, sight().t(x)))), how);
  const go = (hit) => (hit.row.side === 'b' ? app.jumpOther(hit.n) : app.jump(hit.n));

  slider.addEventListener('wheel', (event) => {
    event.preventDefault();
    if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) panBy((event.deltaX || event.deltaY) / width);
    else zoomBy(Math.exp(event.deltaY * 0.002), sight().t(place(event).x));
  }, {passive: false});
  slider.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    const {x, y} = place(event), start = onAxis();
    const what = y >= lanes_px ? 'overview' : y < axis_px ? 'scrub' : 'pan';
    let moved = false;
    const overview = (at) => {
      const half = (start[1] - start[0]) / 2, middle = axis().of(whole().t(at));
      zoomTo([middle - half, middle + half]);
    };
    if (what === 'scrub') scrub(x, 'jump');
    if (what === 'overview') overview(x);
    const move = (next) => {
      const at = place(next);
      if (Math.abs(at.x - x) > 3) moved = true;
      if (!moved) return;
      if (what === 'scrub') scrub(at.x, 'slide');
      else if (what === 'overview') overview(at.x);
      else {
        const by = (x - at.x) / (width - gutter_px) * (start[1] - start[0]);
        zoomTo([start[0] + by, start[1] + by]);
      }
    };
    const done = (last) => {
      removeEventListener('pointermove', move);
      if (moved || what === 'scrub') return;
      const at = place(last);
      if (what === 'overview') { app.select(data.at(Math.max(0, whole().t(at.x))), 'jump'); return; }
      const hit = itemAt(at.x, at.y);
      if (hit) go(hit); else if (at.x >= gutter_px) scrub(at.x, 'jump');
    };
    addEventListener('pointermove', move);
    addEventListener('pointerup', done, {once: true});
  });
  slider.addEventListener('pointermove', (event) => {
    const {x, y} = place(event), hit = event.buttons ? null : itemAt(x, y);
    tip.hidden = !hit;
    if (!hit) return;
    tip.textContent = `${hit.row.name}: ${hit.row.text(hit.i)}, ${hit.from.toFixed(2)}${hit.to > hit.from ? ` – ${hit.to.toFixed(2)}` : ''} s`;
    tip.style.setProperty('left', `${Math.min(x + 12, width - tip.offsetWidth - 4)}px`);
    tip.style.setProperty('top', `${y > lanes_px / 2 ? y - 28 : y + 16}px`);
  });
  slider.addEventListener('pointerleave', () => { tip.hidden = true; });
  new ResizeObserver(() => { width = slider.clientWidth; paint(); }).observe(slider);
  slider.style.setProperty('height', `${lanes_px + overview_px}px`);

  return {
    element, rows,
    /** Where an instant is drawn, in pixels from the left. */
    placeOf: (t) => sight().x(t),
    /** Where notes stand: {from, to} in seconds. */
    showNotes(where) { notes = where; paint(true); },
    zoomBy, panBy, all,
    labelsArrived: calmly(() => paint(true), calm_ms),
    render(next) {
      selection = next;
      gaps.checked = !next.gaps;
      slider.setAttribute('aria-valuenow', data.t[next.n].toFixed(3));
      slider.setAttribute('aria-valuetext', `${data.t[next.n].toFixed(2)} seconds, ${data.state(next.n) ?? ''}`);
      paint();
    },
  };
}

const none = {n: new Uint32Array(), from: new Float64Array(), to: new Float64Array()};
// Each lane of A with that of B below it, as far as either has anything.
function doubled(own, others) {
  const missing = others.filter(({name, colour}) => !own.some((row) => row.name === name && row.colour === colour)).map((row) => ({...row, lane: none, reach: none.to}));
  return [...own, ...missing].map((row) => [{...row, name: `A ${row.name}`, side: 'a'}, {...twinOf(row, others), name: 'B', side: 'b'}])
    .filter(([a, b]) => a.lane.n.length || b.lane.n.length).flat();
}
const twinOf = (row, others) => others.find(({name, colour}) => name === row.name && colour === row.colour) ?? {...row, lane: none, reach: none.to};
