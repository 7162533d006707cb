// The scene drawn with three.js. Draws only when told to; knows no run, only poses and overlays.
import {buildBodies, place} from './geometry.js';
import {axes, eyeOf, fit, flight, sides, viewFrom} from './framing.js';
import {Ghost} from './ghost.js';
import {isPose} from './motion.js';
import {Overlays} from './overlays.js';

const degree = Math.PI / 180;
const most_pixels_ratio = 2;
const room_above_m = 0.12; // the objects on the table
// As MuJoCo lights a scene: three divides diffuse light by π.
const ambient = 0.45 * Math.PI;
const headlight = 0.35 * Math.PI;
const lamp = 0.5 * Math.PI;

export class SceneView {
  /** `context`: the canvas's WebGL 2; `scene`: {geoms, bodies}; `colours`: numbers (see recolour). */
  constructor(THREE, canvas, context, scene, colours) {
    this.THREE = THREE;
    this.renderer = new THREE.WebGLRenderer({canvas, context, alpha: true});
    // Colours are shown as they are logged, and mixed as MuJoCo mixes them.
    THREE.ColorManagement.enabled = false;
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    this.draws = 0;
    this.world = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(30, 1, 0.01, 100);
    this.camera.up.set(0, 0, 1);
    this.lights = [
      new THREE.AmbientLight(0xffffff, ambient),
      new THREE.DirectionalLight(0xffffff, headlight),
      new THREE.DirectionalLight(0xffffff, lamp),
    ];
    this.lights[2].position.set(-0.3, -0.5, 1);
    this.world.add(...this.lights);
    this.floors = [];
    this.built = buildBodies(THREE, scene.geoms, (geom, rgba) => this.#material(geom, rgba));
    for (const body of this.built.bodies.values()) this.world.add(body);
    this.frame = new THREE.Box3Helper(new THREE.Box3(), 0xffffff);
    this.frame.visible = false;
    this.overlays = new Overlays(THREE);
    this.world.add(this.overlays.group, this.frame);
    this.ghost = null;
    this.recolour(colours);
    this.pose(new Map(Object.entries(scene.bodies ?? {}).filter(([, pose]) => isPose(pose))));
    this.view = fit(sides.front, this.corners(), 1.6);
  }

  #material(geom, [r, g, b, a]) {
    const material = new this.THREE.MeshLambertMaterial({
      color: new this.THREE.Color(r, g, b),
      transparent: a < 1,
      opacity: a,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      side: geom.type === 'plane' || geom.type === 'mesh' ? this.THREE.DoubleSide : this.THREE.FrontSide,
    });
    if (geom.type === 'plane') this.floors.push({material, own: [r, g, b]});
    return material;
  }

  /**
   * {background, human, avatar, act, ghost, cursor} as 0xrrggbb, and `dark`: then the floor takes the background's
   * colour, which it keeps at a distance, and all is lit a little less.
   */
  recolour(colours) {
    this.colours = colours;
    const dim = colours.dark ? 0.82 : 1;
    [ambient, headlight, lamp].forEach((strength, i) => {
      this.lights[i].intensity = strength * dim;
    });
    for (const {material, own} of this.floors)
      material.color.copy(
        colours.dark ? new this.THREE.Color(colours.background).multiplyScalar(1.5) : new this.THREE.Color(...own),
      );
    this.frame.material.color.set(colours.cursor);
    this.ghost?.recolour(colours.ghost);
  }

  resize(width, height, ratio) {
    this.renderer.setPixelRatio(Math.min(ratio, most_pixels_ratio));
    this.renderer.setSize(width, height, false);
    this.size = [width, height];
    this.camera.aspect = width / height;
  }

  /** Puts the bodies where the map says. */
  pose(poses) {
    this.poses = poses;
    for (const [name, body] of this.built.bodies) {
      const pose = poses.get(name);
      if (pose) place(body, pose.slice(0, 3), pose.slice(3));
    }
    this.world.updateMatrixWorld();
  }

  overlay(pointing, acts, heightAt) {
    this.overlays.show({pointing, acts, heightAt, colours: this.colours});
  }

  /** Shows the bodies of another scene as a ghost; null takes it away. */
  haunt(geoms) {
    if (this.ghost) {
      this.world.remove(this.ghost.group);
      this.ghost.dispose();
    }
    this.ghost = geoms ? new Ghost(this.THREE, geoms, this.colours.ghost) : null;
    if (this.ghost) this.world.add(this.ghost.group);
  }

  mark(body) {
    const box = body && this.box(body);
    this.frame.visible = Boolean(box);
    if (box) this.frame.box.copy(box.expandByScalar(0.006));
  }

