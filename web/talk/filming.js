// Recording of the human by microphone and camera, off until the human agrees: here, and then to the browser. The bytes go
// to the session's server alone, which keeps them beside the trace.
import {dialog, h} from '../dom.js';

const part_ms = 1000;
const again_ms = 1000;
const most_part = 2 ** 19; // bytes of a request
const types = {camera: 'video/webm', microphone: 'audio/webm'};

/** Whether this browser can record, at this address. */
export const canFilm = () => Boolean(globalThis.MediaRecorder && navigator.mediaDevices?.getUserMedia);

const refusals = {
  NotAllowedError: 'The browser was not allowed to record you: nothing is recorded.',
  NotFoundError: 'There is no such microphone or camera: nothing is recorded.',
};

const box = (name, label) => {
  const input = h('input', {type: 'checkbox', name, 'data-testid': `film-${name}`});
  return {input, element: h('label', {class: 'film-choice'}, input, label)};
};

/** Asks for agreement; `agreed({microphone, camera})` is called with what may be recorded. */
function consentDialog(agreed) {
  const [microphone, camera] = [box('microphone', 'my voice'), box('camera', 'my picture')];
  const record = h(
    'button',
    {type: 'button', class: 'primary', disabled: true, 'data-testid': 'film-agree'},
    'I agree: record',
  );
  const not_now = h('button', {type: 'button', 'data-testid': 'film-not-now'}, 'Not now');
  const element = dialog(
    {class: 'dialog film', 'aria-label': 'Record me', 'data-testid': 'film'},
    h('h2', {}, 'May this session record you?'),
    h(
      'p',
      {},
      `The recording goes to ${location.hostname}, the machine that runs this session, and is kept there in a file beside its trace. It is at most 1 GiB long. Whoever can read that folder can see and hear it.`,
    ),
    h('p', {}, 'You can stop at any time. What was recorded until then stays, until somebody deletes the file.'),
    h('p', {}, microphone.element, camera.element),
    h('div', {class: 'film-buttons'}, record, not_now),
  );
  const chosen = () => ({microphone: microphone.input.checked, camera: camera.input.checked});
  element.addEventListener('change', () => {
    record.disabled = !Object.values(chosen()).some(Boolean);
  });
  not_now.addEventListener('click', () => element.close());
  record.addEventListener('click', () => {
    element.close();
    agreed(chosen());
  });
  return {
    element,
    open() {
      microphone.input.checked = camera.input.checked = false;
      record.disabled = true;
      element.showModal();
    },
  };
}

export class Filming {
  #client;
  #time;
  #say;
  #changed;
  #stream = null;
  #recorder = null;
  #take = 0;
  #sent = Promise.resolve(); // all parts so far
  #closed = false;
  /** Whether anything has been recorded. */
  any = false;

  /** `time()`: of the engine; `say(sentence)`; `changed(on)`: recording has begun or ended. */
  constructor({client, time, say, changed}) {
    Object.assign(this, {dialog: consentDialog((wanted) => this.#begin(wanted))});
    this.#client = client;
    this.#time = time;
    this.#say = say;
    this.#changed = changed;
  }
  get on() {
    return this.#recorder !== null;
  }

  /** Asks, or stops what is being recorded. */
  toggle() {
    if (this.on) this.stop();
    else this.dialog.open();
  }

  async #begin({microphone, camera}) {
    try {
      this.#stream = await navigator.mediaDevices.getUserMedia({audio: microphone, video: camera});
    } catch (problem) {
      this.#say(refusals[problem.name] ?? `Nothing is recorded: ${problem.message}`);
      return;
    }
    if (this.#closed) {
      this.#release();
      return;
    }
    const source = camera ? 'camera' : 'microphone';
    const recorder = new MediaRecorder(this.#stream, {mimeType: types[source]});
    const take = {source, type: types[source], take: this.#take++, part: 0, t: this.#time()};
    recorder.addEventListener('start', () => {
      take.t = this.#time();
    });
    recorder.addEventListener('dataavailable', ({data}) => this.#keep(take, data));
    recorder.start(part_ms);
    this.#recorder = recorder;
    this.any = true;
    this.#say('');
    this.#changed(true);
  }

  #keep(take, data) {
    for (let from = 0; from < data.size; from += most_part) {
      const bytes = data.slice(from, from + most_part);
      const named = {...take, part: take.part++};
      this.#sent = this.#sent.then(() => this.#send(named, bytes));
    }
  }
  // Again and again while the server cannot be reached.
  async #send(named, bytes) {
    while (!this.#closed) {
      try {
        await this.#client.film(named, bytes);
        return;
      } catch (problem) {
        if (problem.status !== undefined) {
          this.#say(`You are not recorded any longer: ${problem.message}`);
          this.#halt();
          return;
        }
        await new Promise((done) => setTimeout(done, again_ms));
      }
    }
  }

  /** While the engine's time stands still, so does the recording. */
  pause(paused) {
    if (!this.#recorder) return;
    if (paused && this.#recorder.state === 'recording') this.#recorder.pause();
    if (!paused && this.#recorder.state === 'paused') this.#recorder.resume();
  }

  #release() {
    for (const track of this.#stream?.getTracks() ?? []) track.stop();
    this.#stream = null;
  }
  #halt() {
    const recorder = this.#recorder;
    this.#recorder = null;
    const stopped =
      recorder && recorder.state !== 'inactive'
        ? new Promise((done) => recorder.addEventListener('stop', done, {once: true}))
        : null;
    if (stopped) recorder.stop();
    this.#release();
    if (recorder) this.#changed(false);
    return stopped;
  }
  /** Resolves when all that was recorded has been sent. */
  async stop() {
    await this.#halt();
    await this.#sent;
  }
  close() {
    this.#halt();
    this.#closed = true;
  }
}
