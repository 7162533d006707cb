// Marks drawn into the scene: where somebody points, and where the avatar means to take things.
// The human's ray is whole, the avatar's in dashes, an act's arrow bends: they differ without their colours.

const ray_m = 0.003;
const disc_m = 0.022;
const ring_m = 0.04;
const arrow_m = 0.05;
const farthest_m = 1.6; // rays end here; a target beyond has no disc
const dash_m = 0.035;
const most_dashes = 40;

/** A plausible place of the human's hand, where the log does not tell it. */
export const humanHand = (hand) => [hand === 'left' ? -0.24 : 0.24, -0.6, 0.3];

/** A point given in the frame of a body's pose, in the world. */
export function along([x, y, z, w, i, j, k], [a, b, c]) {
  const tx = 2 * (j * c - k * b);
  const ty = 2 * (k * a - i * c);
  const tz = 2 * (i * b - j * a);
  return [x + a + w * tx + j * tz - k * ty, y + b + w * ty + k * tx - i * tz, z + c + w * tz + i * ty - j * tx];
}

/** heightAt(x, y): the height of the highest of these bodies over a place, at least `floor`, in metres. */
export function heightOver(view, names, floor = -Infinity) {
  const boxes = names.map((name) => view.box(name)).filter(Boolean);
  const over = (x, y, {min, max}) => x > min.x && x < max.x && y > min.y && y < max.y;
  return (x, y) => boxes.reduce((top, box) => (over(x, y, box) ? Math.max(top, box.max.z) : top), floor);
}

export class Overlays {
  constructor(THREE) {
    this.THREE = THREE;
    this.group = new THREE.Group();
    this.shapes = {
      rod: new THREE.CylinderGeometry(1, 1, 1, 10).rotateX(Math.PI / 2),
      disc: new THREE.CylinderGeometry(1, 1, 1, 32).rotateX(Math.PI / 2),
      ring: new THREE.TorusGeometry(1, 0.1, 8, 40),
      cone: new THREE.ConeGeometry(1, 1, 16).rotateX(Math.PI / 2),
      ball: new THREE.SphereGeometry(1, 10, 8),
    };
    this.materials = new Map();
  }

  /**
   * `pointing`: [{who, target, from, trail}], `from` a point or null; `acts`: [{target, from}], where the object is, or
   * null; `heightAt(x, y)`: of what stands there. Colours are {human, avatar, act}, as numbers.
   */
  show({pointing, acts, heightAt, colours}) {
    this.group.clear();
    for (const one of pointing) this.#pointing(one, colours[one.who === 'avatar' ? 'avatar' : 'human'], heightAt);
    for (const one of acts) if (one.target) this.#act(one, colours.act);
  }

  #pointing({who, target, from, trail}, colour, heightAt) {
    const [x, y, z] = target;
    const far = Math.hypot(x, y, z) > farthest_m;
    const to = far ? target : [x, y, Math.max(z, heightAt(x, y))];
    if (from) {
      const whole = this.#length(from, to);
      const length = Math.min(whole, farthest_m);
      const end = from.map((a, i) => a + ((to[i] - a) * length) / Math.max(whole, 1e-9));
      this.#ray(from, end, colour, who === 'avatar');
      if (far) this.#tip(from, end, colour);
    }
    if (far) return;
    this.#disc(to, disc_m, 0.003, colour);
    this.#disc(to, disc_m * 0.62, 0.004, 0xffffff);
    this.#disc(to, disc_m * 0.3, 0.005, colour);
    const shown = trail.slice(-16, -1);
    shown.forEach(([a, b, c], i) =>
      this.#add('ball', colour, [a, b, Math.max(c, heightAt(a, b)) + 0.003], 0.003 + (0.004 * i) / shown.length),
    );
  }

  #act({target, from}, colour) {
    const ring = this.#add('ring', colour, [target[0], target[1], target[2] + 0.003], ring_m);
    ring.scale.z = ring_m / 2;
    if (!from || this.#length(from, target) < 0.02) return;
    const lift = 0.08 + 0.25 * this.#length(from, target);
    const parts = 14;
    const at = (s) => from.map((a, i) => a + s * (target[i] - a) + (i === 2 ? 4 * lift * s * (1 - s) : 0));
    for (let i = 0; i + 1 < parts; ++i) this.#rod(at(i / parts), at((i + 1) / parts), colour, ray_m * 1.3);
    this.#tip(at((parts - 2) / parts), target, colour);
  }

  #ray(from, to, colour, dashed) {
    const length = this.#length(from, to);
    const dashes = dashed ? Math.min(most_dashes, Math.max(1, Math.ceil(length / dash_m))) : 1;
    for (let i = 0; i < dashes; ++i) {
      const part = (s) => from.map((a, k) => a + s * (to[k] - a));
      this.#rod(part(i / dashes), part((i + (dashed ? 0.6 : 1)) / dashes), colour, ray_m);
    }
  }
  #rod(from, to, colour, radius) {
    const length = this.#length(from, to);
    if (length < 1e-6) return;
    const rod = this.#add(
      'rod',
      colour,
      from.map((a, i) => (a + to[i]) / 2),
      radius,
    );
    rod.scale.z = length;
    rod.lookAt(...to);
  }
  #tip(from, to, colour) {
    const length = Math.max(this.#length(from, to), 1e-6);
    const cone = this.#add(
      'cone',
      colour,
      to.map((b, i) => b - (((b - from[i]) / length) * arrow_m) / 2),
      0.014,
    );
    cone.scale.z = arrow_m;
    cone.lookAt(...to);
  }
  #disc([x, y, z], radius, height, colour) {
    this.#add('disc', colour, [x, y, z + height / 2], radius).scale.z = height;
  }
  #add(shape, colour, at, scale) {
    if (!this.materials.has(colour)) this.materials.set(colour, new this.THREE.MeshBasicMaterial({color: colour}));
    const mesh = new this.THREE.Mesh(this.shapes[shape], this.materials.get(colour));
    mesh.position.set(...at);
    mesh.scale.setScalar(scale);
    this.group.add(mesh);
    return mesh;
  }
  #length(a, b) {
    return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }

  dispose() {
    this.group.clear();
    for (const one of Object.values(this.shapes)) one.dispose();
    for (const one of this.materials.values()) one.dispose();
  }
}
