// The human's own picture as a mirror shows it, small, with the hand that was found in it and the part of it that is the
// table. The picture goes nowhere else.
import {h, s} from '../dom.js';

const slow_ms = 700; // a gesture takes two pictures, and counts for at most 2 s
const seen_text = 'Seen. The frame is the table.';
// The numbers of a hand's points that are joined, as MediaPipe counts them: palm, thumb, fingers.
const lines = [
  [0, 5, 9, 13, 17, 0],
  [0, 1, 2, 3, 4],
  [5, 6, 7, 8],
  [9, 10, 11, 12],
  [13, 14, 15, 16],
  [17, 18, 19, 20],
];
const pathOf = (points) =>
  lines.map((line) => `M${line.map((i) => `${points[i].x} ${points[i].y}`).join('L')}`).join('');

/** `table`: {left, right, top, bottom}, the part of the picture that is the table, from 0 to 1. */
export function mountHandView(table) {
  const video = h('video', {muted: true, playsinline: true, 'aria-hidden': 'true', tabindex: -1});
  video.muted = true;
  const bones = s('path', {class: 'bones'});
  const {left, right, top, bottom} = table;
  const drawing = s(
    'svg',
    {viewBox: '0 0 1 1', preserveAspectRatio: 'none', 'aria-hidden': 'true'},
    s('rect', {class: 'table-part', x: left, y: top, width: right - left, height: bottom - top}),
    bones,
  );
  const caption = h('figcaption', {'data-testid': 'hand-state'});
  return {
    video,
    element: h('figure', {class: 'hand-view', 'data-testid': 'hand-view'}, video, drawing, caption),
    /** Of a HandLandmarker's result, and how long it took; null: nothing has been looked at yet. */
    show(found, took_ms = 0) {
      const points = found?.landmarks[0];
      bones.setAttribute('d', points ? pathOf(points) : '');
      const seen = took_ms > slow_ms ? `Seen slowly, ${(took_ms / 1000).toFixed(1)} s a picture.` : seen_text;
      if (!found) caption.textContent = 'Getting ready to see…';
      else caption.textContent = points ? seen : 'No hand is seen.';
    },
  };
}
