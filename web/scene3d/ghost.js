// The bodies of another run, half transparent in one hue and outlined, where they are elsewhere than in this one.
import {buildBodies, place} from './geometry.js';

const least_m = 0.001;
const least_turn = 0.01; // radians

/** Whether two poses differ so much that it is worth showing. */
export function apart(a, b) {
  if (!a || !b) return Boolean(a || b);
  if (Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) > least_m) return true;
  // Logged quaternions are rounded: not quite of length one.
  const cosine =
    Math.abs(a[3] * b[3] + a[4] * b[4] + a[5] * b[5] + a[6] * b[6]) /
    (Math.hypot(...a.slice(3)) * Math.hypot(...b.slice(3)));
  return 2 * Math.acos(Math.min(1, cosine)) > least_turn;
}

export class Ghost {
  constructor(THREE, geoms, colour) {
    this.group = new THREE.Group();
    const fill = new THREE.MeshBasicMaterial({color: colour, transparent: true, opacity: 0.22, depthWrite: false});
    this.line = new THREE.LineBasicMaterial({color: colour});
    this.fill = fill;
    const solid = (Array.isArray(geoms) ? geoms : []).filter((geom) => geom?.type !== 'plane');
    this.built = buildBodies(THREE, solid, () => fill);
    for (const body of this.built.bodies.values()) {
      for (const mesh of [...body.children])
        body.add(new THREE.LineSegments(new THREE.EdgesGeometry(mesh.geometry, 35), this.line));
      body.visible = false;
      this.group.add(body);
    }
  }

  /** `mine` and `theirs`: maps of body to pose. Gives the names of those that are shown. */
  show(mine, theirs) {
    const shown = [];
    for (const [name, body] of this.built.bodies) {
      const pose = theirs.get(name);
      body.visible = Boolean(pose) && apart(mine.get(name), pose);
      if (!body.visible) continue;
      place(body, pose.slice(0, 3), pose.slice(3));
      shown.push(name);
    }
    return shown;
  }

  recolour(colour) {
    this.fill.color.set(colour);
    this.line.color.set(colour);
  }

  dispose() {
    this.built.dispose();
    this.line.dispose();
    this.fill.dispose();
  }
}
