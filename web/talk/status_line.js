// The line above a live session: the automaton's state, the engine's time, who watches, and what can be done with it.
import {h, clock, icon} from '../dom.js';

const tick_ms = 200;

/** `act`: {pause, end, save, keys, speak, map}; `recording`: this page records, or only watches. */
export function mountStatus({run, recording, time, act, speaks}) {
  const state = h('span', {class: 'state', 'data-testid': 'live-state'}), seconds = h('output', {class: 'engine-time', 'data-testid': 'live-time'});
  const mode = h('span', {class: 'badge', role: 'status', 'data-testid': 'live-mode'}), watching = h('span', {class: 'muted watching', 'data-testid': 'live-viewers'});
  const button = (text, title, action, props) => h('button', {type: 'button', title, onclick: action, ...props}, text);
  const pause = button('Pause', 'Stops the engine’s time (Space)', act.pause, {'data-testid': 'live-pause'});
  const end = button('End', 'Ends the recording', act.end, {'data-testid': 'live-end'});
  const speak = window.speechSynthesis && button('Speak', 'Says aloud what the avatar says', () => speak.setAttribute('aria-pressed', String(act.speak())), {'aria-pressed': String(speaks), 'data-testid': 'live-speak'});
  const map = button('Map', 'The table from above', () => act.map(), {'aria-pressed': 'false', 'data-testid': 'live-map'});
  const element = h('header', {class: 'top live-top'},
    h('a', {class: 'brand', href: '/', title: 'All runs'}, h('img', {src: icon(), alt: 'All runs', width: 22, height: 22})),
    h('h1', {class: 'unseen'}, 'Conversation with the avatar'), mode, seconds, state, watching,
    h('div', {class: 'transport'}, recording && [pause, end], speak || null, map,
      button('Save as test', 'Keeps this conversation as a test', act.save, {'data-testid': 'live-save'}),
      h('a', {class: 'button', href: `/r/${encodeURIComponent(run)}`, target: '_blank', 'data-testid': 'live-inspect', title: 'Opens the inspector beside this page'}, 'Inspect'),
      button('?', 'Keys (?)', act.keys, {'aria-label': 'Keys (?)', 'data-testid': 'help'})));
  const put = (where, text) => { if (where.textContent !== text) where.textContent = text; };
  const timer = setInterval(() => put(seconds, clock(time())), tick_ms);
  return {
    element,
    /** What is known now: {live, running, viewers, state, mapped}. */
    render({live, running, viewers, state: now, mapped}) {
      mode.className = `badge ${live && running ? 'live' : ''}`;
      put(mode, live ? (running ? '● recording' : '⏸ paused') : 'ended');
      put(watching, viewers > 0 ? `${viewers} watching` : '');
      put(state, now ?? '');
      put(pause, running ? 'Pause' : 'Go on');
      pause.hidden = end.hidden = !live;
      map.setAttribute('aria-pressed', String(mapped));
      put(seconds, clock(time()));
    },
    withoutMap() { map.hidden = true; },
    close: () => clearInterval(timer),
  };
}
