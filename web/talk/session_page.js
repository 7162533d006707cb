// A live session: the scene to point at, the conversation, and where the human talks; or, for those who watch, the first two.
import {h} from '../dom.js';
import {copy} from '../announce.js';
import {helpDialog} from '../keys.js';
import {three} from '../vendor.js';
import {bigType} from './big_type.js';
import {mountConversation} from './conversation.js';
import {EngineClock} from './engine_clock.js';
import {Filming, canFilm} from './filming.js';
import {HandTracking, whyNoHand} from './hand_tracking.js';
import {LiveWorld} from './live_world.js';
import {mountMachine} from './machine_drawer.js';
import {mountPalette} from './palette.js';
import {mountPlace} from './place.js';
import {saveDialog} from './save_dialog.js';
import {SessionLink} from './session_link.js';
import {mountStatus} from './status_line.js';
import {readTable} from './table.js';
import {mountTalkBox} from './talk_box.js';
import {Voice} from './voice.js';

const page_keys = [
  [[], 'Enter /', 'talk'],
  [[], 'Esc', 'leave the text'],
  [[], 'Alt+1 Alt+9', 'in the text: the gestures with these digits'],
  [[], '↑ ↓', 'in the text: what was said earlier'],
  [[], 'Space', 'pause, go on'],
  [[], '← → ↑ ↓', 'on the scene: move the cross by 1 cm (Shift: 5 cm)'],
  [[], 'Enter', 'on the scene: point at the cross'],
  [[], 'Alt+← Alt+↑', 'on the scene: turn it; + and − approach'],
  [['g'], 'G', 'the machine’s graph and stack in the corner'],
  [['b'], 'B', 'big type, for a projector'],
  [[], 'T', 'light or dark'],
  [[], '?', 'this help'],
];
const mouse_help =
  'On the scene: moving the mouse points, a click points at something, holding the button points for as long. Drag with the right button, or with Shift, to turn it. ' +
  'A click while words are in the box goes with the word typed last.';

class SessionPage {
  #client;
  #opened_t; // engine's time when this page was opened
  #now; // by the status line
  #clock = new EngineClock();
  #voice = new Voice();
  #world = new LiveWorld(() => this.place?.render());
  #filming;
  #hand;
  #without_hand; // why there is none, or empty
  #conversation;
  #machine;
  #palette;
  #dialogs;
  #status;
  #link;
  #talk = null;
  #table = null; // its edges
  #begun = null; // resolves open()
  #goOn; // begins a session after this one
  #notice = h('p', {class: 'notice', role: 'status', 'data-testid': 'live-notice'});
  #unsent = h('ul', {class: 'unsent', role: 'status', 'data-testid': 'live-unsent', hidden: true});
  #below = h('div', {class: 'human-side'});
  #scene = h('section', {class: 'live-scene', 'aria-label': 'Scene'}, h('p', {class: 'loading'}, 'Loading…'));
  /** The scene to point at, as mountPlace() gives it; null before the first record has come. */
  place = null;

