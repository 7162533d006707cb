// The scene at the cursor: bodies where the log has them, who points where, where the avatar means to take things.
import {h, panel, put} from '../dom.js';
import {pictureOf, served} from '../run/run_client.js';
import {three} from '../vendor.js';
import {Cameras} from '../scene3d/cameras.js';
import {GhostRun} from '../scene3d/ghost_run.js';
import {Motion} from '../scene3d/motion.js';
import {along, heightOver, humanHand} from '../scene3d/overlays.js';
import {placeText, readMjcf, sceneSentence} from '../scene3d/scene_text.js';
import {Stage} from '../scene3d/stage.js';
import {showTags} from '../scene3d/tags.js';

const near_px = 18; // of a target that is dragged
const words_every_ms = 250; // a pace at which they can be read, or heard
const cameras = {
  default: {text: 'All', title: 'the whole scene, from the human’s side'},
  table: {text: 'Table', title: 'what stands on the table, from the human’s side'},
  human: {text: 'Human', title: 'as the human sees it'},
  avatar: {text: 'Avatar', title: 'as the avatar sees it'},
  above: {text: 'Above', title: 'from above'},
};

class ScenePanel {
  #client;
  #cursor;
  #bodies = {objects: [], grip: null}; // by readMjcf()
  #titles = {}; // name -> what people call it
  #world = null; // {poses, pointing, acts} at the cursor
  #drawn = ''; // the last drawn state, as text
  #selected = null; // body
  #show = {labels: false, follow: false};
  #timer = 0;
  #loaded = false; // the scene is known
  #closed = false;
  #motion;
  #ghost = null;
  #opened;
  #elsewhere; // asks what if it had been pointed elsewhere
  #dragged = null; // {n, target}: of the pointing whose target is being dragged
  #cameras = new Cameras(cameras, (name) => this.#look(name));
  #caption = h('p', {class: 'caption', 'data-testid': 'scene-caption'});
  #places = h('ul', {class: 'places', 'data-testid': 'scene-places'});
  #list = h('details', {ontoggle: () => this.#say()}, h('summary', {}, 'What is where'), this.#places);
  #body;

