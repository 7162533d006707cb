// The scene of a live session, drawn as poses come in, with what the human points at.
import {h} from '../dom.js';
import {three} from '../vendor.js';
import {fit, sides} from '../scene3d/framing.js';
import {Stage} from '../scene3d/stage.js';
import {targetOf} from './table.js';

const camera_names = {table: 'Table', default: 'All', above: 'Above'};
const room_above_m = 0.22;   // the table, for what the hand carries

/** `known`: of readTable(); `world`: of LiveWorld; `lost()`: it cannot be drawn here. */
export function mountScene3d(scene, known, world, lost) {
  let camera = 'table', drawn = -1, heightAt = () => 0;
  const stage = new Stage({three, before, after: tag, lost, pointing: true,
    resized: (view) => { if (camera) stage.view = viewOf(view, camera); }, changed: () => press(null)});
  stage.canvas.setAttribute('aria-label', 'The scene. Arrow keys move a cross on the table, Enter points there.');
  const cameras = Object.entries(camera_names).map(([name, text]) => h('button', {type: 'button', 'aria-pressed': String(name === camera), 'data-camera': name,
    onclick: () => {
      if (!stage.drawing) return;
      press(name);
      stage.fly(viewOf(stage.drawing, name));
    }}, text));
  function viewOf(view, name) {
    if (name !== 'table') return view.cameras(known.objects)[name];
    const {left, right, near, far} = known.table, corners = [[left, near], [right, near], [left, far], [right, far]];
    return fit(sides.front, corners.flatMap(([x, y]) => [[x, y, 0], [x, y, room_above_m]]), view.camera.aspect);
  }
  const press = (name) => {
    camera = name;
    for (const button of cameras) button.setAttribute('aria-pressed', String(button.dataset.camera === name));
  };

  function before(view) {
    if (!view || drawn === world.version) return false;
    drawn = world.version;
    view.pose(world.poses);
    const boxes = known.objects.map((name) => view.box(name)).filter(Boolean);
    heightAt = (x, y) => boxes.reduce((top, {min, max}) => (x > min.x && x < max.x && y > min.y && y < max.y ? Math.max(top, max.z) : top), 0);
    const disc = (target, trail = []) => ({who: 'human', target: [...target, 0], from: null, trail: trail.map((place) => [...place, 0])});
    const pointing = [...world.pointer ? [disc(world.pointer, world.trail)] : [], ...world.cross ? [disc(world.cross)] : [], ...world.clicks.map(({target}) => disc(target))];
    view.overlay(pointing, world.understood.map(([x, y]) => ({target: [x, y, heightAt(x, y)], from: null})), heightAt);
    return true;
  }
  function tag(view) {
    const tags = world.clicks.map(({target: [x, y]}, i) => [String(i + 1), view.project([x, y, heightAt(x, y) + 0.02])]).filter(([, at]) => at);
    stage.tags.replaceChildren(...tags.map(([text, at]) =>
      h('span', {class: 'tag', style: {transform: `translate(${at[0].toFixed(1)}px, ${at[1].toFixed(1)}px) translate(-50%, -130%)`}}, text)));
  }

  return {
    element: stage.element, focusable: stage.canvas, controls: h('span', {class: 'cameras', role: 'group', 'aria-label': 'Camera'}, cameras),
    stage,
    async open() {
      await stage.open(scene);
      stage.touch();
    },
    /** The point of the table, or of what stands on it, under a place of the window. */
    at(x, y) {
      if (!stage.drawing?.size) return null;
      const box = stage.canvas.getBoundingClientRect();
      return targetOf(known.table, stage.drawing.pointOn(x - box.left, y - box.top, known.objects));
    },
    render: () => stage.wake(),
    close: () => stage.close(),
  };
}
