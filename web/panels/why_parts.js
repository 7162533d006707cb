// The sections of the panel "Why": each takes part of the server's explanation and gives elements, or false for an empty
// part. `to(n, words)`: a link to record n.
import {h, brief, instant, shown, text} from '../dom.js';
import {walk} from '../terms/derivation.js';
import {likelihoods} from '../terms/record_views.js';
import {operationWords} from '../terms/stack_words.js';

const refused_shown = 2; // of the decision; the rest is in the list of all

export const listOf = (value) => (Array.isArray(value) ? value.filter((one) => one && typeof one === 'object') : []);

const section = (title, ...content) => [h('h3', {}, title), ...content];
/** A section that is folded unless `open`. */
export const folded = (summary, testid, open, ...content) =>
  h('details', {open, 'data-testid': testid}, h('summary', {}, summary), ...content);
const bullets = (items) => h('ul', {class: 'candidates'}, items);
const applications = (items) => h('ol', {class: 'applications'}, items);
const names = (values) => [values].flat().map(text).join(', ');
// "one step", "3 steps"
const howMany = (number, one) => (number === 1 ? `one ${one}` : `${number} ${one}s`);
const refusal = ({ids, reason}) => h('li', {}, h('b', {}, names(ids)), ' ', h('span', {class: 'term'}, shown(reason)));

function reference({n, t, kind, brief, told = brief}, to) {
  const time = Number.isFinite(t) ? h('span', {class: 't'}, ` ${instant(t)}`) : '';
  const title = brief === undefined || told === brief ? null : shown(brief);
  const what = kind === 'application' ? h('span', {class: 'term'}, shown(told)) : shown(told);
  const words = h('span', {title}, to(n, [h('b', {}, kind), ' ', what]), time);
  return h('li', {class: `kind-${kind}`}, h('span', {class: 'n'}, `#${n}`), ' ', words);
}
const chain = (records, testid, to) =>
  h(
    'ol',
    {class: 'chain', 'data-testid': testid},
    records.map((one) => reference(one, to)),
  );

/** The members of record n that the server tells in words: name -> words, or the same with words in it. */
export function membersInWords({act, inputs}, n) {
  const of_act = listOf(act?.records).find((one) => one.n === n);
  const of_input = listOf(inputs).find((one) => one.n === n);
  const readings = listOf(inputs).flatMap((input) => listOf(input.readings));
  const {resolved, ruled_out} = readings.find((one) => one.n === n) ?? {};
  return {
    ...(of_act && {program: of_act.told}),
    ...(of_input && {event: of_input.told}),
    ...(resolved && {resolved}),
    ...(ruled_out && {ruled_out}),
  };
}

export function causes({chain: links}, to) {
  const others = listOf(links).slice(1);
  const none = h('p', {class: 'muted'}, 'Nothing else in the log brought this about.');
  return section('Why', others.length ? chain(others, 'why', to) : none);
}

// The words of some records begin with their kind, which stands before them anyway.
const withoutKind = ({told, kind}) => (told.startsWith(`${kind} `) ? told.slice(kind.length + 1) : told);

export function contributors({inputs}, to) {
  const told = listOf(inputs).map((one) => ({
    ...one,
    told: `${withoutKind(one)}${one.count > 1 ? `, ${one.count} samples` : ''}`,
    brief: undefined,
  }));
  return told.length > 0 && section('Who contributed', chain(told, 'inputs', to));
}

const spoken = (told, logged) => h('span', {title: told === logged ? null : text(logged)}, shown(told));

/** Who could have been meant and was not, in the readings that the record goes back to. */
export function ruledOut({inputs}, to, in_words) {
  const readings = listOf(inputs).flatMap((input) => listOf(input.readings));
  const all = readings
    .flatMap((reading) => listOf(reading.resolved).map((one) => ({n: reading.n, ...one})))
    .filter((one) => listOf(one.ruled_out).length);
  if (!all.length) return false;
  const objects = new Set(all.flatMap((one) => listOf(one.ruled_out).map(({object}) => text(object))));
  const item = ({n, words, referents, value, told, ruled_out}) => {
    const named = told === undefined ? in_words.things(referents ?? value ?? 'nothing') : spoken(told, value);
    const meaning = [` “${text(words ?? '')}” means `, named];
    const others = listOf(ruled_out).map((one) => in_words.ruledOut(one));
    return [h('p', {class: 'note'}, to(n, `#${n}`), meaning), bullets(others)];
  };
  return folded(['Ruled out: ', in_words.things([...objects])], 'who-not', false, all.map(item));
}

