// A live session: the scene to point at, the conversation, and where the human talks; or, for those who watch, the first two.
import {h} from '../dom.js';
import {helpDialog} from '../keys.js';
import {three} from '../vendor.js';
import {mountConversation} from './conversation.js';
import {EngineClock} from './engine_clock.js';
import {LiveWorld} from './live_world.js';
import {mountPalette} from './palette.js';
import {mountPlace} from './place.js';
import {saveDialog} from './save_dialog.js';
import {mountStatus} from './status_line.js';
import {readTable} from './table.js';
import {mountTalkBox} from './talk_box.js';
import {Voice} from './voice.js';

const page_keys = [
  [[], 'Enter /', 'talk'], [[], 'Esc', 'leave the text'], [[], '↑ ↓', 'in the text: what was said earlier'], [[], 'Space', 'pause, go on'],
  [[], '← → ↑ ↓', 'on the scene: move the cross by 1 cm (Shift: 5 cm)'], [[], 'Enter', 'on the scene: point at the cross'], [[], 'Alt+← Alt+↑', 'on the scene: turn it; + and − approach'],
  [[], 'T', 'light or dark'], [[], '?', 'this help'],
];
const mouse_help = 'On the scene: moving the mouse points, a click points at something, holding the button points for as long. Drag with the right button, or with Shift, to turn it. ' +
  'A click while words are in the box goes with the word typed last.';

