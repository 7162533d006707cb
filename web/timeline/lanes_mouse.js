// The mouse on the timeline: the wheel zooms and moves; a drag moves, with Shift it selects a stretch, along the top it scrubs, along the overview
// it moves the window; a click goes to an item or an instant; the item under the pointer is told.
import {axis_px, gutter_px} from './lanes_draw.js';

const drag_px = 3; // moved less, a press is a click
const wheel_rate = 0.002; // of the logarithm of the zoom, for each unit that the wheel turns

/**
 * `picture`: a LanesPicture, `shown`: a TimeWindow, `stretch`: a Stretch. `seek(t, how)`: goes to an instant, in seconds; `open(item)`: goes to
 * an item; `tell(item, place)`: the item under the pointer, or null, and where that is; null: nowhere.
 */
export function listenToMouse(element, needs) {
  const {picture, shown, tell} = needs;
  const place = (event) => {
    const box = element.getBoundingClientRect();
    return {x: event.clientX - box.left, y: event.clientY - box.top};
  };
  const onWheel = (event) => {
    event.preventDefault();
    if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY))
      shown.panBy((event.deltaX || event.deltaY) / picture.width);
    else shown.zoomBy(Math.exp(event.deltaY * wheel_rate), picture.sight.t(place(event).x));
  };
  const onPress = (event) => {
    if (event.button !== 0) return;
    const {x, y} = place(event);
    const above = event.shiftKey && x >= gutter_px ? select : y < axis_px ? scrub : pan;
    const kind = y >= picture.lanes_px ? alongOverview : above;
    const drag = kind(needs, x);
    let moved = false;
    const move = (next) => {
      const at = place(next);
      if (Math.abs(at.x - x) > drag_px) moved = true;
      if (moved) drag.move(at.x);
    };
    const done = (last) => {
      removeEventListener('pointermove', move);
      if (moved) drag.done?.();
      else drag.click?.(place(last));
    };
    addEventListener('pointermove', move);
    addEventListener('pointerup', done, {once: true});
  };
  element.addEventListener('wheel', onWheel, {passive: false});
  element.addEventListener('pointerdown', onPress);
  element.addEventListener('pointermove', (event) => {
    const at = place(event);
    tell(event.buttons ? null : picture.itemAt(at), event.buttons ? null : at);
  });
  element.addEventListener('pointerleave', () => tell(null));
}

// The kinds of drag, each begun at `x`: {move(x), done(), click({x, y})}, where click is for a press that did not move.

function select({picture, stretch}, x) {
  const from = picture.sight.t(x);
  return {
    move: (to) => stretch.draw([from, picture.sight.t(Math.max(gutter_px, to))], (t) => picture.sight.x(t)),
    done: () => stretch.done(),
  };
}

function scrub({picture, seek}, x) {
  seek(picture.sight.t(x), 'jump');
  return {move: (to) => seek(picture.sight.t(to), 'slide')};
}

// Centres the window, of the width that it had, where the mouse is.
function alongOverview({picture, shown, seek}, x) {
  const [from, to] = shown.places;
  const half = (to - from) / 2;
  const move = (at) => {
    const middle = shown.axis.of(picture.overview.t(at));
    shown.showPlaces([middle - half, middle + half]);
  };
  move(x);
  return {move, click: (at) => seek(picture.overview.t(at.x), 'jump')};
}

function pan({picture, shown, seek, open}, x) {
  const [from, to] = shown.places;
  const move = (at) => {
    const by = ((x - at) / (picture.width - gutter_px)) * (to - from);
    shown.showPlaces([from + by, to + by]);
  };
  const click = (at) => {
    const item = picture.itemAt(at);
    if (item) open(item);
    else if (at.x >= gutter_px) seek(picture.sight.t(at.x), 'jump');
  };
  return {move, click};
}