  constructor(client, state, goOn) {
    this.#goOn = goOn;
    const {run, live, paused, speed, t, viewers} = state;
    this.#client = client;
    this.#opened_t = t;
    this.#clock.told({t, running: live && !paused, speed});
    this.#now = {live, running: this.#clock.running, viewers, state: state.state, mapped: false, lost: null};
    this.#conversation = mountConversation(run);
    this.#machine = mountMachine(run);
    this.#palette = mountPalette(state, (event) => this.#send(() => [event]));
    this.#filming = new Filming({
      client,
      time: () => this.#clock.now,
      say: (sentence) => this.#say(sentence),
      changed: (filmed) => this.#show({filmed}),
    });
    this.#hand = new HandTracking({
      time: () => this.#clock.now,
      table: () => this.#table,
      sample: (event) => this.#sample(event),
      send: (event) => this.#send(() => [event]),
      say: (sentence) => this.#say(sentence),
      changed: (tracked) => this.#show({tracked}),
    });
    this.#without_hand = whyNoHand(state);
    this.#dialogs = {
      film: this.#filming.dialog,
      hand: this.#hand.dialog,
      help: helpDialog([...this.#palette.keys, ...page_keys], mouse_help),
      save: saveDialog(
        (name) => client.save(name),
        (text) => copy(text, 'Copied.'),
      ),
    };
    // Time that goes faster or slower than the clock's would not fit a recording.
    this.#status = this.#mountStatus(run, client.recording && speed === 1 && canFilm());
    this.#link = this.#mountLink();
    const talking = h('div', {class: 'talking'}, this.#conversation.element, this.#notice, this.#unsent, this.#below);
    const main = h('main', {class: 'live'}, this.#scene, talking, this.#machine.element);
    this.elements = [this.#status.element, main, ...Object.values(this.#dialogs).map((one) => one.element)];
    addEventListener('pagehide', this.#leaving);
    addEventListener('beforeunload', this.#asking);
  }

  #mountStatus(run, films) {
    const act = {
      pause: () => this.#pause(),
      end: () => this.#end(),
      save: () => this.#dialogs.save.open(),
      keys: () => this.#dialogs.help.open(),
      speak: () => this.#voice.toggle(),
      map: () => this.place?.toggle(),
      machine: () => this.#machine.toggle(),
      big: () => bigType.toggle(),
      film: () => this.#filming.toggle(),
      hand: () => this.#hand.toggle(),
    };
    const {recording} = this.#client;
    const tracks = recording && !this.#without_hand;
    return mountStatus({run, recording, films, tracks, time: () => this.#clock.now, speaks: this.#voice.on, act});
  }
  #mountLink() {
    return new SessionLink(this.#client, {
      record: (record) => this.#take(record),
      clock: (word) => {
        this.#clock.told(word);
        this.#show({running: word.running, viewers: word.viewers});
      },
      ended: (answer) => this.#ended(answer),
      answered: ({t}) => {
        if (Number.isFinite(t)) this.#clock.told({t});
      },
      connected: (is) => this.#connected(is),
      say: (sentence) => this.#say(sentence),
    });
  }

  // Without the server no time goes by here; words wait.
  #connected(is) {
    if (is) this.#say('');
    else if (this.#now.lost === null) {
      this.#clock.told({t: this.#clock.now, running: false});
      this.#say('Connection lost; trying again…');
    }
    this.#show({lost: is ? null : (this.#now.lost ?? this.#clock.now)});
    this.#showUnsent();
  }
  #showUnsent() {
    const words = this.#client.unsent
      .map(({text, name}) => (text === undefined ? (name ?? '') : `“${text}”`))
      .filter(Boolean);
    this.#unsent.hidden = this.#now.lost === null || !words.length;
    this.#unsent.replaceChildren(...words.map((one) => h('li', {}, `${one} waits to be sent`)));
  }

  #say(sentence) {
    this.#notice.textContent = sentence;
  }
  #show(change = {}) {
    this.#now = {...this.#now, ...change};
    this.#status.render(this.#now);
    this.#filming.pause(!this.#now.running);
    this.#hand.pause(!this.#now.running || this.#now.lost !== null);
    if (this.place) this.place.pointing.enabled = this.#working;
  }
  /** Whether this page records a session that goes on. */
  get #working() {
    return this.#client.recording && this.#now.live;
  }
  // Sends the events that `make(t)` gives.
  #send(make) {
    if (!this.#working) return;
    if (this.#link.works) this.#say('');
    this.#client.send(() => make(this.#clock.now));
    this.#showUnsent();
  }

  // Sends what is worth sending only now.
  #sample(event) {
    if (this.#working && this.#link.works && this.#now.running) this.#client.sample(event);
  }

  #take(record) {
    const {kind, t, event} = record;
    this.#clock.atLeast(t);
    this.#machine.take(record);
    if (kind === 'run') this.#begin(record.scene);
    else if (kind === 'pose') this.#world.moved(record.bodies);
    else if (kind === 'transition') this.#show({state: record.to});
    else if (kind === 'act') this.#world.act(record);
    else if (kind === 'percept')
      for (const {deixis} of record.bound ?? []) if (deixis?.place) this.#world.flash(deixis.place);
    if (kind === 'input' && event?.target && (this.#hand.on || !this.#client.recording))
      this.#world.watch(event.target);
    const line = this.#conversation.take(record);
    // Sentences said before this page was opened are not said again.
    if (line?.who === 'avatar' && line.how === 'says' && t >= this.#opened_t) this.#voice.say(line.text);
  }

  // The session's scene is known: it can be pointed at.
  async #begin(own) {
    const known = readTable(own);
    this.#world.begin(own);
    this.#table = known.table;
    this.place = mountPlace({
      own,
      known,
      world: this.#world,
      drawn: Boolean(three),
      tell: (mapped) => this.#show({mapped}),
      lost: () => this.#status.withoutMap(),
      keeps: (target) => this.#talk?.keeps(target) ?? false,
      send: (event) => this.#send(() => [event]),
      sample: (event) => this.#sample(event),
    });
    this.#scene.replaceChildren(this.place.element, this.#hand.element);
    if (this.#working) this.#beginTalk(known.examples);
    else if (this.#now.live) {
      const sentence = 'You are watching; somebody else records.';
      this.#below.replaceChildren(h('p', {class: 'watch', 'data-testid': 'live-watching'}, sentence));
    }
    this.#show();
    this.#begun(await this.place.open());
  }
  #beginTalk(examples) {
    this.#talk = mountTalkBox({
      examples,
      gesture: (key) => this.#palette.onKey(key),
      send: (make) => this.#send(make),
      said: (sentence) => this.#say(sentence),
      clicked: (clicks) => this.#world.set({clicks}),
    });
    const without = this.#without_hand && h('p', {class: 'muted', 'data-testid': 'hand-missing'}, this.#without_hand);
    this.#below.replaceChildren(this.#palette.element, this.#talk.element, ...(without ? [without] : []));
    this.#talk.focus();
  }

  async #pause() {
    if (!this.#working) return;
    try {
      const {t, paused} = await this.#client.pause(this.#now.running);
      this.#clock.told({t, running: !paused});
      this.#show({running: !paused});
    } catch (problem) {
      this.#say(problem.message);
    }
  }
  async #end() {
    this.#say('Ending: the avatar finishes what it is doing …');
    try {
      await this.#filming.stop();
      this.#ended(await this.#client.end());
    } catch (problem) {
      this.#say(problem.message);
    }
  }
  // Told by the answer to end() and by the stream, whichever comes first.
  #ended({t, state, trace, run}) {
    if (!this.#now.live && this.#below.querySelector('.summary')) return;
    this.#link.close();
    this.#filming.close();
    this.#hand.close();
    this.#talk?.close();
    this.#voice.stop();
    this.#clock.told({t, running: false});
    this.#world.set({pointer: null, cross: null, clicks: []});
    this.#show({live: false, running: false, viewers: 0, state, tracked: false});
    this.#say('');
    this.#summarise(trace, run);
  }
  #summarise(trace, run) {
    const save = h('button', {type: 'button', class: 'primary'}, 'Save as test');
    save.addEventListener('click', () => this.#dialogs.save.open());
    const sentence = h('p', {}, 'The conversation has ended. Its trace is ', h('code', {}, trace));
    if (this.#filming.any) sentence.append(', which names the recordings of you: they lie beside it');
    const more = h(
      'button',
      {type: 'button', 'data-testid': 'live-go-on', title: 'A new session, in which all of this has happened'},
      'Go on',
    );
    more.addEventListener('click', async () => {
      more.disabled = true;
      this.#say('The conversation so far is replayed …');
      await this.#goOn().catch((problem) => {
        this.#say(problem.message);
        more.disabled = false;
      });
    });
    const ways = [
      save,
      more,
      h('a', {class: 'button', href: `/r/${encodeURIComponent(run)}`}, 'Inspect'),
      h('a', {class: 'button', href: '/live'}, 'Start another'),
    ];
    const summary = h('div', {class: 'summary', 'data-testid': 'live-summary'}, sentence, h('p', {}, ways));
    this.#below.replaceChildren(summary);
    if (this.#client.recording) save.focus();
  }

  #leaving = ({persisted}) => {
    if (!persisted && this.#working) this.#client.leave();
  };
  // The browser asks whether to leave while a session is recorded.
  #asking = (event) => {
    if (this.#working) event.preventDefault();
  };

  /** The colours may have changed. */
  render() {
    this.#world.set({});
  }
  /** Resolves when the scene is there. */
  open() {
    const there = new Promise((done) => {
      this.#begun = done;
    });
    this.#show();
    if (this.#working) this.#client.comeBack().catch(() => {});
    this.#link.connect();
    return there;
  }
  /** Does what the key means. @returns whether it means something here */
  onKey(key) {
    if (key === '?') this.#dialogs.help.open();
    else if (key === 'g') this.#status.press('machine');
    else if (key === 'b') this.#status.press('big');
    else if (!this.#working) return false;
    else if (key === '/' || key === 'Enter') this.#talk?.focus();
    else if (this.#palette.onKey(key)) return true;
    else if (key === ' ') this.#pause();
    else return false;
    return true;
  }
  close() {
    if (this.#working) this.#client.leave();
    removeEventListener('pagehide', this.#leaving);
    removeEventListener('beforeunload', this.#asking);
    this.#link.close();
    const parts = [this.#filming, this.#hand, this.#client, this.#world, this.#status, this.#machine];
    for (const one of [...parts, this.place, this.#talk]) one?.close();
    this.#voice.stop();
  }
}

/** `client`: of the session; `state`: the server's answer about it; `goOn()`: begins a session that goes on after its end. */
export const mountSession = (client, state, goOn) => new SessionPage(client, state, goOn);