  /** The upright box around a body as it stands, or null. */
  box(name) {
    const body = this.built.bodies.get(name);
    const box = body ? new this.THREE.Box3().setFromObject(body) : null;
    return box && !box.isEmpty() ? box : null;
  }

  /** Corners of all that has an extent. */
  corners(names = [...this.built.bodies.keys()]) {
    const corners = [];
    const point = new this.THREE.Vector3();
    for (const name of names)
      for (const mesh of this.built.bodies.get(name)?.children ?? []) {
        if (mesh.userData.plane) continue;
        mesh.geometry.computeBoundingBox();
        const {min, max} = mesh.geometry.boundingBox;
        for (const x of [min.x, max.x])
          for (const y of [min.y, max.y])
            for (const z of [min.z, max.z]) corners.push(point.set(x, y, z).applyMatrix4(mesh.matrixWorld).toArray());
      }
    return corners;
  }

  /** Views by name; `objects` are what there is to look at. */
  cameras(objects) {
    const all = this.corners();
    const aspect = this.camera.aspect;
    const there = this.corners(objects);
    // The avatar looks from just before its highest part.
    const top = all.reduce((best, corner) => Math.max(best, corner[2]), 0.3);
    const head = all.filter((corner) => corner[2] > top - 0.03);
    const eye = head.length
      ? [
          head.reduce((sum, corner) => sum + corner[0], 0) / head.length,
          Math.min(...head.map((corner) => corner[1])) - 0.03,
          top - 0.07,
        ]
      : [0, 0.4, top];
    const stood_on = there.length ? [...there, ...this.#table(there)] : all;
    const table = there.length ? [...stood_on, ...there.map(([x, y, z]) => [x, y, z + room_above_m])] : all;
    return {
      default: fit(sides.front, all, aspect),
      table: fit(sides.front, table, aspect),
      human: viewFrom([0, -0.95, 0.62], [0, 0.1, 0.15], 52 * degree),
      avatar: viewFrom(eye, [0, -0.1, 0], 75 * degree),
      above: fit(sides.above, stood_on, aspect),
    };
  }
  /** Corners of what the objects stand on: all that lies under them and is flat. */
  #table(points) {
    const low = Math.min(...points.map((point) => point[2]));
    return this.corners().filter((corner) => corner[2] <= low + 0.01 && Math.hypot(corner[0], corner[1]) < 1);
  }

  look(view) {
    this.view = view;
  }
  towards(from, to, part) {
    this.view = flight(from, to, part);
  }

  /** The name of the body at a place of the canvas, in its pixels, or null. */
  pick(x, y) {
    const hit = this.#through(x, y)
      .intersectObjects([...this.built.bodies.values()], true)
      .find(({object}) => !object.userData.plane);
    return hit ? hit.object.userData.body : null;
  }

  /** Where a place of the canvas, in its pixels, lies on one of these bodies or on the plane z = 0, whichever is nearer: [x, y, z] or null. */
  pointOn(x, y, names) {
    const {Plane, Vector3} = this.THREE;
    const ray = this.#through(x, y);
    const on_body = ray.intersectObjects(names.map((name) => this.built.bodies.get(name)).filter(Boolean), true)[0]
      ?.point;
    const on_plane = ray.ray.intersectPlane(new Plane(new Vector3(0, 0, 1), 0), new Vector3());
    const away = (point) => (point ? point.distanceTo(this.camera.position) : Infinity);
    const nearest = away(on_body) <= away(on_plane) ? on_body : on_plane;
    return nearest?.toArray() ?? null;
  }
  #through(x, y) {
    const {Vector2, Raycaster} = this.THREE;
    const [width, height] = this.size;
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2((2 * x) / width - 1, 1 - (2 * y) / height), this.camera);
    return ray;
  }

  /** Where a point of the world is on the canvas, in its pixels; null behind the camera. */
  project(point) {
    const p = new this.THREE.Vector3(...point).project(this.camera);
    return p.z < 1 ? [((p.x + 1) / 2) * this.size[0], ((1 - p.y) / 2) * this.size[1]] : null;
  }

  draw() {
    const eye = eyeOf(this.view);
    const {forward} = axes(this.view);
    this.camera.position.set(...eye);
    this.camera.lookAt(...eye.map((x, i) => x + forward[i]));
    this.camera.fov = this.view.fovy / degree;
    this.camera.near = Math.max(0.005, this.view.distance / 200);
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    this.lights[1].position.set(...forward.map((x) => -x));
    this.renderer.render(this.world, this.camera);
    ++this.draws;
  }

  close() {
    this.haunt(null);
    this.overlays.dispose();
    this.frame.dispose();
    this.built.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}
