// What the keys do: one table, which the keyboard and the help both read.
import {h} from './dom.js';

/** [keys as KeyboardEvent.key, as shown, what it does, (app, event) => …] */
export const keys = [
  [['ArrowLeft', 'ArrowRight'], '← →', 'previous, next stop (Shift: ten)', (app, {key, shiftKey}) => app.stepBy((key === 'ArrowLeft' ? -1 : 1) * (shiftKey ? 10 : 1))],
  [[',', '.'], ', .', 'previous, next transition', (app, {key}) => app.transitionBy(key === ',' ? -1 : 1)],
  [['n', 'p'], 'N P', 'next, previous difference, refusal or unmet expectation', (app, {key}) => app.next(key === 'n' ? 1 : -1)],
  [['Home', 'End'], 'Home End', 'first, last record', (app, {key}) => app.jump(key === 'Home' ? 0 : app.data.size - 1)],
  [['[', ']'], '[ ]', 'back to the cause, on to the first effect', (app, {key}) => app.follow(key === '[')],
  [[], 'Alt+↑ Alt+↓', 'the derivation in words, as λ-terms, as continuations', () => {}],
  [[], 'Alt+← Alt+→', 'work its term out, step by step', () => {}],
  [['y'], 'Y', 'why: the record in full', (app) => app.showTab('why')],
  [[' ', 'k'], 'Space', 'play, pause', (app) => app.play()],
  [['w', 's'], 'W S', 'zoom the timeline in, out', (app, {key}) => app.lanes.zoomBy(key === 'w' ? 0.6 : 1 / 0.6)],
  [['a', 'd'], 'A D', 'move the timeline', (app, {key}) => app.lanes.panBy(key === 'a' ? -0.25 : 0.25)],
  [['0'], '0', 'the whole run', (app) => app.lanes.all()],
  [['g'], 'G', 'idle time short or at full length', (app) => app.model.go({gaps: !app.model.selection.gaps})],
  [['f'], 'F', 'fit the state graph', (app) => app.graph.fit()],
  [['1', '2', '3', '4', '5', '6', '7', '8', '9'], '1 – 9', 'to a panel; again: let it fill the page', (app, {key}) => app.focusPanel(Number(key) - 1)],
  [['Escape'], 'Esc', 'all panels again', (app) => app.model.go({panel: ''})],
  [['b'], 'B', 'the next of several configurations (Shift: the one before)', (app, {shiftKey}) => { app.showTab('branches'); app.branches?.cycle(shiftKey ? -1 : 1); }],
  [['/'], '/', 'filter the records', (app) => { app.showTab('records'); app.records.focusFilter(); }],
  [['#'], '#', 'go to a record, an instant or a state', (app) => app.dialogs.go_to.open()],
  [['c'], 'C', 'compare with another run', (app) => app.dialogs.compare.open()],
  [['x'], 'X', 'what if?', (app) => app.dialogs.what_if.open()],
  [['m'], 'M', 'a note here (Shift: from here)', (app, {shiftKey}) => { app.showTab('notes'); if (shiftKey) app.notes.mark(); else app.notes.write(); }],
  [['l'], 'L', 'copy a link to this instant', (app) => app.copyLink()],
  [['t'], 'T', 'light or dark', (app) => app.toggleTheme()],
  [['?'], '?', 'this help', (app) => app.dialogs.help.open()],
];
const inspecting = 'On the timeline: wheel zooms, drag moves, click goes there; drag along the top to scrub. ' +
  'In the graph: wheel zooms, drag moves, a click on a state goes to its next visit. ' +
  'In the scene: drag or the arrow keys turn (with Shift: move), wheel, + and − approach.';
const on_start = ['/', 't', '?'];  // what keys do where runs are listed

/** Does what the key says; keys typed into a field, or with Ctrl, Alt or Meta, are left alone. */
export function onKey(app, event) {
  if (event.ctrlKey || event.altKey || event.metaKey || event.defaultPrevented) return;
  const target = event.target;
  if (target.closest?.('input:not([type=checkbox]), select, textarea, dialog')) return;
  if ((event.key === ' ' || event.key === 'Enter') && target.closest?.('button, a, summary, input')) return;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (app.live_page) {
    if (app.live_page.onKey(key)) event.preventDefault();
    return;
  }
  if (!app.data && !(app.start && on_start.includes(key))) return;
  const row = keys.find(([names]) => names.includes(key));
  if (!row) return;
  event.preventDefault();
  if (app.start) app.start.onKey(key); else row[3](app, {key, shiftKey: event.shiftKey});
}

/** `rows`: as in `keys`; `more`: what the mouse does. */
export function helpDialog(rows = keys, more = inspecting) {
  const element = h('dialog', {class: 'dialog help', 'aria-label': 'Keys', 'data-testid': 'keys', onclick: (event) => { if (event.target === element) element.close(); }},
    h('h2', {}, 'Keys'),
    h('dl', {}, rows.map(([, names, what]) => h('div', {}, h('dt', {}, names.split(' ').map((name) => (name === '–' ? ' – ' : h('kbd', {}, name)))), h('dd', {}, what)))),
    h('p', {class: 'muted'}, more),
    h('form', {method: 'dialog'}, h('button', {autofocus: true}, 'Close')));
  return {element, open: () => element.showModal()};
}