  /**
   * `other`: another run to be drawn as a ghost, as of GhostRun, or null; `elsewhere({n, target})`: the target of the
   * human's pointing of record n was dragged to another place; null: it cannot be.
   */
  constructor({client, cursor, other = null, elsewhere = null}) {
    this.#elsewhere = elsewhere;
    this.#client = client;
    this.#cursor = cursor;
    this.stage = this.#mountStage();
    this.#motion = new Motion({
      fetch: (from, to) => client.poses(from, to),
      duration: () => cursor.data?.duration ?? 0,
      arrived: () => this.stage.wake(),
    });
    const toggles = [
      this.#toggle('labels', 'Labels', 'names of the objects'),
      this.#toggle('follow', 'Follow', 'keep looking at what is acted on or pointed at'),
    ];
    this.#body = h('div', {class: 'scene-body'}, this.stage.element, this.#caption, this.#list);
    this.element = panel('scene', 'Scene', [this.#cameras.element, toggles], this.#body);
    this.#opened = this.#open();
    if (other) this.ghost(other);
  }

  #mountStage() {
    const picture = (t, width, height) => {
      const at = Math.max(0, Math.min(t, this.#cursor.data.duration));
      return pictureOf(this.#client.id, at.toFixed(3), `${width}x${height}`);
    };
    return new Stage({
      three,
      address: served ? picture : null,
      before: (view, pictures) => this.#before(view, pictures),
      after: (view) => this.#tag(view),
      resized: (view) => {
        const {camera} = this.#cameras;
        if (camera) this.stage.view = view.cameras(this.#bodies.objects)[camera];
      },
      changed: () => this.#cameras.press(null),
      click: (name) => this.#select(name),
      grab: (x, y) => this.#grab(x, y),
    });
  }
  // The target of the human's pointing under a place of the canvas.
  #grab(x, y) {
    const {drawing} = this.stage;
    if (!this.#elsewhere || !drawing?.size || !this.#world) return null;
    const heightAt = heightOver(drawing, this.#bodies.objects);
    const near = ({who, target: [a, b, c]}) => {
      const at = who === 'human' && drawing.project([a, b, Math.max(c, heightAt(a, b))]);
      return at && Math.hypot(at[0] - x, at[1] - y) < near_px;
    };
    const one = this.#world.pointing.findLast(near);
    if (!one) return null;
    return {
      move: (to_x, to_y) => {
        const target = drawing.pointOn(to_x, to_y, this.#bodies.objects);
        this.#dragged = target && {n: one.n, target};
        this.#redraw();
      },
      drop: () => {
        const dragged = this.#dragged;
        this.#dragged = null;
        this.#redraw();
        if (dragged) this.#elsewhere(dragged);
      },
    };
  }
  #toggle(name, text, title) {
    const button = h('button', {type: 'button', 'aria-pressed': 'false', title, 'data-toggle': name}, text);
    button.addEventListener('click', () => {
      this.#show[name] = !this.#show[name];
      button.setAttribute('aria-pressed', String(this.#show[name]));
      if (!this.#show.follow) this.stage.follow(null);
      this.#redraw();
    });
    return button;
  }
  #look(name) {
    if (!this.stage.drawing) return;
    this.#cameras.press(name);
    this.stage.fly(this.stage.drawing.cameras(this.#bodies.objects)[name]);
  }
  #select(name) {
    this.#selected = name === this.#selected ? null : name;
    this.#redraw();
    this.#say();
  }
  #redraw() {
    this.#drawn = '';
    this.stage.touch();
  }

  async #open() {
    try {
      const header = await this.#client.record(0);
      if (this.#closed) return;
      if (!header?.scene?.bodies) throw new Error('The log carries no scene with the poses of its bodies.');
      const scene = await this.#client.scene();
      if (this.#closed) return;
      const named = (Array.isArray(scene.geoms) ? scene.geoms : []).map((geom) => geom?.body);
      const names = new Set(named.filter((name) => typeof name === 'string'));
      this.#bodies = readMjcf(header.scene.mjcf, [...names]);
      this.#titles = scene.titles ?? {};
      // three.js is loaded after the page was painted once.
      await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
      if (this.#closed) return;
      this.#loaded = true;
      await this.stage.open(scene);
      this.stage.touch();
    } catch (problem) {
      if (this.#closed) return;
      this.#body.replaceChildren(h('p', {class: 'empty', 'data-testid': 'scene-missing'}, problem.message));
    }
  }

  get #time() {
    return this.#cursor.time;
  }

  /** Before a frame: puts everything where it is at the cursor. @returns whether anything moved */
  #before(view, pictures) {
    if (!this.#loaded || this.#closed) return false;
    const t = this.#time;
    const window = this.#motion.at(t);
    if (!window && this.#motion.problem) this.#caption.textContent = this.#motion.problem;
    pictures?.want(t);
    if (!window) return false;
    const {poses, pointing, acts} = (this.#world = {
      poses: window.poses(t),
      pointing: window.pointingAt(t),
      acts: window.actsAt(t),
    });
    this.#sayLater();
    if (!view) return false;
    const ghost = this.#ghost?.posesAt(this.#cursor.n) ?? null;
    const now = JSON.stringify([[...poses], pointing, acts, ghost && [...ghost]]);
    if (now === this.#drawn) return false;
    this.#drawn = now;
    this.#pose(view, ghost);
    return true;
  }
  #pose(view, ghost) {
    const {poses, pointing, acts} = this.#world;
    const {objects, grip} = this.#bodies;
    view.pose(poses);
    const hand = grip && poses.get(grip.body);
    const avatarHand = () => hand && along(hand, grip.pos);
    const from = ({origin, who, hand: side}) => origin ?? (who === 'avatar' ? avatarHand() : humanHand(side));
    const positionOf = (name) => poses.get(name)?.slice(0, 3) ?? null;
    const moves = acts.map((act) => ({...act, from: positionOf(act.object)}));
    const heightAt = heightOver(view, objects);
    view.overlay(
      pointing.map((one) => ({
        ...one,
        from: from(one),
        ...(one.n === this.#dragged?.n && {...this.#dragged, trail: []}),
      })),
      moves,
      heightAt,
    );
    view.mark(this.#selected);
    if (view.ghost && ghost) view.ghost.show(poses, ghost);
    const followed = moves.find((one) => one.from)?.from ?? pointing.at(-1)?.target ?? positionOf(this.#selected);
    if (this.#show.follow && followed) this.stage.follow(followed);
  }
  #tag(view) {
    if (!this.#world) return;
    const chosen = this.#selected ? [this.#selected] : [];
    const tops = (this.#show.labels ? this.#bodies.objects : chosen).map((name) => {
      const pose = this.#world.poses.get(name);
      const box = pose && view.box(name);
      return [this.#title(name).replace(/^the /, ''), box && view.project([pose[0], pose[1], box.max.z])];
    });
    showTags(this.stage.tags, tops, '-110%');
  }

  #title(name) {
    return this.#titles[name] ?? name;
  }
  #sayLater() {
    this.#timer ||= setTimeout(() => {
      this.#timer = 0;
      this.#say();
    }, words_every_ms);
  }
  #say() {
    if (!this.#world || this.#closed) return;
    const told = {...this.#world, objects: this.#bodies.objects, titles: this.#titles};
    this.stage.describe(`The scene at ${this.#time.toFixed(1)} seconds. ${sceneSentence(told)}`);
    const pose = this.#selected && this.#world.poses.get(this.#selected);
    put(this.#caption, pose ? `${this.#title(this.#selected)}: ${placeText(pose)}` : sceneSentence(told, true));
    if (this.#list.open) this.#listPlaces();
  }
  #listPlaces() {
    const {poses} = this.#world;
    const names = this.#bodies.objects.filter((name) => poses.has(name));
    const link = (name) =>
      h('button', {type: 'button', class: 'link', title: name, onclick: () => this.#select(name)}, this.#title(name));
    if (this.#places.childElementCount !== names.length)
      this.#places.replaceChildren(...names.map((name) => h('li', {}, link(name), h('span', {class: 'muted'}))));
    names.forEach((name, i) => {
      const {firstChild, lastChild} = this.#places.children[i];
      put(lastChild, placeText(poses.get(name)));
      firstChild.setAttribute('aria-pressed', String(name === this.#selected));
    });
  }

  /** The objects by what people call them, each with what selects it: {name, act}[]. */
  get things() {
    return this.#bodies.objects.map((name) => ({
      name: this.#title(name),
      act: () => {
        if (this.#selected !== name) this.#select(name);
      },
    }));
  }
  /** Shows another run as a ghost, as of GhostRun; null: none. @returns a promise that resolves when it is there */
  ghost(other) {
    this.#ghost?.close();
    this.stage.drawing?.haunt(null);
    this.#ghost = other && new GhostRun(other, this.stage, this.#opened);
    this.#redraw();
    return this.#ghost?.opened;
  }
  render() {
    this.stage.wake();
  }
  close() {
    this.#closed = true;
    clearTimeout(this.#timer);
    this.#motion.close();
    this.#ghost?.close();
    this.stage.close();
  }
}

export const mountScene = (needs) => new ScenePanel(needs);