/** `client`: of the session; `state`: what the server says of it. */
export function mountSession(client, state, app) {
  const clock = new EngineClock(), voice = new Voice();
  clock.told({t: state.t, running: state.live && !state.paused, speed: state.speed});
  let now = {live: state.live, running: clock.running, viewers: state.viewers, state: state.state, mapped: false};
  let stream = null, last_n = -1, begun = null, place = null, talk = null, closed = false;

  const lost = new Set();   // which ways to the server do not work: 'events', 'stream'
  const world = new LiveWorld(() => place?.render());
  const notice = h('p', {class: 'notice', role: 'status', 'data-testid': 'live-notice'});
  const say = (sentence) => { notice.textContent = sentence; };
  const conversation = mountConversation(state.run);
  const palette = mountPalette(state, (event) => send(() => [event]));
  const dialogs = {help: helpDialog([...palette.keys, ...page_keys], mouse_help), save: saveDialog((name) => client.save(name), (text) => app.copy(text, 'Copied.'))};
  const status = mountStatus({run: state.run, recording: client.recording, time: () => clock.now, speaks: voice.on,
    act: {pause, end, save: () => dialogs.save.open(), keys: () => dialogs.help.open(), speak: () => voice.toggle(), map: () => place?.toggle()}});
  const below = h('div', {class: 'human-side'});
  const scene = h('section', {class: 'live-scene', 'aria-label': 'Scene'}, h('p', {class: 'loading'}, 'Loading…'));
  const main = h('main', {class: 'live'}, scene, h('div', {class: 'talking'}, conversation.element, notice, below));

  function render(change = {}) {
    now = {...now, ...change};
    status.render(now);
    if (place) place.pointing.enabled = client.recording && now.live;
  }
  const working = () => client.recording && now.live;
  function send(make) {
    if (!working()) return;
    if (!lost.size) say('');
    client.send(() => make(clock.now));
  }
  function told({answered, lost: unreachable, refused}) {
    if (answered) {
      if (Number.isFinite(answered.t)) clock.told({t: answered.t});
      mended('events');
    }
    if (unreachable) trouble('events');
    if (refused) say(`The server does not take this: ${refused}`);
  }
  client.listen(told);

  function trouble(way) {
    lost.add(way);
    say('Connection lost; trying again…');
  }
  function mended(way) {
    if (lost.delete(way) && !lost.size) say('');
  }
  function connect() {
    stream?.close();
    stream = client.stream(last_n);
    stream.onopen = () => {
      mended('stream');
      client.flush();
    };
    stream.onerror = async () => {
      if (closed || !now.live) return;
      trouble('stream');
      // A stream that was refused does not come back by itself: the server says why.
      if (stream.readyState !== EventSource.CLOSED) return;
      const answer = await client.state().catch((problem) => problem);
      if (answer.status) say(answer.message);
      else if (!closed) setTimeout(connect, 1000);
    };
    stream.addEventListener('record', ({data}) => take(JSON.parse(data)));
    stream.addEventListener('clock', ({data}) => {
      const word = JSON.parse(data);
      clock.told(word);
      render({running: word.running, viewers: word.viewers});
    });
    stream.addEventListener('ended', ({data}) => ended(JSON.parse(data)));
  }

  function take(record) {
    if (record.n <= last_n) return;
    last_n = record.n;
    clock.atLeast(record.t);
    if (record.kind === 'run') begin(record.scene);
    else if (record.kind === 'pose') world.moved(record.bodies);
    else if (record.kind === 'transition') render({state: record.to});
    else if (record.kind === 'percept') for (const {deixis} of record.bound ?? []) if (deixis?.place) world.flash(deixis.place);
    if (record.kind === 'input' && record.event?.target && !client.recording) world.watch(record.event.target);
    const line = conversation.take(record);
    if (line?.who === 'avatar' && line.how === 'says' && caughtUp(record)) voice.say(line.text);
  }
  // What was said before this page was opened is not said again.
  const opened_t = state.t;
  const caughtUp = ({t}) => t >= opened_t;

  async function begin(own) {
    const known = readTable(own);
    world.begin(own);
    place = mountPlace({own, known, world, status, drawn: Boolean(three), tell: (mapped) => render({mapped}), keeps: (target) => talk?.keeps(target) ?? false,
      send: (event) => send(() => [event]), sample: (event) => { if (working() && !lost.size && now.running) client.sample(event); }});
    scene.replaceChildren(place.element);
    if (working()) {
      talk = mountTalkBox({example: known.example, send, said: say, clicked: (clicks) => world.set({clicks})});
      below.replaceChildren(palette.element, talk.element);
      talk.focus();
    } else if (now.live) below.replaceChildren(h('p', {class: 'watch', 'data-testid': 'live-watching'}, 'You are watching; somebody else records.'));
    render();
    begun(await place.open());
  }

  async function pause() {
    if (!working()) return;
    try {
      const answer = await client.pause(now.running);
      clock.told({t: answer.t, running: !answer.paused});
      render({running: !answer.paused});
    } catch (problem) { say(problem.message); }
  }
  async function end() {
    say('Ending: the avatar finishes what it is doing …');
    try { ended(await client.end()); } catch (problem) { say(problem.message); }
  }
  function ended(answer) {
    if (!now.live && below.querySelector('.summary')) return;
    stream?.close();
    talk?.close();
    voice.stop();
    clock.told({t: answer.t, running: false});
    world.set({pointer: null, cross: null, clicks: []});
    render({live: false, running: false, viewers: 0, state: answer.state});
    say('');
    const first = h('button', {type: 'button', class: 'primary', onclick: () => dialogs.save.open()}, 'Save as test');
    below.replaceChildren(h('div', {class: 'summary', 'data-testid': 'live-summary'}, h('p', {}, 'The conversation has ended. Its trace is ', h('code', {}, answer.trace)),
      h('p', {}, first, h('a', {class: 'button', href: `/r/${encodeURIComponent(answer.run)}`}, 'Inspect'), h('a', {class: 'button', href: '/live'}, 'Start another'))));
    if (client.recording) first.focus();
  }

  const leaving = ({persisted}) => { if (!persisted && working()) client.leave(); };
  addEventListener('pagehide', leaving);

  return {
    get place() { return place; },
    render: () => world.set({}),
    elements: [status.element, main, ...Object.values(dialogs).map((one) => one.element)],
    /** Resolves when the scene is there. */
    open() {
      const there = new Promise((done) => { begun = done; });
      render();
      connect();
      return there;
    },
    onKey(key) {
      if (key === '?') dialogs.help.open();
      else if (!working()) return false;
      else if (key === '/' || key === 'Enter') talk?.focus();
      else if (palette.onKey(key)) return true;
      else if (key === ' ') pause();
      else return false;
      return true;
    },
    close() {
      closed = true;
      removeEventListener('pagehide', leaving);
      stream?.close();
      for (const one of [client, world, status, place, talk]) one?.close();
      voice.stop();
    },
  };
}
