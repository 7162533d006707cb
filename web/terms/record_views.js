// A record in full: what its kind has to show, and any kind field by field.
import {h, shown, text} from '../dom.js';

const line = (name, ...value) => h('div', {class: 'field'}, h('dt', {}, name), h('dd', {}, ...value));
const listOf = (value) => (Array.isArray(value) ? value : []);
const objectsOf = (value) => listOf(value).filter((one) => one && typeof one === 'object');

function objectText(value) {
  if (value === null || typeof value !== 'object') return text(value);
  if (Array.isArray(value)) return value.some((one) => one && typeof one === 'object') ? value.map(objectText).join('; ') : text(value);
  return Object.entries(value).map(([key, inner]) => `${key} ${objectText(inner)}`).join(', ');
}

function operationText(operation) {
  if (typeof operation !== 'object' || operation === null) return text(operation);
  return Object.entries(operation).map(([name, value]) => (value === null || value === true || value === '' ? name : `${name} ${objectText(value)}`)).join(', ');
}

const chosenMark = () => h('span', {class: 'yes'}, ' taken');

/** The transitions that were refused, with what refused them, under a heading that opens. */
export const refusals = (refused, open = false) => objectsOf(refused).length > 0 &&
  h('details', {open, 'data-testid': 'refused'}, h('summary', {}, `${refused.length} refused`),
    h('ul', {class: 'candidates'}, objectsOf(refused).map((one) => h('li', {}, h('b', {}, text(one.id ?? '?')), ' ', shown(one.reason)))));

function transitionFields(record) {
  const candidates = objectsOf(record.candidates), gates = objectsOf(record.gates);
  const fields = [
    line('input', record.input === null || record.input === undefined ? 'ε' : text(record.input)),
    line('operation', operationText(record.operation)),
    line('taken', h('b', {}, text(record.id)), record.forced === true ? ', forced' : '',
      candidates.length > 1 ? `, one of ${candidates.length} applicable` : ', the only one applicable',
      record.draw === null || record.draw === undefined ? '' : `, draw ${text(record.draw)}`),
  ];
  if (Number.isFinite(record.probability) && record.probability < 1) fields.push(line('probability', text(record.probability)));
  for (const gate of gates)
    fields.push(line('gate', `${text(gate.state)}: ${shown(gate.condition)} `, h('b', {class: gate.passed ? 'yes' : 'no'}, gate.passed ? 'passed' : 'not passed')));
  if (record.margin !== null && record.margin !== undefined) fields.push(line('margin', text(record.margin)));
  return [h('dl', {}, fields),
    candidates.length > 1 && h('details', {open: true}, h('summary', {}, `${candidates.length} applicable`),
      h('ul', {class: 'candidates'}, candidates.map((one) =>
        h('li', {class: one.id === record.id ? 'taken' : null}, h('b', {}, text(one.id)), ` weight ${text(one.weight)}`, one.id === record.id && chosenMark())))),
    refusals(record.refused, candidates.length < 2)];
}

function refusalFields(record) {
  return [h('dl', {}, line('state', text(record.state ?? null)), line('input', text(record.input ?? null)), line('reason', shown(record.reason))), refusals(record.refused, true)];
}

function applicationFields(record) {
  const types = record.types ?? {};
  const part = (name) => line(name, h('span', {class: 'term'}, shown(record[name])), types[name] && h('span', {class: 'type'}, ` : ${types[name]}`));
  return h('dl', {}, part('function'), part('argument'), part('result'), record.rule && line('raised by', text(record.rule)));
}

const whyMissing = {unsaid: 'not said', several: 'may be', none: 'there is none'};
const names = (value) => listOf(value).map((one) => text(one)).join(', ');

function readingFields(record) {
  const fields = [];
  const term = (name, value, type) => fields.push(line(name, h('span', {class: 'term'}, shown(value)), type && h('span', {class: 'type'}, ` : ${type}`)));
  fields.push(line('move', text(record.move ?? 'not understood')));
  if (record.words) fields.push(line('words', `“${record.words}”`));
  if (record.reading) term('says', record.reading);
  if (record.meaning) term('means', record.meaning, record.type);
  for (const gap of objectsOf(record.missing))
    fields.push(line('missing', `${text(gap.type)}${gap.words ? `, “${gap.words}”` : ''}: ${whyMissing[gap.why] ?? text(gap.why ?? '')} ${names(gap.choices)}`));
  if (record.referents) fields.push(line('referents', names(record.referents) || 'none'));
  for (const words of ['unknown', 'unused']) if (record[words]) fields.push(line(`${words} words`, names(record[words])));
  const ruledOut = (one) => h('ul', {class: 'candidates', 'data-testid': 'ruled-out'}, objectsOf(one.ruled_out).map((each) => h('li', {}, h('b', {}, text(each.object)), ' ruled out: ', shown(each.reason))));
  const phrases = [...objectsOf(record.resolved), ...(record.ruled_out ? [{words: 'pointing', by: 'pointed', referents: record.referents, ruled_out: record.ruled_out}] : [])];
  return [h('dl', {}, fields),
    phrases.map((one) => h('details', {open: phrases.length < 3, 'data-testid': 'resolved'},
      h('summary', {}, `“${one.words || shown(one.phrase)}” `, h('b', {}, one.referents ? names(one.referents) || 'nothing' : shown(one.value)), ` by ${text(one.by ?? '?')}`),
      objectsOf(one.ruled_out).length > 0 && ruledOut(one))),
    objectsOf(record.parses).length > 1 && h('details', {}, h('summary', {}, `${record.parses.length} readings`),
      h('ol', {class: 'candidates'}, objectsOf(record.parses).map((one, rank) =>
        h('li', {class: rank === record.rank ? 'taken' : null}, h('span', {class: 'term'}, shown(one.reading)), ` ${text(one.category)}, cost ${text(one.cost)}`, rank === record.rank && chosenMark()))))];
}

const most_letters = 2000;

/** Whatever the log says, field by field: what every kind that has no view of its own gets. */
export function plainFields(record, without = ['kind', 'n', 't', 'cause', 'because', 'refused']) {
  const fields = [];
  for (const [key, value] of Object.entries(record)) {
    if (without.includes(key) || value === undefined) continue;
    const letters = JSON.stringify(value).length;
    fields.push(line(key, letters > most_letters ? `${objectText(value).slice(0, most_letters)}… (${letters} letters)` : objectText(value)));
  }
  return h('dl', {}, fields);
}

const views = {transition: transitionFields, application: applicationFields, reading: readingFields, refusal: refusalFields};

/** What the record's kind has to show; nothing where the sentence above says it all. */
export function recordView(record) {
  if (record.kind === 'utterance' || record.kind === 'gesture') return null;
  return views[record.kind]?.(record) ?? [plainFields(record), refusals(record.refused)];
}