/** The last transition before the record: its condition, the change of the stack, and the nearest that were refused. */
export function lastDecision({steps}, to) {
  const step = listOf(steps).at(-1);
  if (!step) return false;
  const {n, id, from, to: target, condition, operation, refused} = step;
  const others = listOf(refused);
  const rest = others.length - refused_shown;
  const line = (name, ...words) => [h('dt', {}, name), h('dd', {}, words)];
  return h(
    'dl',
    {class: 'decision', 'data-testid': 'decision'},
    line('decided', to(n, [h('b', {}, text(id)), ` ${text(from)} → ${text(target)}`])),
    condition && line('because', h('span', {class: 'term'}, brief(condition))),
    line('stack', operationWords(operation).what),
    others.length > 0 &&
      line('refused', bullets(others.slice(0, refused_shown).map(refusal)), rest > 0 && `and ${rest} more`),
  );
}

/** The transitions between the inputs and the record. */
export function decisions({steps: all, choice}, to) {
  const steps = listOf(all);
  if (!steps.length) return false;
  const summary = `Decided in ${howMany(steps.length, 'step')}${choice ? `, ${text(choice)}` : ''}`;
  return folded(summary, 'decided', false, applications(steps.map((one) => decision(one, to))));
}
function decision({n, id, from, to: target, condition, candidates, refused}, to) {
  const number = h('span', {class: 'n'}, `#${n}`);
  const likely = likelihoods(listOf(candidates));
  const rivals = listOf(candidates).map((one, i) => `${text(one.id)} (${likely[i]})`);
  const others = listOf(refused);
  const count = others.reduce((sum, {ids}) => sum + (ids?.length ?? 1), 0);
  return h(
    'li',
    {},
    to(n, [number, ' ', h('b', {}, text(id)), ` ${text(from)} → ${text(target)}`]),
    condition && h('span', {class: 'term'}, ` if ${shown(condition)}`),
    rivals.length > 1 && h('p', {class: 'note'}, `among ${rivals.join(', ')}`),
    others.length > 0 && h('details', {}, h('summary', {}, `refused: ${count}`), bullets(others.map(refusal))),
  );
}

export function refusals({refused}) {
  const all = listOf(refused);
  return all.length > 0 && folded('Why no transition took it', 'refused-all', true, bullets(all.map(refusal)));
}

/** The applications that built the record's term. */
export function built({derivation}, to) {
  const all = walk(derivation).filter(({node}) => node.how === 'application' && Number.isInteger(node.n));
  if (!all.length) return false;
  const typed = ({term, type}) => [
    h('span', {class: 'term'}, shown(term)),
    type && h('span', {class: 'type'}, ` : ${type}`),
  ];
  const item = ({node}) =>
    h(
      'li',
      {},
      to(node.n, `#${node.n}`),
      ' ',
      typed(node),
      node.rule && ` raised by ${text(node.rule)}`,
      bullets(listOf(node.children).map((child) => h('li', {}, typed(child)))),
    );
  return folded(`Built from ${howMany(all.length, 'application')}`, 'derivation', false, applications(all.map(item)));
}

/** The choices with the smallest margins. */
export function fragile({fragile: margins}, to) {
  const items = listOf(margins).map(({n, margin}) => h('li', {}, to(n, `#${n}`), ` margin ${text(margin)}`));
  return items.length > 0 && section('Next to nothing could have changed', bullets(items));
}

export function effects({brought_about, along}, to) {
  const led = listOf(brought_about);
  const others = listOf(along);
  return [
    led.length > 0 && section('What came of it', chain(led, 'effects', to)),
    others.length > 0 && folded('What came along with it', 'along', false, chain(others, 'along-list', to)),
  ];
}

export function actRecords({act}, to) {
  const records = listOf(act?.records).map((one) => ({
    ...one,
    kind: 'act',
    brief: `${text(one.status)} ${text(one.program)}`,
    told: `${text(one.status)} ${text(one.told ?? one.program)}`,
  }));
  if (!records.length) return false;
  return folded(
    `How the act went: ${text(act.outcome ?? 'not ended')}`,
    'act',
    false,
    chain(records, 'act-records', to),
  );
}
