// Buttons for the cameras of a scene, one of which is pressed until the view is turned by hand.
import {h} from '../dom.js';

export class Cameras {
  /** Name of the camera, or null. */
  camera;
  #buttons;

  /** `cameras`: name -> {text, title}; `look(name)`: its button was pressed. */
  constructor(cameras, look) {
    [this.camera] = Object.keys(cameras);
    this.#buttons = Object.entries(cameras).map(([name, {text, title = null}]) =>
      h(
        'button',
        {type: 'button', 'aria-pressed': 'false', title, 'data-camera': name, onclick: () => look(name)},
        text,
      ),
    );
    this.element = h('span', {class: 'cameras', role: 'group', 'aria-label': 'Camera'}, this.#buttons);
    this.press(this.camera);
  }

  /** Shows this camera's button as pressed; null: none. */
  press(camera) {
    this.camera = camera;
    for (const button of this.#buttons) button.setAttribute('aria-pressed', String(button.dataset.camera === camera));
  }
}
