// The run over time: who did what when, the automaton's states, the stack's depth. Canvas, because there is much of it.
import {h, panel} from '../dom.js';
import {laneRows, drawLanes, drawOverview, drawCursor, gutter_px, axis_px, overview_px, row_px} from '../lanes_draw.js';
import {lastAtMost} from '../run_data.js';

const least_s = 0.05;  // as far as one can zoom in

export function mountLanes(app) {
  const {data} = app;
  const rows = laneRows(data);
  const lanes_px = axis_px + rows.length * row_px;
  const base = h('canvas', {'aria-hidden': 'true'});
  const over = h('canvas', {'aria-hidden': 'true', class: 'over'});
  const tip = h('div', {class: 'tip', hidden: true, 'aria-hidden': 'true'});
  const slider = h('div', {class: 'timeline', role: 'slider', tabindex: 0, 'aria-label': 'Time', 'aria-valuemin': 0, 'aria-valuemax': data.duration.toFixed(3),
    'aria-orientation': 'horizontal', 'data-testid': 'timeline'}, base, over, tip);
  const span = h('span', {class: 'muted', 'data-testid': 'span'});
  const zoomTo = (zoom, how = 'slide') => {
    const width = Math.min(data.duration || 1, Math.max(least_s, zoom[1] - zoom[0]));
    const from = Math.max(0, Math.min((data.duration || 1) - width, zoom[0]));
    app.model.go({zoom: [from, from + width]}, how);
  };
  const element = panel('lanes', 'Timeline', [span,
    h('button', {type: 'button', title: 'Zoom in (W)', 'aria-label': 'Zoom in', onclick: () => zoomBy(0.6)}, '+'),
    h('button', {type: 'button', title: 'Zoom out (S)', 'aria-label': 'Zoom out', onclick: () => zoomBy(1 / 0.6)}, '−'),
    h('button', {type: 'button', title: 'The whole run (0)', onclick: () => zoomTo([0, data.duration])}, 'All')], slider);

  let width = 0, selection = app.model.selection, drawn = '';
  const zoom = () => selection.zoom ?? [0, data.duration || 1];
  const xOf = (t) => gutter_px + (t - zoom()[0]) / (zoom()[1] - zoom()[0]) * (width - gutter_px);
  const tOf = (x) => zoom()[0] + (x - gutter_px) / (width - gutter_px) * (zoom()[1] - zoom()[0]);
  const tOfOverview = (x) => (x - gutter_px) / (width - gutter_px) * data.duration;
  const zoomBy = (factor, at = data.t[selection.n]) => {
    const [from, to] = zoom();
    const middle = at >= from && at <= to ? at : (from + to) / 2;
    zoomTo([middle - (middle - from) * factor, middle + (to - middle) * factor]);
  };
  const panBy = (part) => {
    const [from, to] = zoom(), by = (to - from) * part;
    zoomTo([from + by, to + by]);
  };

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
  const paint = () => {
    if (!width) return;
    const key = `${zoom()} ${width} ${document.documentElement.dataset.theme} ${matchMedia('(prefers-color-scheme: dark)').matches}`;
    if (key !== drawn) {
      drawn = key;
      const pen = context(base), style = getComputedStyle(slider);
      const colour = (name) => style.getPropertyValue(`--${name}`).trim();
      drawLanes(pen, {data, rows, zoom: zoom(), width, colour});
      drawOverview(pen, {data, zoom: zoom(), width, top: lanes_px, colour});
      span.textContent = `${zoom()[0].toFixed(1)} – ${zoom()[1].toFixed(1)} s of ${data.duration.toFixed(1)} s`;
    }
    drawCursor(context(over), {x: xOf(data.t[selection.n]), overview_x: gutter_px + data.t[selection.n] / (data.duration || 1) * (width - gutter_px),
      width, height: lanes_px, colour: getComputedStyle(slider).getPropertyValue('--cursor').trim()});
  };

  // What lies under the pointer: an item of its row, or nothing.
  const itemAt = (x, y) => {
    const row = rows[Math.floor((y - axis_px) / row_px)];
    if (!row || x < gutter_px || y < axis_px || y >= lanes_px) return null;
    const slack = 3 * (zoom()[1] - zoom()[0]) / (width - gutter_px), t = tOf(x);
    let best = null;
    for (let i = lastAtMost(row.starts, t + slack); i >= 0 && i > lastAtMost(row.starts, t + slack) - 40; --i) {
      const item = row.items[i];
      if (item.to >= t - slack && (!best || item.from > best.from)) best = item;
    }
    best ??= row.under.find((item) => item.from <= t && item.to >= t);
    return best && {row, item: best};
  };
  const place = (event) => {
    const box = slider.getBoundingClientRect();
    return {x: event.clientX - box.left, y: event.clientY - box.top};
  };
  const scrub = (x, how) => app.select(data.at(Math.max(0, Math.min(data.duration, tOf(x)))), how);

  slider.addEventListener('wheel', (event) => {
    event.preventDefault();
    if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) panBy((event.deltaX || event.deltaY) / width);
    else zoomBy(Math.exp(event.deltaY * 0.002), tOf(place(event).x));
  }, {passive: false});
  slider.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    const {x, y} = place(event), start = zoom();
    const what = y >= lanes_px ? 'overview' : y < axis_px ? 'scrub' : 'pan';
    let moved = false;
    const overview = (at) => {
      const half = (start[1] - start[0]) / 2, t = tOfOverview(at);
      zoomTo([t - half, t + half]);
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
      if (what === 'overview') { app.select(data.at(Math.max(0, tOfOverview(at.x))), 'jump'); return; }
      const hit = itemAt(at.x, at.y);
      if (hit) app.jump(hit.item.n); else if (at.x >= gutter_px) scrub(at.x, 'jump');
    };
    addEventListener('pointermove', move);
    addEventListener('pointerup', done, {once: true});
  });
  slider.addEventListener('pointermove', (event) => {
    const {x, y} = place(event), hit = event.buttons ? null : itemAt(x, y);
    tip.hidden = !hit;
    if (!hit) return;
    const {item, row} = hit;
    tip.textContent = `${row.name}: ${item.text}, ${item.from.toFixed(2)}${item.to > item.from ? ` – ${item.to.toFixed(2)}` : ''} s`;
    tip.style.setProperty('left', `${Math.min(x + 12, width - tip.offsetWidth - 4)}px`);
    tip.style.setProperty('top', `${y > lanes_px / 2 ? y - 28 : y + 16}px`);
  });
  slider.addEventListener('pointerleave', () => { tip.hidden = true; });
  new ResizeObserver(() => { width = slider.clientWidth; paint(); }).observe(slider);
  slider.style.setProperty('height', `${lanes_px + overview_px}px`);

  return {
    element, zoomBy, panBy, all: () => zoomTo([0, data.duration]),
    render(next) {
      selection = next;
      slider.setAttribute('aria-valuenow', data.t[next.n].toFixed(3));
      slider.setAttribute('aria-valuetext', `${data.t[next.n].toFixed(2)} seconds, ${data.state(next.n) ?? ''}`);
      paint();
    },
  };
}
