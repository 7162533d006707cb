// The scene of a live session, drawn as poses come in, with the marks of the human's pointing.
import {three} from '../vendor.js';
import {Cameras} from '../scene3d/cameras.js';
import {fit, sides} from '../scene3d/framing.js';
import {heightOver} from '../scene3d/overlays.js';
import {Stage} from '../scene3d/stage.js';
import {showTags} from '../scene3d/tags.js';
import {targetOf} from './table.js';

const cameras = {default: {text: 'All'}, table: {text: 'Table'}, above: {text: 'Above'}};
const room_above_m = 0.22; // above the table, for a carried object
const tag_above_m = 0.02;

// A mark of the human's pointing, as the overlays want it.
const disc = (target, trail = []) => ({
  who: 'human',
  target: [...target, 0],
  from: null,
  trail: trail.map((place) => [...place, 0]),
});

class Scene3d {
  #scene;
  #known;
  #world;
  #drawn = -1; // version of the world
  #heightAt = () => 0;
  #cameras = new Cameras(cameras, (name) => this.#look(name));

  constructor(scene, known, world, lost) {
    this.#scene = scene;
    this.#known = known;
    this.#world = world;
    this.stage = new Stage({
      three,
      lost,
      pointing: true,
      before: (view) => this.#before(view),
      after: (view) => this.#tag(view),
      resized: (view) => {
        const {camera} = this.#cameras;
        if (camera) this.stage.view = this.#viewOf(view, camera);
      },
      changed: () => this.#cameras.press(null),
    });
    const {canvas, element} = this.stage;
    canvas.setAttribute('aria-label', 'The scene. Arrow keys move a cross on the table, Enter points there.');
    this.element = element;
    this.focusable = canvas;
    this.controls = this.#cameras.element;
  }

  #look(name) {
    if (!this.stage.drawing) return;
    this.#cameras.press(name);
    this.stage.fly(this.#viewOf(this.stage.drawing, name));
  }
  #viewOf(view, name) {
    if (name !== 'table') return view.cameras(this.#known.objects)[name];
    const {left, right, near, far} = this.#known.table;
    const corners = [left, right].flatMap((x) => [near, far].map((y) => [x, y]));
    const room = corners.flatMap(([x, y]) => [0, room_above_m].map((z) => [x, y, z]));
    return fit(sides.front, room, view.camera.aspect);
  }

  #before(view) {
    const {version, poses, pointer, trail, cross, clicks, understood, heading} = this.#world;
    if (!view || this.#drawn === version) return false;
    this.#drawn = version;
    view.pose(poses);
    this.#heightAt = heightOver(view, this.#known.objects, 0);
    const pointing = [
      ...(pointer ? [disc(pointer, trail)] : []),
      ...(cross ? [disc(cross)] : []),
      ...clicks.map(({target}) => disc(target)),
    ];
    const places = understood.map(([x, y]) => ({target: [x, y, this.#heightAt(x, y)], from: null}));
    view.overlay(pointing, heading ? [...places, heading] : places, this.#heightAt);
    return true;
  }
  // The clicks' numbers.
  #tag(view) {
    const tags = this.#world.clicks.map(({target: [x, y]}, i) => [
      String(i + 1),
      view.project([x, y, this.#heightAt(x, y) + tag_above_m]),
    ]);
    showTags(this.stage.tags, tags, '-130%');
  }

  async open() {
    await this.stage.open(this.#scene);
    this.stage.touch();
  }
  /** The point of the table, or of an object on it, under a place of the window; null where there is none. */
  at(x, y) {
    const {drawing, canvas} = this.stage;
    if (!drawing?.size) return null;
    const box = canvas.getBoundingClientRect();
    return targetOf(this.#known.table, drawing.pointOn(x - box.left, y - box.top, this.#known.objects));
  }
  render() {
    this.stage.wake();
  }
  close() {
    this.stage.close();
  }
}

/** `scene`: of the log; `known`: of readTable(); `world`: a LiveWorld; `lost()`: the scene cannot be drawn here. */
export const mountScene3d = (scene, known, world, lost) => new Scene3d(scene, known, world, lost);
