// Where a camera has to stand to see given points, and how it gets from one place to another. Pure. Metres and radians,
// frame W: x to the human's right, y away from the human, z up. A view is {target, azimuth, elevation, distance, fovy}:
// the camera looks at `target` along azimuth (π/2: along y) and elevation (below 0: downward).

const degree = Math.PI / 180;
const usual_fovy = 30 * degree;
const margin = 0.94; // of half the picture

export const sides = {
  front: {azimuth: 90 * degree, elevation: -34 * degree},
  above: {azimuth: 90 * degree, elevation: -89 * degree},
};

/** Unit vectors of a view: where it looks, and what is right and up in the picture. */
export function axes({azimuth, elevation}) {
  const forward = [
    Math.cos(elevation) * Math.cos(azimuth),
    Math.cos(elevation) * Math.sin(azimuth),
    Math.sin(elevation),
  ];
  const right = [Math.sin(azimuth), -Math.cos(azimuth), 0];
  return {forward, right, up: cross(right, forward)};
}
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

export function eyeOf(view) {
  const {forward} = axes(view);
  return view.target.map((x, i) => x - view.distance * forward[i]);
}

/** The view from `eye` to `target`. */
export function viewFrom(eye, target, fovy = usual_fovy) {
  const d = target.map((x, i) => x - eye[i]);
  const distance = Math.max(Math.hypot(...d), 0.05);
  return {
    target,
    distance,
    fovy,
    azimuth: Math.atan2(d[1], d[0]),
    elevation: Math.asin(Math.max(-1, Math.min(1, d[2] / distance))),
  };
}

/** The view in this direction in which all points are just in the picture. */
export function fit({azimuth, elevation}, points, aspect) {
  if (!points.length)
    points = [
      [-0.5, -0.5, 0],
      [0.5, 0.5, 0.5],
    ];
  const {forward, right, up} = axes({azimuth, elevation});
  const fovy = usual_fovy;
  const half_height = Math.tan(fovy / 2);
  const half_width = half_height * Math.max(aspect, 0.05);
  const target = [0, 1, 2].map((i) => points.reduce((sum, point) => sum + point[i], 0) / points.length);
  let distance = 1;
  // The nearer points decide the distance, and the distance where the middle seems to be: a few rounds settle both.
  for (let round = 0; round < 12; ++round) {
    let low = Infinity;
    let high = -Infinity;
    let left = Infinity;
    let farthest_right = -Infinity;
    for (const point of points) {
      const d = point.map((x, i) => x - target[i]);
      const depth = Math.max(distance + dot(d, forward), 0.1);
      low = Math.min(low, dot(d, up) / depth);
      high = Math.max(high, dot(d, up) / depth);
      left = Math.min(left, dot(d, right) / depth);
      farthest_right = Math.max(farthest_right, dot(d, right) / depth);
    }
    const scale = Math.max(
      (high - low) / (2 * margin * half_height),
      (farthest_right - left) / (2 * margin * half_width),
    );
    for (let i = 0; i < 3; ++i)
      target[i] += distance * ((up[i] * (high + low)) / 2 + (right[i] * (left + farthest_right)) / 2);
    distance = Math.max(0.1, distance * Math.max(0.5, Math.min(2, scale)));
  }
  return {target, azimuth, elevation, distance, fovy};
}

/** A part (0 … 1) of the way from one view to another, turning the shorter way. */
export function flight(a, b, part) {
  const eased = part * part * (3 - 2 * part);
  const mix = (x, y) => x + eased * (y - x);
  const turn = Math.atan2(Math.sin(b.azimuth - a.azimuth), Math.cos(b.azimuth - a.azimuth));
  return {
    target: a.target.map((x, i) => mix(x, b.target[i])),
    azimuth: a.azimuth + eased * turn,
    elevation: mix(a.elevation, b.elevation),
    distance: mix(a.distance, b.distance),
    fovy: mix(a.fovy, b.fovy),
  };
}
