// The ways of the state graph's arrows as SVG paths. Pure: points in, text or points out.

const head_px = 6;

/** Through these points, bending. */
export const path = (points) => {
  if (points.length < 3) return `M${points.map(({x, y}) => `${x} ${y}`).join('L')}`;
  // Through the middles of the inner stretches, bending at the points between.
  let d = `M${points[0].x} ${points[0].y}`;
  for (let i = 1; i < points.length - 1; ++i) {
    const last = i === points.length - 2;
    const end = last ? points[i + 1] : {x: (points[i].x + points[i + 1].x) / 2, y: (points[i].y + points[i + 1].y) / 2};
    d += `Q${points[i].x} ${points[i].y} ${end.x} ${end.y}`;
  }
  return d;
};

/** From a node to itself, over four points. */
export const loopPath = ([a, b, c, d]) => `M${a.x} ${a.y}C${b.x} ${b.y} ${c.x} ${c.y} ${d.x} ${d.y}`;

const curve_parts = 8; // of each bend

/** Points of the curve that path(), or loopPath() of a `loop`, draws. */
export function curve(points, loop) {
  if (loop) return sampled(points);
  if (points.length < 3) return points;
  const all = [points[0]];
  for (let i = 1; i < points.length - 1; ++i) {
    const next = points[i + 1];
    const last = i === points.length - 2;
    const end = last ? next : {x: (points[i].x + next.x) / 2, y: (points[i].y + next.y) / 2};
    all.push(...sampled([all.at(-1), points[i], end]).slice(1));
  }
  return all;
}
// Points of the Bézier curve with these control points.
const sampled = (controls) => Array.from({length: curve_parts + 1}, (_, k) => between(controls, k / curve_parts));
function between(points, share) {
  if (points.length === 1) return points[0];
  const mixed = points.slice(1).map(({x, y}, i) => ({
    x: points[i].x + (x - points[i].x) * share,
    y: points[i].y + (y - points[i].y) * share,
  }));
  return between(mixed, share);
}

/** The place at this part of the way along. Less than half, so that the counts of an edge and its reverse keep apart. */
export function along(points, part) {
  const lengths = points.slice(1).map((point, i) => Math.hypot(point.x - points[i].x, point.y - points[i].y));
  let left = lengths.reduce((sum, length) => sum + length, 0) * part;
  for (let i = 0; i < lengths.length; left -= lengths[i++]) {
    if (left > lengths[i]) continue;
    const share = lengths[i] ? left / lengths[i] : 0;
    return {
      x: points[i].x + (points[i + 1].x - points[i].x) * share,
      y: points[i].y + (points[i + 1].y - points[i].y) * share,
    };
  }
  return points.at(-1);
}

/** The head of an arrow that ends at the last of the points. */
export function arrowHead(points) {
  const end = points.at(-1);
  const before = points.at(-2);
  const angle = Math.atan2(end.y - before.y, end.x - before.x);
  const at = (turn) => `${end.x - head_px * Math.cos(angle + turn)} ${end.y - head_px * Math.sin(angle + turn)}`;
  return `M${end.x} ${end.y}L${at(0.42)}L${at(-0.42)}Z`;
}

/** From the rim of one node to that of another, beside the straight way by this share of it. */
export function bent(a, b, share) {
  const bend = {x: (a.x + b.x) / 2 + (b.y - a.y) * share, y: (a.y + b.y) / 2 - (b.x - a.x) * share};
  const rim = (node) => {
    const dx = bend.x - node.x;
    const dy = bend.y - node.y;
    const k = Math.min(node.w / 2 / Math.max(1e-6, Math.abs(dx)), node.h / 2 / Math.max(1e-6, Math.abs(dy)));
    return {x: node.x + dx * Math.min(1, k), y: node.y + dy * Math.min(1, k)};
  };
  return [rim(a), bend, rim(b)];
}
