// The shipped scenes and arms in the MuJoCo that npm has (@mujoco/mujoco), which is newer than the one that the program
// is built with: they load and step a thousand times, the arm's home is where ours is, and things rest where ours do.
// Environment: CONTINUA, the program; CONTINUA_NODE_MODULES, the folder of packages. Without the package: skipped (77).
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {pathToFileURL} from 'node:url';

const root = path.resolve(import.meta.dirname, '../..');
const steps = 1000;
const millimetre = 1e-3;
const packagePath = path.join(process.env.CONTINUA_NODE_MODULES ?? '', '@mujoco', 'mujoco', 'mujoco.js');
if (!fs.existsSync(packagePath)) {
  console.log('skipped: no @mujoco/mujoco');
  process.exit(77);
}
const mujoco = await (await import(pathToFileURL(packagePath))).default();
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'continua-'));
process.on('exit', () => fs.rmSync(folder, {recursive: true, force: true}));

/// All scenes, and the first of them with each of the tests' arms.
function scenes() {
  const shipped = path.join(root, 'mjcf/scenes');
  const names = fs.readdirSync(shipped).filter((name) => name.endsWith('.xml'));
  const found = names.map((name) => path.join(shipped, name));
  const text = fs
    .readFileSync(path.join(shipped, 'staircase.xml'), 'utf8')
    .replaceAll('../objects', `${root}/mjcf/objects`);
  const arms = path.join(root, 'tests/simulation/arms');
  const told = JSON.parse(fs.readFileSync(path.join(arms, 'told.json'), 'utf8'));
  for (const name of fs.readdirSync(arms).filter((file) => file.endsWith('.xml'))) {
    const scene = path.join(folder, name);
    const words = told[path.parse(name).name];
    const more = words ? `<text name="avatar" data="${words}"/></custom>` : '</custom>';
    fs.writeFileSync(scene, text.replace('../avatar/arm7.xml', path.join(arms, name)).replace('</custom>', more));
    found.push(scene);
  }
  return found;
}

/// Two seconds of our world in which nobody does anything: the scene's text, the bodies' places at the start and the end.
function quiet(scene) {
  const trace = path.join(folder, 'quiet.trace.jsonl'),
    run = path.join(folder, 'quiet.run.jsonl');
  fs.writeFileSync(
    trace,
    `{"kind":"trace","version":1,"scene":${JSON.stringify(scene)},"machine":"palindromes"}\n{"t":2,"kind":"end"}\n`,
  );
  execFileSync(process.env.CONTINUA, ['replay', trace, '-o', run]);
  const records = fs
    .readFileSync(run, 'utf8')
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line));
  const {mjcf, bodies} = records[0].scene;
  const end = Object.assign(
    {},
    bodies,
    ...records.filter((record) => record.kind === 'pose').map((record) => record.bodies),
  );
  return {mjcf, start: bodies, end};
}

const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

function check(scene) {
  const {mjcf, start, end} = quiet(scene);
  const model = mujoco.MjModel.from_xml_string(mjcf);
  const data = new mujoco.MjData(model);
  const home = mjcf
    .match(/name="arm_home"\s+data="([^"]*)"/)[1]
    .trim()
    .split(/\s+/)
    .map(Number);
  const {mjJNT_HINGE, mjJNT_FREE} = mujoco.mjtJoint;
  let hinge = 0;
  for (let joint = 0; joint < model.njnt && hinge < home.length; ++joint)
    if (model.jnt_type[joint] === mjJNT_HINGE.value) data.qpos[model.jnt_qposadr[joint]] = home[hinge++];
  mujoco.mj_forward(model, data);
  for (let motor = 0; motor < model.nu; ++motor) data.ctrl[motor] = data.actuator_length[motor];

  const faults = [];
  const compare = (places, bodies, when) => {
    for (const body of bodies) {
      const name = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_BODY.value, body);
      const apart = distance(places[name], data.xpos.slice(3 * body, 3 * body + 3));
      if (!(apart < millimetre)) faults.push(`${name} is ${(1000 * apart).toFixed(2)} mm elsewhere ${when}`);
    }
  };
  const movable = [];
  for (let body = 0; body < model.nbody; ++body) {
    const joint = model.body_jntadr[body];
    if (joint >= 0 && model.jnt_type[joint] === mjJNT_FREE.value) movable.push(body);
  }
  compare(start, [...Array(model.nbody).keys()], 'at the start');
  for (let step = 0; step < steps; ++step) mujoco.mj_step(model, data);
  compare(end, movable, `after ${steps} steps`);
  console.log(
    `${path.basename(scene)}: ${model.nbody} bodies, ${movable.length} things${faults.length ? '' : ', as ours'}`,
  );
  for (const fault of faults) console.error(`${scene}: ${fault}`);
  data.delete();
  model.delete();
  return faults.length === 0;
}

console.log(`MuJoCo ${mujoco.mj_versionString()}`);
process.exit(scenes().map(check).every(Boolean) ? 0 : 1);
