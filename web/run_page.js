// The page of a run, or of two that are compared: its panels and where they stand.
import {h, tabs} from './dom.js';
import {helpDialog} from './keys.js';
import {compareDialog} from './panels/compare.js';
import {goToDialog} from './panels/go_to.js';
import {whatIfDialog} from './panels/what_if.js';
import {mountHeader} from './panels/header.js';
import {mountDialogue} from './panels/dialogue.js';
import {mountGraph} from './panels/graph.js';
import {mountScene} from './panels/scene.js';
import {mountStack} from './panels/stack.js';
import {mountDerivation} from './panels/derivation.js';
import {mountLanes} from './panels/lanes.js';
import {mountRecords} from './panels/records.js';
import {mountWhy} from './panels/why.js';
import {hasBranches, mountBranches} from './panels/branches.js';
import {mountNotes} from './panels/notes.js';
import {mountDifferences} from './panels/differences.js';
import {keepMarked, otherSide} from './panels/side_by_side.js';

// What a page that is built anew, for a run that has grown, takes over: a scene is dear, a note may be half written.
const lasting = ['scene', 'notes'];

/** Puts the page into `host`. @returns what the app keeps of it. `before`: what it kept of the page that this replaces. */
export function buildRunPage(host, app, before = null) {
  const focused = document.activeElement?.closest?.('.panel')?.dataset.panel;
  for (const [name, one] of Object.entries(before?.parts ?? {})) if (!lasting.includes(name)) one.close?.();
  const {comparison} = app;
  const header = h('header', {class: 'top'});
  const parts = {
    dialogue: mountDialogue(app), graph: mountGraph(app), scene: before?.parts.scene ?? mountScene(app, {other: comparison && otherRun(comparison, app)}), lanes: mountLanes(app, comparison),
    stack: mountStack(app), derivation: mountDerivation(app), why: mountWhy(app), records: mountRecords(app), notes: before?.parts.notes ?? mountNotes(app),
    ...hasBranches(app.data) && {branches: mountBranches(app)},
    ...comparison && {differences: mountDifferences(app), ...otherSide(app)},
  };
  if (comparison) for (const name of ['stack', 'derivation']) parts[name].element.querySelector('h2').textContent += ' A';
  if (comparison) keepMarked(parts.stack.element, parts.stack_b.element, '.cell');
  if (comparison) keepMarked(parts.derivation.element, parts.derivation_b.element, '.node-line');
  const dialogs = before?.dialogs ?? {help: helpDialog(), compare: compareDialog(app), go_to: goToDialog(app), what_if: whatIfDialog(app)};
  const element = (name) => parts[name].element;
  const shared = [...comparison ? ['differences', 'derivation', 'derivation_b'] : [], 'why', 'records', 'notes', ...parts.branches ? ['branches'] : []];
  const more = tabs('more', shared.map(element), (panel) => app.model.go({tab: panel}));
  const main = h('main', {class: comparison ? 'run compared' : 'run'},
    h('div', {class: 'upper'}, element('dialogue'), element('graph'), element('scene')),
    element('lanes'),
    h('div', {class: 'lower'}, element('stack'), element(comparison ? 'stack_b' : 'derivation'), more.element));
  host.replaceChildren(header, main, ...Object.values(dialogs).map((one) => one.element));

  if (before && focused && !host.contains(document.activeElement)) parts[focused]?.element.querySelector('[tabindex="0"]')?.focus();

  // One panel may fill the page; the others then wait out of sight.
  const frame = {
    render({panel, tab}) {
      more.show(parts[panel] && more.has(panel) ? panel : tab);
      main.classList.toggle('one', Boolean(parts[panel]));
      for (const [name, part] of Object.entries(parts)) {
        const large = name === panel;
        part.element.classList.toggle('enlarged', large);
        part.element.querySelector('.larger')?.setAttribute('aria-pressed', String(large));
      }
    },
  };
  return {...parts, parts, dialogs, panels: [frame, mountHeader(header, app), ...Object.values(parts)]};
}

/** The other run as the scene shows it: where its bodies were at what belongs to record n of this one. */
function otherRun(comparison, app) {
  const {client, data} = comparison.side;
  return {client, timeOf: (n) => data.t[comparison.otherOf({n, hunk: app.model.selection.hunk})]};
}
