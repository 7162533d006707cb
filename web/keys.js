// What the keys do: one table, which the keyboard and the help both read.
import {h} from './dom.js';

/** [keys as KeyboardEvent.key, as shown, what it does, (app, event) => …] */
export const keys = [
  [['ArrowLeft', 'ArrowRight'], '← →', 'previous, next stop (Shift: ten)', (app, {key, shiftKey}) => app.stepBy((key === 'ArrowLeft' ? -1 : 1) * (shiftKey ? 10 : 1))],
  [[',', '.'], ', .', 'previous, next transition', (app, {key}) => app.transitionBy(key === ',' ? -1 : 1)],
  [['Home', 'End'], 'Home End', 'first, last record', (app, {key}) => app.jump(key === 'Home' ? 0 : app.data.size - 1)],
  [['[', ']'], '[ ]', 'back to the cause, on to the first effect', (app, {key}) => app.follow(key === '[')],
  [[' '], 'Space', 'play, pause', (app) => app.play()],
  [['w', 's'], 'W S', 'zoom the timeline in, out', (app, {key}) => app.lanes.zoomBy(key === 'w' ? 0.6 : 1 / 0.6)],
  [['a', 'd'], 'A D', 'move the timeline', (app, {key}) => app.lanes.panBy(key === 'a' ? -0.25 : 0.25)],
  [['0'], '0', 'the whole run', (app) => app.lanes.all()],
  [['f'], 'F', 'fit the state graph', (app) => app.graph.fit()],
  [['g'], 'G', 'enlarge the state graph', (app) => app.graph.enlarge()],
  [['/'], '/', 'filter the records', (app) => app.records.focusFilter()],
  [['l'], 'L', 'copy a link to this instant', (app) => app.copyLink()],
  [['t'], 'T', 'light or dark', (app) => app.toggleTheme()],
  [['?'], '?', 'this help', (app) => app.help()],
];

/** Does what the key says; keys typed into a field, or with Ctrl, Alt or Meta, are left alone. */
export function onKey(app, event) {
  if (event.ctrlKey || event.altKey || event.metaKey || event.defaultPrevented) return;
  const target = event.target;
  if (target.closest?.('input:not([type=checkbox]), select, textarea, dialog')) return;
  if ((event.key === ' ' || event.key === 'Enter') && target.closest?.('button, a, summary, input')) return;
  const row = keys.find(([names]) => names.includes(event.key.length === 1 ? event.key.toLowerCase() : event.key));
  if (!row) return;
  event.preventDefault();
  row[3](app, event);
}

export function helpDialog() {
  const dialog = h('dialog', {class: 'help', 'aria-label': 'Keys', 'data-testid': 'keys', onclick: (event) => { if (event.target === dialog) dialog.close(); }},
    h('h2', {}, 'Keys'),
    h('dl', {}, keys.map(([, names, what]) => [h('dt', {}, names.split(' ').map((name) => h('kbd', {}, name))), h('dd', {}, what)])),
    h('p', {class: 'muted'}, 'On the timeline: wheel zooms, drag moves, click goes there; drag along the top to scrub. ',
      'In the graph: wheel zooms, drag moves, a click on a state goes to its next visit.'),
    h('form', {method: 'dialog'}, h('button', {autofocus: true}, 'Close')));
  return dialog;
}
