// The panels of a run, or of two that are compared, and where they stand.
import {h, clock, tabs} from './dom.js';
import {copy} from './announce.js';
import {download} from './download.js';
import {helpDialog} from './keys.js';
import {compareDialog} from './panels/compare.js';
import {whatIfDialog} from './panels/what_if.js';
import {mountHeader} from './panels/header.js';
import {mountDialogue} from './panels/dialogue.js';
import {mountDialoguePair} from './panels/dialogue_pair.js';
import {mountGraph} from './panels/graph.js';
import {mountScene} from './panels/scene.js';
import {mountStack} from './panels/stack.js';
import {mountDerivation} from './panels/derivation.js';
import {mountLanes} from './panels/lanes.js';
import {mountRecords} from './panels/records.js';
import {mountWhy} from './panels/why.js';
import {hasBranches, mountBranches} from './panels/branches.js';
import {paletteDialog} from './panels/palette.js';
import {mountMedia} from './panels/media.js';
import {mountAccount} from './panels/account.js';
import {mountNotes} from './panels/notes.js';
import {mountDifferences} from './panels/differences.js';
import {keepMarked, otherSide} from './panels/side_by_side.js';
import {served} from './run/run_client.js';
import {splitter} from './splitters.js';

// A page that is built anew, for a run that has grown, keeps these: a scene is slow to load, a note may be half written.
const lasting = ['scene', 'notes'];

/**
 * Mounts the panels of `page`, a RunPage, and places them in `host`. `before`: the page with the panels that these
 * replace, or null. @returns {parts, dialogs, panels} as RunPage keeps them
 */
export function buildPanels(host, page, before = null) {
  const focused = document.activeElement?.closest?.('.panel')?.dataset.panel;
  for (const [name, one] of Object.entries(before?.parts ?? {})) if (!lasting.includes(name)) one.close?.();
  const parts = mountAll(page, before);
  const dialogs = before?.dialogs ?? mountDialogs(page);
  const header = h('header', {class: 'top'});
  const more = tabs('more', inTabs(page, parts), (panel) => page.model.go({tab: panel}));
  const main = placed(page, parts, more);
  host.replaceChildren(header, main, ...Object.values(dialogs).map((one) => one.element));
  if (before && focused && !host.contains(document.activeElement))
    parts[focused]?.element.querySelector('[tabindex="0"]')?.focus();
  const panels = [frameOf(main, parts, more), mountHeader(header, page, dialogs), ...Object.values(parts)];
  return {parts, dialogs, panels};
}

function mountAll(page, before) {
  const {data, client, model, cursor, comparison} = page;
  const {jump} = cursor;
  const parts = {
    dialogue: comparison ? mountDialoguePair({comparison, jump}) : mountDialogue({data, client, jump}),
    graph: mountGraph({data, client, model, cursor, comparison}),
    scene:
      before?.parts.scene ??
      mountScene({
        client,
        cursor,
        other: comparison && otherRun(comparison, model),
        elsewhere: served && !comparison ? (asked) => page.dialogs.what_if.open(asked) : null,
      }),
    lanes: mountLanes({
      data,
      model,
      cursor,
      comparison,
      note: (records) => noteOn(page, records),
      save: (span) => saveStretch(page, span),
    }),
    stack: mountStack({data, client, model, jump}),
    derivation: mountDerivation({client, model, jump}),
    why: mountWhy({data, client, jump}),
    account: mountAccount({client, jump}),
    records: mountRecords({data, client, model, cursor}),
    notes: before?.parts.notes ?? mountNotes({client, cursor, marked: (spans) => page.parts?.lanes.showNotes(spans)}),
    ...(data.media.length && {
      media: mountMedia({media: data.media, client, cursor, heard: () => page.parts?.lanes.labelsArrived()}),
    }),
    ...(hasBranches(data) && {branches: mountBranches({client, model})}),
    ...(comparison && {differences: mountDifferences({comparison, model, jump, copy})}),
  };
  return comparison ? withOtherSide(parts, page) : parts;
}

// Begins a note on the stretch between two records.
function noteOn(page, [from, to]) {
  page.showTab('notes');
  page.cursor.jump(from);
  page.parts.notes.mark(from);
  page.cursor.jump(to);
  page.parts.notes.write();
}

// Hands over the records of a stretch of time as a file whose name tells the times: talk_0m12.50s-0m20.00s.jsonl.
async function saveStretch({client, title}, span) {
  const times = span.map((t) => `${clock(t, 2).replace(':', 'm')}s`).join('-');
  download(await client.linesOf(span), `${title.replaceAll('/', '_')}_${times}.jsonl`, 'application/jsonl');
}

// The panels of B next to those of A, each with its differences from the other marked.
function withOtherSide(parts, {comparison, model, cursor}) {
  const both = {...parts, ...otherSide({comparison, model, jump: cursor.jump})};
  for (const [name, selector] of [
    ['stack', '.cell'],
    ['derivation', '.node-line'],
  ]) {
    both[name].element.querySelector('h2').textContent += ' A';
    keepMarked(both[name].element, both[`${name}_b`].element, selector);
  }
  return both;
}

const mountDialogs = (page) => ({
  help: helpDialog(),
  compare: compareDialog(page),
  go_to: paletteDialog(() => page),
  what_if: whatIfDialog(page),
});

// The panels that share a place.
const inTabs = ({comparison}, parts) =>
  [
    ...(comparison ? ['differences', 'derivation', 'derivation_b'] : []),
    ...['why', 'account', 'records', 'notes'],
    ...['media', 'branches'].filter((name) => parts[name]),
  ].map((name) => parts[name].element);

function placed({comparison}, parts, more) {
  const element = (name) => parts[name].element;
  const bars = [];
  const between = (name, panel, along, sense, label = panel.getAttribute('aria-label')) => {
    const one = splitter({main: () => main, panel: () => panel, label, name, along, sense});
    bars.push(one);
    return one.bar;
  };
  const [dialogue, graph, scene, lanes, stack] = ['dialogue', 'graph', 'scene', 'lanes', 'stack'].map(element);
  const upper = h('div', {class: 'upper'});
  upper.append(dialogue, between('dialogue-width', dialogue, 'width', 1), graph);
  upper.append(between('scene-width', scene, 'width', -1), scene);
  const lower = h('div', {class: 'lower'});
  lower.append(stack, between('stack-width', stack, 'width', 1), element(comparison ? 'stack_b' : 'derivation'));
  lower.append(between('tabs-width', more.element, 'width', -1, 'the tabs'), more.element);
  const main = h(
    'main',
    {class: comparison ? 'run compared' : 'run'},
    [upper, between('upper-height', upper, 'height', 1, 'the upper panels'), lanes],
    [between('lanes-height', lanes, 'height', 1), lower],
  );
  requestAnimationFrame(() => bars.forEach(({show}) => show()));
  return main;
}

// One panel may fill the page; the others then wait out of sight.
const frameOf = (main, parts, more) => ({
  render({panel, tab}) {
    more.show(parts[panel] && more.has(panel) ? panel : tab);
    main.classList.toggle('one', Boolean(parts[panel]));
    for (const [name, part] of Object.entries(parts)) {
      const large = name === panel;
      part.element.classList.toggle('enlarged', large);
      part.element.querySelector('.larger')?.setAttribute('aria-pressed', String(large));
    }
  },
});

/** The other run as the scene shows it: its bodies at the counterpart of record n of this run. */
function otherRun(comparison, model) {
  const {client, data} = comparison.side;
  return {client, timeOf: (n) => data.t[comparison.otherOf({n, hunk: model.selection.hunk})]};
}
