// The keys of a run's page: one table, which the keyboard and the help both read.
import {dialog, h} from './dom.js';
import {copyLink} from './announce.js';
import {toggleTheme} from './theme.js';

/** [keys as KeyboardEvent.key, as shown, effect in words, (page, {key, shift}) => …]; `page`: a RunPage. */
export const keys = [
  [
    ['ArrowLeft', 'ArrowRight'],
    '← →',
    'previous, next stop (Shift: ten)',
    (page, {key, shift}) => page.cursor.stepBy((key === 'ArrowLeft' ? -1 : 1) * (shift ? 10 : 1)),
  ],
  [[',', '.'], ', .', 'previous, next transition', (page, {key}) => page.cursor.transitionBy(key === ',' ? -1 : 1)],
  [
    ['n', 'p'],
    'N P',
    'next, previous difference, refusal, unmet expectation or answer that was recorded otherwise',
    (page, {key}) => page.next(key === 'n' ? 1 : -1),
  ],
  [
    ['Home', 'End'],
    'Home End',
    'first, last record',
    (page, {key}) => page.cursor.jump(key === 'Home' ? 0 : page.data.size - 1),
  ],
  [['[', ']'], '[ ]', 'back to the cause, on to the first effect', (page, {key}) => page.cursor.follow(key === '[')],
  [[], 'Alt+↑ Alt+↓', 'the derivation in words, as λ-terms, as continuations', () => {}],
  [[], 'Alt+← Alt+→', 'work its term out, step by step', () => {}],
  [['y'], 'Y', 'why: the record in full', (page) => page.showTab('why')],
  [[' ', 'k'], 'Space', 'play, pause', (page) => page.cursor.play()],
  [
    ['w', 's'],
    'W S',
    'zoom the timeline in, out',
    (page, {key}) => page.parts.lanes.zoomBy(key === 'w' ? 0.6 : 1 / 0.6),
  ],
  [['a', 'd'], 'A D', 'move the timeline', (page, {key}) => page.parts.lanes.panBy(key === 'a' ? -0.25 : 0.25)],
  [['0'], '0', 'the whole run', (page) => page.parts.lanes.all()],
  [['g'], 'G', 'idle time short or at full length', (page) => page.model.go({gaps: !page.model.selection.gaps})],
  [['f'], 'F', 'fit the state graph', (page) => page.parts.graph.fit()],
  [
    ['1', '2', '3', '4', '5', '6', '7', '8', '9'],
    '1 – 9',
    'to a panel; again: let it fill the page',
    (page, {key}) => page.focusPanel(Number(key) - 1),
  ],
  [['Escape'], 'Esc', 'all panels again', (page) => page.model.go({panel: ''})],
  [
    ['b'],
    'B',
    'the next of several configurations (Shift: the one before)',
    (page, {shift}) => {
      page.showTab('branches');
      page.parts.branches?.cycle(shift ? -1 : 1);
    },
  ],
  [
    ['/'],
    '/',
    'filter the records',
    (page) => {
      page.showTab('records');
      page.parts.records.focusFilter();
    },
  ],
  [
    ['#'],
    '# Ctrl+K',
    'go to a record, an instant, a state, a panel or a run; or do something by its name',
    (page) => page.dialogs.go_to.open(),
  ],
  [['c'], 'C', 'compare with another run', (page) => page.dialogs.compare.open()],
  [['x'], 'X', 'what if?', (page) => page.dialogs.what_if.open()],
  [
    ['m'],
    'M',
    'a note here (Shift: from here)',
    (page, {shift}) => {
      page.showTab('notes');
      if (shift) page.parts.notes.mark();
      else page.parts.notes.write();
    },
  ],
  [['l'], 'L', 'copy a link to this instant', () => copyLink()],
  [['t'], 'T', 'light or dark', () => toggleTheme()],
  [['?'], '?', 'this help', (page) => page.dialogs.help.open()],
];
const inspecting =
  'On the timeline: wheel zooms, drag moves, with Shift it selects a stretch, click goes there; drag along the top to scrub. ' +
  'In the graph: wheel zooms, drag moves, a click on a state goes to its next visit. ' +
  'In the scene: drag or the arrow keys turn (with Shift: move), wheel, + and − approach.';

/** Hands the key to the page; keys typed into a field, or with Ctrl, Alt or Meta, are left alone. */
export function onKey(page, event) {
  if (
    (event.ctrlKey || event.metaKey) &&
    event.key === 'k' &&
    page.dialogs &&
    !document.querySelector('dialog[open]')
  ) {
    event.preventDefault();
    page.dialogs.go_to.open();
    return;
  }
  if (event.ctrlKey || event.altKey || event.metaKey || event.defaultPrevented) return;
  const target = event.target;
  if (target.closest?.('input:not([type=checkbox]), select, textarea, dialog')) return;
  if ((event.key === ' ' || event.key === 'Enter') && target.closest?.('button, a, summary, input')) return;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (page.onKey(key, event.shiftKey)) event.preventDefault();
}

/** `rows`: as in `keys`; `more`: the uses of the mouse. */
export function helpDialog(rows = keys, more = inspecting) {
  const element = dialog(
    {class: 'dialog help', 'aria-label': 'Keys', 'data-testid': 'keys'},
    h('h2', {}, 'Keys'),
    h(
      'dl',
      {},
      rows.map(([, names, what]) =>
        h(
          'div',
          {},
          h(
            'dt',
            {},
            names.split(' ').map((name) => (name === '–' ? ' – ' : h('kbd', {}, name))),
          ),
          h('dd', {}, what),
        ),
      ),
    ),
    h('p', {class: 'muted'}, more),
    h('form', {method: 'dialog'}, h('button', {autofocus: true}, 'Close')),
  );
  return {element, open: () => element.showModal()};
}
