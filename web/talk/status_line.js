// The line above a live session: the automaton's state, the engine's time, who watches, and the session's buttons.
import {h, clock, icon, put} from '../dom.js';
import {bigType} from './big_type.js';

const tick_ms = 200;

const button = (text, title, action, props) => h('button', {type: 'button', title, onclick: action, ...props}, text);

/** A button of something that is on or off; `toggle()` tells which. */
function switched(text, title, is_on, toggle, name) {
  const one = button(text, title, null, {'aria-pressed': String(is_on), 'data-testid': `live-${name}`});
  one.addEventListener('click', () => one.setAttribute('aria-pressed', String(toggle())));
  return one;
}

/** The buttons: `pause` and `end` are shown to who records, `speak` where the browser can speak. */
function buttonsOf(act, speaks) {
  return {
    pause: button('Pause', 'Stops the engine’s time (Space)', act.pause, {'data-testid': 'live-pause'}),
    end: button('End', 'Ends the recording', act.end, {'data-testid': 'live-end'}),
    film: button('Record me', 'Records your voice or your picture, if you agree', act.film, {
      'aria-pressed': 'false',
      'data-testid': 'live-film',
    }),
    hand: button('Track my hand', 'Your hand before the camera points and makes gestures, if you agree', act.hand, {
      'aria-pressed': 'false',
      'data-testid': 'live-hand',
    }),
    speak: window.speechSynthesis
      ? switched('Speak', 'Says aloud what the avatar says', speaks, act.speak, 'speak')
      : null,
    machine: switched('Machine', 'Its graph and its stack in the corner (G)', false, act.machine, 'machine-button'),
    big: switched('Big type', 'For a room that looks at a projector (B)', bigType.on, act.big, 'big'),
    map: button('Map', 'The table from above', act.map, {'aria-pressed': 'false', 'data-testid': 'live-map'}),
    save: button('Save as test', 'Keeps this conversation as a test', act.save, {'data-testid': 'live-save'}),
    keys: button('?', 'Keys (?)', act.keys, {'aria-label': 'Keys (?)', 'data-testid': 'help'}),
  };
}

const home = () =>
  h(
    'a',
    {class: 'brand', href: '/', title: 'All runs'},
    h('img', {src: icon(), alt: 'All runs', width: 22, height: 22}),
  );
const inspect = (run) =>
  h(
    'a',
    {
      class: 'button',
      href: `/r/${encodeURIComponent(run)}`,
      target: '_blank',
      'data-testid': 'live-inspect',
      title: 'Opens the inspector beside this page',
    },
    'Inspect',
  );

/**
 * `act`: {pause, end, save, keys, speak, map, machine, big, film, hand}; `recording`: this page records, or only watches; `films`,
 * `tracks`: whether it can record the human, and track a hand.
 */
export function mountStatus({run, recording, films, tracks, time, act, speaks}) {
  const state = h('span', {class: 'state', 'data-testid': 'live-state'});
  const seconds = h('output', {class: 'engine-time', 'data-testid': 'live-time'});
  const mode = h('span', {class: 'badge', role: 'status', 'data-testid': 'live-mode'});
  const watching = h('span', {class: 'muted watching', 'data-testid': 'live-viewers'});
  const buttons = buttonsOf(act, speaks);
  const {pause, end, film, hand, speak, map, machine, big, save, keys} = buttons;
  const element = h(
    'header',
    {class: 'top live-top'},
    home(),
    h('h1', {class: 'unseen'}, 'Conversation with the avatar'),
    mode,
    seconds,
    state,
    watching,
    h(
      'div',
      {class: 'transport'},
      recording && [pause, end],
      films && film,
      tracks && hand,
      speak,
      map,
      machine,
      big,
      save,
      inspect(run),
      keys,
    ),
  );
  const timer = setInterval(() => put(seconds, clock(time())), tick_ms);
  return {
    element,
    /** Shows {live, running, viewers, state, mapped, filmed, tracked, lost}; `lost`: the time since when the server is gone, or null. */
    render({live, running, viewers, state: now, mapped, filmed, tracked, lost = null}) {
      const is_lost = live && lost !== null;
      mode.className = `badge ${is_lost ? 'lost' : live && running ? 'live' : ''}`;
      const going = running ? '● recording' : '❚❚ paused';
      put(mode, is_lost ? `not connected since ${clock(lost)}` : live ? going : 'ended');
      put(watching, viewers > 0 ? `${viewers} watching` : '');
      put(state, now ?? '');
      put(pause, running ? 'Pause' : 'Go on');
      pause.hidden = end.hidden = film.hidden = hand.hidden = !live;
      put(film, filmed ? '● Stop recording me' : 'Record me');
      film.setAttribute('aria-pressed', String(Boolean(filmed)));
      put(hand, tracked ? '● Stop tracking my hand' : 'Track my hand');
      hand.setAttribute('aria-pressed', String(Boolean(tracked)));
      map.setAttribute('aria-pressed', String(mapped));
      put(seconds, clock(time()));
    },
    /** As if the button of this name were pressed. */
    press: (name) => buttons[name].click(),
    withoutMap() {
      map.hidden = true;
    },
    close: () => clearInterval(timer),
  };
}
