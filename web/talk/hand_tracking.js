// The human's hand before the camera, as pointing and gestures: off until the human agrees, here and to the browser. A
// model that the program brings finds the hand's points in each picture, in a worker (hands/worker.js); pictures stay in
// the browser. The server makes events of the points, as it does of recordings (replay/recogniser/RECOGNISERS.md, Hands).
import {dialog, h} from '../dom.js';
import {mountHandView} from './hand_view.js';

const least_ms = 50; // between pictures
const rest_share = 0.25; // of the time that a picture takes: the computer has other things to do
const wanted_video = {width: {ideal: 640}, height: {ideal: 480}, facingMode: 'user'};
// The part of the mirrored picture that is the table as the human sees it: a hand that points at its edges is still seen.
const table_part = {left: 0.2, right: 0.8, top: 0.15, bottom: 0.7};

/** Why a hand cannot be tracked here, a sentence; empty: it can. `state`: of the session. */
export function whyNoHand({hands}) {
  if (!hands) return 'Your hand cannot be tracked: the model that finds hands is not installed with this program.';
  const draws = globalThis.OffscreenCanvas && new OffscreenCanvas(1, 1).getContext('webgl2');
  if (!draws || !globalThis.Worker) return 'Your hand cannot be tracked: this browser has no WebGL.';
  if (!navigator.mediaDevices?.getUserMedia) return 'Your hand cannot be tracked: this address may not use the camera.';
  return '';
}

const refusals = {
  NotAllowedError: 'The browser was not allowed to use the camera: your hand is not tracked.',
  NotFoundError: 'There is no camera: your hand is not tracked.',
};

function consentDialog(agreed) {
  const track = h('button', {type: 'button', class: 'primary', 'data-testid': 'hand-agree'}, 'I agree: track my hand');
  const not_now = h('button', {type: 'button', 'data-testid': 'hand-not-now'}, 'Not now');
  const element = dialog(
    {class: 'dialog film', 'aria-label': 'Track my hand', 'data-testid': 'hand-consent'},
    h('h2', {}, 'May this page look at your hand?'),
    h(
      'p',
      {},
      'The camera’s pictures stay in this browser: they are neither sent nor kept. A model that came with the program finds 21 points of your hand in them.',
    ),
    h(
      'p',
      {},
      `Those points go to ${location.hostname}, the machine that runs this session. Its trace gets the gestures that they show, with the form of the hand, and where you point. You can stop at any time.`,
    ),
    h('p', {}, 'Point with your index finger; thumb up or down, a flat hand and a claw are gestures.'),
    h('div', {class: 'film-buttons'}, track, not_now),
  );
  not_now.addEventListener('click', () => element.close());
  track.addEventListener('click', () => {
    element.close();
    agreed();
  });
  return {element, open: () => element.showModal()};
}

// The camera that sees the table in this part of the mirrored picture (replay/recogniser/camera.h).
const cameraOf = ({left, right, near, far}) => ({
  corners: [
    {seen: [table_part.left, table_part.top], is: [left, far]},
    {seen: [table_part.right, table_part.top], is: [right, far]},
    {seen: [table_part.right, table_part.bottom], is: [right, near]},
    {seen: [table_part.left, table_part.bottom], is: [left, near]},
  ],
});

/** The worker; a question is answered before the next one. */
class Finder {
  #worker = new Worker('/hands/worker.js');
  #answer = null;
  #fail = null;
  ready;

  constructor() {
    this.#worker.addEventListener('message', ({data}) => {
      if (data.problem) this.#fail(new Error(data.problem));
      else this.#answer(data.found);
    });
    this.#worker.addEventListener('error', () => this.#fail(new Error('the model cannot be loaded')));
    this.ready = this.#answered();
  }
  #answered() {
    return new Promise((answer, fail) => {
      this.#answer = answer;
      this.#fail = fail;
    });
  }
  /** The hand in a picture, which is used up. */
  find(picture) {
    this.#worker.postMessage(picture, [picture]);
    return this.#answered();
  }
  close() {
    this.#worker.terminate();
  }
}

export class HandTracking {
  #needs;
  #view = mountHandView(table_part);
  #stream = null;
  #finder = null;
  #paused = false;
  #telling = false; // something has been told that has yet to end
  #closed = false;
  element = h('div', {class: 'hand-place'});

  /**
   * `time()`: of the engine, seconds; `table()`: its edges; `sample(event)`: worth sending only now; `send(event)`;
   * `say(sentence)`; `changed(on)`: tracking has begun or ended.
   */
  constructor(needs) {
    this.#needs = needs;
    this.dialog = consentDialog(() => this.#begin());
  }
  get on() {
    return this.#stream !== null;
  }
  /** Asks, or stops. */
  toggle() {
    if (this.on) this.stop();
    else this.dialog.open();
  }
  /** While the engine's time stands still, nothing is looked at. */
  pause(paused) {
    this.#paused = paused;
  }

  async #begin() {
    const {say, changed} = this.#needs;
    try {
      this.#stream = await navigator.mediaDevices.getUserMedia({video: wanted_video});
    } catch (problem) {
      say(refusals[problem.name] ?? `Your hand is not tracked: ${problem.message}`);
      return;
    }
    if (this.#closed) {
      this.#halt();
      return;
    }
    say('');
    changed(true);
    this.#view.video.srcObject = this.#stream;
    this.#view.show(null);
    this.element.replaceChildren(this.#view.element);
    this.#finder = new Finder();
    this.#track(this.#stream);
  }

  // Looks at one picture after the other until somebody stops it.
  async #track(stream) {
    const lost = (why) => {
      if (this.#stream !== stream) return;
      this.stop();
      this.#needs.say(`Your hand is not tracked any longer: ${why}`);
    };
    stream.getVideoTracks()[0].addEventListener('ended', () => lost('the camera is gone.'));
    try {
      await this.#view.video.play();
      await this.#finder?.ready;
      while (this.#stream === stream) await this.#look(stream);
    } catch (problem) {
      lost(problem.message);
    }
  }

  // One picture, and a rest.
  async #look(stream) {
    const began = performance.now();
    if (this.#paused || document.hidden) this.#end();
    else {
      const t = this.#needs.time();
      const found = await this.#finder.find(await createImageBitmap(this.#view.video));
      if (this.#stream !== stream) return;
      this.#view.show(found, performance.now() - began);
      this.#tell(t, found);
    }
    const took = performance.now() - began;
    await new Promise((done) => setTimeout(done, Math.max(least_ms - took, rest_share * took)));
  }
  #tell(t, found) {
    this.#telling = true;
    const part = {timestamp_ms: Math.round(1000 * t), ...found};
    const camera = cameraOf(this.#needs.table());
    this.#needs.sample({kind: 'recognised', from: 'mediapipe', camera, parts: [part]});
  }
  // A gesture that is still shown stops.
  #end() {
    if (this.#telling) this.#needs.send({kind: 'recognised', from: 'mediapipe', end: true});
    this.#telling = false;
  }

  #halt() {
    for (const track of this.#stream?.getTracks() ?? []) track.stop();
    this.#stream = null;
    this.#finder?.close();
    this.#finder = null;
    this.#view.video.srcObject = null;
    this.element.replaceChildren();
  }
  stop() {
    this.#halt();
    this.#end();
    this.#needs.changed(false);
  }
  /** The session is over: nothing is told any more. */
  close() {
    this.#closed = true;
    this.#halt();
  }
}
