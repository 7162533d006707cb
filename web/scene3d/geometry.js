// MuJoCo's geoms as three's meshes. Half sizes, metres; MuJoCo's capsules and cylinders lie along z, three's along y.

const detail = 28; // sides of a round body
const endless_m = 20; // of a plane without end
const most_vertices = 2e5; // of a mesh

const numbers = (value, count, otherwise) =>
  Array.isArray(value) && value.length >= count && value.slice(0, count).every(Number.isFinite) ? value : otherwise;

const shapes = {
  plane: (THREE, [x, y]) => new THREE.PlaneGeometry(2 * (x || endless_m), 2 * (y || endless_m)),
  sphere: (THREE, [r]) => new THREE.SphereGeometry(r, detail, detail / 2),
  ellipsoid: (THREE, [x, y, z]) => new THREE.SphereGeometry(1, detail, detail / 2).scale(x, y, z),
  capsule: (THREE, [r, half]) => new THREE.CapsuleGeometry(r, 2 * half, 8, detail).rotateX(Math.PI / 2),
  cylinder: (THREE, [r, half]) => new THREE.CylinderGeometry(r, r, 2 * half, detail).rotateX(Math.PI / 2),
  box: (THREE, [x, y, z]) => new THREE.BoxGeometry(2 * x, 2 * y, 2 * z),
};
const needed = {plane: 2, sphere: 1, ellipsoid: 3, capsule: 2, cylinder: 2, box: 3};

function meshShape(THREE, mesh) {
  const {vertices, faces} = mesh ?? {};
  if (
    !Array.isArray(vertices) ||
    !Array.isArray(faces) ||
    vertices.length > 3 * most_vertices ||
    !vertices.every(Number.isFinite)
  )
    return null;
  const count = Math.floor(vertices.length / 3);
  const index = [];
  for (let i = 0; i + 2 < faces.length; i += 3) {
    const face = faces.slice(i, i + 3);
    if (face.every((corner) => Number.isInteger(corner) && corner >= 0 && corner < count)) index.push(...face);
  }
  if (!index.length) return null;
  const shared = new THREE.BufferGeometry();
  shared.setAttribute('position', new THREE.Float32BufferAttribute(vertices.slice(0, 3 * count), 3));
  shared.setIndex(index);
  const flat = shared.toNonIndexed();
  shared.dispose();
  flat.computeVertexNormals();
  return flat;
}

/** The shape of a geom in its own frame, or null where there is nothing to draw: unknown types, sizes that are none. */
export function shapeOf(THREE, geom) {
  if (geom?.type === 'mesh') return meshShape(THREE, geom.mesh);
  if (!Object.hasOwn(shapes, geom?.type)) return null;
  const size = numbers(geom.size, needed[geom.type], null);
  const positive =
    size && size.slice(0, needed[geom.type]).every((x) => (geom.type === 'plane' ? x >= 0 : x > 0) && x < 1e4);
  return positive ? shapes[geom.type](THREE, size) : null;
}

export const rgbaOf = (geom) => numbers(geom?.rgba, 4, [0.5, 0.5, 0.5, 1]).map((x) => Math.max(0, Math.min(1, x)));

/** Puts an object where MuJoCo's position and quaternion [w, x, y, z] say. */
export function place(object, pos, quat) {
  const p = numbers(pos, 3, [0, 0, 0]);
  const q = numbers(quat, 4, [1, 0, 0, 0]);
  object.position.set(p[0], p[1], p[2]);
  object.quaternion.set(q[1], q[2], q[3], q[0]).normalize();
}

/** One shape out of several, each put where its mesh has it. */
function joined(THREE, meshes) {
  const parts = meshes.map((mesh) => {
    mesh.updateMatrix();
    const part = mesh.geometry.index ? mesh.geometry.toNonIndexed() : mesh.geometry.clone();
    return part.applyMatrix4(mesh.matrix);
  });
  const whole = new THREE.BufferGeometry();
  for (const name of ['position', 'normal']) {
    const arrays = parts.map((part) => part.getAttribute(name).array);
    const all = new Float32Array(arrays.reduce((sum, array) => sum + array.length, 0));
    let at = 0;
    for (const array of arrays) {
      all.set(array, at);
      at += array.length;
    }
    whole.setAttribute(name, new THREE.BufferAttribute(all, 3));
  }
  for (const part of parts) part.dispose();
  return whole;
}

/**
 * A group for each body, in it one mesh for all its geoms that look alike: what costs time is how many are drawn.
 * `materialOf(geom, rgba)` makes the material of a look. Gives {bodies: Map of name to Group, dispose}.
 */
export function buildBodies(THREE, geoms, materialOf) {
  const looks = new Map();
  const materials = new Map();
  for (const geom of Array.isArray(geoms) ? geoms : []) {
    const rgba = rgbaOf(geom);
    if (typeof geom?.body !== 'string' || rgba[3] === 0) continue;
    const shape = shapeOf(THREE, geom);
    if (!shape) continue;
    const plane = geom.type === 'plane';
    const look = `${plane} ${geom.type === 'mesh'} ${rgba}`;
    const key = JSON.stringify([geom.body, look]);
    if (!materials.has(look)) materials.set(look, materialOf(geom, rgba));
    const mesh = new THREE.Mesh(shape);
    place(mesh, geom.pos, geom.quat);
    if (!looks.has(key)) looks.set(key, {body: geom.body, plane, material: materials.get(look), meshes: []});
    looks.get(key).meshes.push(mesh);
  }
  const bodies = new Map();
  for (const {body, plane, material, meshes} of looks.values()) {
    const mesh = new THREE.Mesh(joined(THREE, meshes), material);
    mesh.userData = {body, plane};
    for (const one of meshes) one.geometry.dispose();
    if (!bodies.has(body)) bodies.set(body, new THREE.Group());
    bodies.get(body).add(mesh);
  }
  const dispose = () => {
    for (const body of bodies.values()) for (const mesh of body.children) mesh.geometry.dispose();
    for (const one of materials.values()) one.dispose();
  };
  return {bodies, dispose};
}
