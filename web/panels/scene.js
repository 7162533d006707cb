// The scene at the cursor: bodies where the log has them, who points where, where the avatar means to take things.
import {h, panel} from '../dom.js';
import {pictureOf, served} from '../run/run_client.js';
import {three} from '../vendor.js';
import {Motion} from '../scene3d/motion.js';
import {humanHand} from '../scene3d/overlays.js';
import {placeText, readMjcf, sceneSentence} from '../scene3d/scene_text.js';
import {Stage} from '../scene3d/stage.js';

const words_every_ms = 250;
const camera_names = {default: 'All', human: 'Human', avatar: 'Avatar', above: 'Above'};
const camera_titles = {default: 'the whole scene, or in a low picture the table, from the human’s side', human: 'as the human sees it', avatar: 'as the avatar sees it', above: 'from above'};

/**
 * `other`: another run to be drawn as a ghost: {client, timeOf(n)}, where timeOf gives the instant of the other run that
 * belongs to record n of this one, or null where there is none. May be changed later: panel.ghost(other).
 */
export function mountScene(app, {other = null} = {}) {
  const {client} = app;
  let t = 0, n = 0, scene = null, bodies = {objects: [], grip: null}, world = null, drawn = '', selected = null, camera = 'default', words_timer = 0, closed = false;
  let haunting = null;  // {other, geoms, motion, last: its poses that were known last}
  const show = {labels: false, follow: false};

  const caption = h('p', {class: 'caption', 'data-testid': 'scene-caption'});
  const places = h('ul', {class: 'places', 'data-testid': 'scene-places'});
  const list = h('details', {ontoggle: () => say()}, h('summary', {}, 'What is where'), places);
  const stage = new Stage({three, address: served ? (at, width, height) => pictureOf(client.id, Math.max(0, Math.min(at, app.data.duration)).toFixed(3), `${width}x${height}`) : null,
    before, after: tag, resized: () => { if (camera) stage.view = stage.drawing.cameras(bodies.objects)[camera]; }, changed: () => press(null), click: select});
  const motion = new Motion({fetch: (from, to) => client.poses(from, to), duration: () => app.data.duration, arrived: () => stage.wake()});

  const cameras = Object.entries(camera_names).map(([name, text]) => h('button', {type: 'button', 'aria-pressed': String(name === 'default'),
    title: camera_titles[name], 'data-camera': name, onclick: () => look(name)}, text));
  const toggles = [['labels', 'Labels', 'names of the objects'], ['follow', 'Follow', 'keep looking at what is acted on or pointed at']].map(([name, text, title]) =>
    h('button', {type: 'button', 'aria-pressed': 'false', title, 'data-toggle': name, onclick: (event) => {
      show[name] = !show[name];
      event.currentTarget.setAttribute('aria-pressed', String(show[name]));
      if (!show.follow) stage.follow(null);
      drawn = '';
      stage.touch();
    }}, text));
  const body = h('div', {class: 'scene-body'}, stage.element, caption, list);
  const element = panel('scene', 'Scene', [h('span', {class: 'cameras', role: 'group', 'aria-label': 'Camera'}, cameras), toggles], body);

  const press = (name) => { camera = name; for (const button of cameras) button.setAttribute('aria-pressed', String(button.dataset.camera === name)); };
  function look(name) {
    if (!stage.drawing) return;
    press(name);
    stage.fly(stage.drawing.cameras(bodies.objects)[name]);
  }
  function select(name) {
    selected = name === selected ? null : name;
    drawn = '';
    stage.touch();
    say();
  }

  async function open() {
    try {
      const header = await client.record(0);
      if (closed) return;
      if (!header?.scene?.bodies) throw new Error('The log carries no scene with the poses of its bodies.');
      scene = await client.scene();
      if (closed) return;
      const names = [...new Set((Array.isArray(scene.geoms) ? scene.geoms : []).map((geom) => geom?.body).filter((name) => typeof name === 'string'))];
      bodies = readMjcf(header.scene.mjcf, names);
      // Nothing of three is loaded before the page was painted once.
      await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
      if (closed) return;
      await stage.open(scene);
      stage.touch();
    } catch (problem) {
      if (!closed) body.replaceChildren(h('p', {class: 'empty', 'data-testid': 'scene-missing'}, problem.message));
    }
  }

  /** Before a frame: puts everything where it is at t. Gives whether anything moved. */
  function before(view, pictures) {
    if (!scene || closed) return false;
    const window = motion.at(t);
    if (!window) {
      if (motion.problem) caption.textContent = motion.problem;
      pictures?.want(t);
      return false;
    }
    world = {poses: window.poses(t), pointing: window.pointingAt(t), acts: window.actsAt(t)};
    sayLater();
    pictures?.want(t);
    if (!view) return false;
    const ghost_poses = ghostPoses();
    const now = JSON.stringify([[...world.poses], world.pointing, world.acts, ghost_poses && [...ghost_poses]]);
    if (now === drawn) return false;
    drawn = now;
    pose(view, ghost_poses);
    return true;
  }

  function pose(view, ghost_poses) {
    const {poses} = world;
    view.pose(poses);
    const heights = bodies.objects.map((name) => view.box(name)).filter(Boolean);
    const heightAt = (x, y) => heights.reduce((top, {min, max}) =>
      x > min.x && x < max.x && y > min.y && y < max.y ? Math.max(top, max.z) : top, -Infinity);
    const grip = bodies.grip && poses.get(bodies.grip.body);
    const pointing = world.pointing.map((one) => ({...one, from: one.origin ?? (one.who === 'avatar' ? grip && along(grip, bodies.grip.pos) : humanHand(one.hand))}));
    const acts = world.acts.map((act) => ({...act, from: poses.get(act.object)?.slice(0, 3) ?? null}));
    view.overlay(pointing, acts, heightAt);
    view.mark(selected);
    if (view.ghost && ghost_poses) view.ghost.show(poses, ghost_poses);
    const followed = [acts.find(({from}) => from)?.from, pointing.at(-1)?.target, poses.get(selected)?.slice(0, 3)].find(Boolean);
    if (show.follow && followed) stage.follow(followed);
  }

  function tag(view) {
    if (!world) return;
    const names = show.labels ? bodies.objects : selected ? [selected] : [];
    const tags = [];
    for (const name of names) {
      const pose = world.poses.get(name), box = pose && view.box(name);
      const at = box && view.project([pose[0], pose[1], box.max.z]);
      if (at) tags.push(h('span', {class: 'tag', style: {transform: `translate(${at[0].toFixed(1)}px, ${at[1].toFixed(1)}px) translate(-50%, -110%)`}}, name));
    }
    if (tags.length || stage.tags.childElementCount) stage.tags.replaceChildren(...tags);
  }

  // Words follow at a pace at which they can be read, or heard.
  function sayLater() {
    if (!words_timer) words_timer = setTimeout(() => { words_timer = 0; say(); }, words_every_ms);
  }
  function say() {
    if (!world || closed) return;
    const said = {...world, objects: bodies.objects};
    stage.describe(`The scene at ${t.toFixed(1)} seconds. ${sceneSentence(said)}`);
    const pose = selected && world.poses.get(selected);
    put(caption, pose ? `${selected}: ${placeText(pose)}` : sceneSentence(said, true));
    if (!list.open) return;
    const rows = bodies.objects.filter((name) => world.poses.has(name));
    if (places.childElementCount !== rows.length) places.replaceChildren(...rows.map((name) => h('li', {},
      h('button', {type: 'button', class: 'link', onclick: () => select(name)}, name), h('span', {class: 'muted'}))));
    rows.forEach((name, i) => {
      put(places.children[i].lastChild, placeText(world.poses.get(name)));
      places.children[i].firstChild.setAttribute('aria-pressed', String(name === selected));
    });
  }
  const put = (where, text) => { if (where.textContent !== text) where.textContent = text; };

  function ghostPoses() {
    if (!haunting?.geoms) return null;
    const at = haunting.other.timeOf(n);
    if (typeof at !== 'number') return new Map();
    const window = haunting.motion.at(at);
    if (window) haunting.last = window.poses(at);
    return haunting.last;
  }

  /** Another run as a ghost; null: none. */
  async function ghost(next) {
    haunting?.motion.close();
    haunting = null;
    drawn = '';
    stage.drawing?.haunt(null);
    stage.touch();
    if (!next) return;
    const mine = haunting = {other: next, geoms: null, last: new Map(),
      motion: new Motion({fetch: (from, to) => next.client.poses(from, to), duration: () => Infinity, arrived: () => stage.wake()})};
    const answer = await next.client.scene().catch(() => null);
    await opened;
    if (closed || haunting !== mine || !answer) return;
    mine.geoms = answer.geoms;
    stage.drawing?.haunt(answer.geoms);
    stage.touch();
  }

  const opened = open();
  if (other) ghost(other);

  return {
    element, ghost, stage,
    render(selection) {
      n = selection.n;
      t = typeof app.time === 'number' ? app.time : app.data.t[n];
      stage.wake();
    },
    close() {
      closed = true;
      clearTimeout(words_timer);
      motion.close();
      haunting?.motion.close();
      stage.close();
    },
  };
}

/** A point given in a body's frame, in the world. */
function along([x, y, z, w, i, j, k], [a, b, c]) {
  const tx = 2 * (j * c - k * b), ty = 2 * (k * a - i * c), tz = 2 * (i * b - j * a);
  return [x + a + w * tx + j * tz - k * ty, y + b + w * ty + k * tx - i * tz, z + c + w * tz + i * ty - j * tx];
}
