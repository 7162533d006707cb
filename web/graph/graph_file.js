// The state graph as a file of its own: the picture of the page with its colours, whole labels and a legend.
import {s} from '../dom.js';
import {rowText} from './graph_draw.js';

const copied = [
  'fill',
  'stroke',
  'stroke-width',
  'stroke-dasharray',
  'opacity',
  'font-size',
  'font-weight',
  'paint-order',
];
const line_px = 15;
const letters_px = 6; // of the legend, the width of a letter at most

/** `view`: the group as it is shown; `placed` as layOut() gives it. @returns the text of an SVG file */
export function graphFile(view, {edges, width, height}) {
  const lines = edges
    .toSorted((a, b) => b.visits - a.visits)
    .map(({from, to, rows}) => `${from} → ${to}   ${rows.map(rowText).join(';  ')}`);
  const drawn = styled(view);
  const widest = Math.max(width, ...lines.map((line) => line.length * letters_px + 28));
  const size = {width: Math.ceil(widest), height: Math.ceil(height + (lines.length + 1) * line_px)};
  const legend = lines.map((line, i) => s('text', {x: 14, y: height + (i + 1) * line_px}, line));
  const paper = getComputedStyle(view.closest('.panel')).backgroundColor;
  const text = getComputedStyle(view.closest('.panel')).color;
  const file = s(
    'svg',
    {xmlns: 'http://www.w3.org/2000/svg', viewBox: `0 0 ${size.width} ${size.height}`, ...size},
    s('rect', {...size, fill: paper}),
    drawn,
    s('g', {'font-size': 11, fill: text}, legend),
  );
  file.setAttribute('font-family', 'system-ui, sans-serif');
  return new XMLSerializer().serializeToString(file);
}

// A copy that looks the same without the page's style.
function styled(view) {
  const copy = view.cloneNode(true);
  const hits = [...copy.querySelectorAll('.hit, .token')];
  copy.removeAttribute('style');
  const originals = view.querySelectorAll('*');
  copy.querySelectorAll('*').forEach((one, i) => {
    const style = getComputedStyle(originals[i]);
    for (const name of copied) one.setAttribute(name, style.getPropertyValue(name));
    for (const name of ['class', 'style', 'tabindex', 'role', 'aria-label', 'data-state', 'data-edge'])
      one.removeAttribute(name);
  });
  for (const unseen of hits) unseen.remove();
  return copy;
}
