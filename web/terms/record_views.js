// A record in full: the view of its kind, and any kind field by field.
import {h, shown, text} from '../dom.js';

const line = (name, ...value) => h('div', {class: 'field'}, h('dt', {}, name), h('dd', {}, ...value));
const listOf = (value) => (Array.isArray(value) ? value : []);
const objectsOf = (value) => listOf(value).filter((one) => one && typeof one === 'object');

function objectText(value) {
  if (value === null || typeof value !== 'object') return text(value);
  if (Array.isArray(value))
    return value.some((one) => one && typeof one === 'object') ? value.map(objectText).join('; ') : text(value);
  return Object.entries(value)
    .map(([key, inner]) => `${key} ${objectText(inner)}`)
    .join(', ');
}

function operationText(operation) {
  if (typeof operation !== 'object' || operation === null) return text(operation);
  return Object.entries(operation)
    .map(([name, value]) => (value === null || value === true || value === '' ? name : `${name} ${objectText(value)}`))
    .join(', ');
}

const chosenMark = () => h('span', {class: 'yes'}, ' taken');

/** The transitions that were refused, with what refused them, under a heading that opens. */
export const refusals = (refused, open = false) =>
  objectsOf(refused).length > 0 &&
  h(
    'details',
    {open, 'data-testid': 'refused'},
    h('summary', {}, `${refused.length} refused`),
    h(
      'ul',
      {class: 'candidates'},
      objectsOf(refused).map((one) =>
        h('li', {}, h('b', {}, text(one.id ?? '?')), ' ', h('span', {class: 'term'}, shown(one.reason))),
      ),
    ),
  );

/** The shares of the weights of rival transitions, in percent: how likely each was. */
export function likelihoods(candidates) {
  const total = candidates.reduce((sum, one) => sum + (one.weight ?? 0), 0);
  return candidates.map((one) => `${Number(((100 * (one.weight ?? 0)) / total).toPrecision(3))} %`);
}

function transitionFields(record) {
  const candidates = objectsOf(record.candidates);
  const likely = likelihoods(candidates);
  const gates = objectsOf(record.gates);
  const fields = [
    line('input', record.input === null || record.input === undefined ? 'ε' : text(record.input)),
    line('operation', h('span', {class: 'term'}, operationText(record.operation))),
    line(
      'taken',
      h('b', {}, text(record.id)),
      record.forced === true ? ', forced' : '',
      candidates.length > 1 ? `, one of ${candidates.length} applicable` : ', the only one applicable',
      record.draw === null || record.draw === undefined ? '' : `, draw ${text(record.draw)}`,
    ),
  ];
  if (Number.isFinite(record.probability) && record.probability < 1)
    fields.push(line('probability', text(record.probability)));
  for (const gate of gates)
    fields.push(
      line(
        'gate',
        `${text(gate.state)}: `,
        h('span', {class: 'term'}, shown(gate.condition)),
        ' ',
        h('b', {class: gate.passed ? 'yes' : 'no'}, gate.passed ? 'passed' : 'not passed'),
      ),
    );
  if (record.margin !== null && record.margin !== undefined) fields.push(line('margin', text(record.margin)));
  return [
    h('dl', {}, fields),
    candidates.length > 1 &&
      h(
        'details',
        {open: true},
        h('summary', {}, `${candidates.length} applicable`),
        h(
          'ul',
          {class: 'candidates'},
          candidates.map((one, i) =>
            h(
              'li',
              {class: one.id === record.id ? 'taken' : null},
              h('b', {}, text(one.id)),
              ` ${likely[i]}, weight ${text(one.weight)}`,
              one.id === record.id && chosenMark(),
            ),
          ),
        ),
      ),
    refusals(record.refused, candidates.length < 2),
  ];
}

function refusalFields(record) {
  return [
    h(
      'dl',
      {},
      line('state', text(record.state ?? null)),
      line('input', text(record.input ?? null)),
      line('reason', h('span', {class: 'term'}, shown(record.reason))),
    ),
    refusals(record.refused, true),
  ];
}

function applicationFields(record) {
  const types = record.types ?? {};
  const part = (name) =>
    line(
      name,
      h('span', {class: 'term'}, shown(record[name])),
      types[name] && h('span', {class: 'type'}, ` : ${types[name]}`),
    );
  return h(
    'dl',
    {},
    part('function'),
    part('argument'),
    part('result'),
    record.rule && line('raised by', text(record.rule)),
  );
}

const whyMissing = {unsaid: 'not said', several: 'may be', none: 'there is none'};
const names = (value) =>
  listOf(value)
    .map((one) => text(one))
    .join(', ');

function readingFields(record, in_words, told) {
  const typed = (name, value, type) =>
    line(name, h('span', {class: 'term'}, shown(value)), type && h('span', {class: 'type'}, ` : ${type}`));
  const missing = ({type, words, why, choices}) => [
    `${text(type)}${words ? `, “${words}”` : ''}: ${whyMissing[why] ?? text(why ?? '')} `,
    in_words.things(listOf(choices)),
  ];
  const fields = [
    line('move', text(record.move ?? 'not understood')),
    record.words && line('words', `“${record.words}”`),
    record.reading && typed('says', record.reading),
    record.meaning && typed('means', record.meaning, record.type),
    objectsOf(record.missing).map((gap) => line('missing', ...missing(gap))),
    record.shape && line('shape', text(record.shape.reason ?? record.shape.verdict ?? '')),
    record.referents &&
      line('referents', listOf(record.referents).length ? in_words.things(listOf(record.referents)) : 'none'),
    ['unknown', 'unused'].map((kind) => record[kind] && line(`${kind} words`, names(record[kind]))),
  ];
  return [h('dl', {}, fields), phraseViews({...record, ...told}, in_words), parseList(record)];
}

// Each noun phrase, and a pointing: who was meant, and who was not.
function phraseViews({resolved, ruled_out, referents}, in_words) {
  const pointing = {words: 'pointing', by: 'pointed', referents, ruled_out};
  const phrases = [...objectsOf(resolved), ...(ruled_out ? [pointing] : [])];
  return phrases.map((one) => phraseView(one, phrases.length < 3, in_words));
}
function phraseView({words, phrase, referents, value, told, by, ruled_out}, open, in_words) {
  const meant = referents ? listOf(referents) : [value];
  const named = told === undefined ? in_words.things(meant) : h('span', {title: text(value)}, shown(told));
  const meaning = h('b', {}, meant.length ? named : 'nothing');
  const others = objectsOf(ruled_out).map((one) => in_words.ruledOut(one, ' ruled out: '));
  return h(
    'details',
    {open, 'data-testid': 'resolved'},
    h('summary', {}, `“${words || shown(phrase)}” `, meaning, ` by ${text(by ?? '?')}`),
    others.length > 0 && h('ul', {class: 'candidates', 'data-testid': 'ruled-out'}, others),
  );
}

// All readings of the words, where there are several.
function parseList({parses, rank: taken}) {
  const all = objectsOf(parses);
  const items = all.map(({reading, category, cost}, rank) =>
    h(
      'li',
      {class: rank === taken ? 'taken' : null},
      h('span', {class: 'term'}, shown(reading)),
      ` ${text(category)}, cost ${text(cost)}`,
      rank === taken && chosenMark(),
    ),
  );
  return (
    all.length > 1 &&
    h('details', {}, h('summary', {}, `${parses.length} readings`), h('ol', {class: 'candidates'}, items))
  );
}

const most_letters = 2000;

function shortened(value) {
  const letters = JSON.stringify(value).length;
  return letters > most_letters
    ? `${objectText(value).slice(0, most_letters)}… (${letters} letters)`
    : objectText(value);
}

// The same with things in words where it lists some.
function valueShown(value, in_words) {
  if (Array.isArray(value) && value.length && value.every((one) => typeof one === 'string'))
    return in_words.things(value);
  if (
    value === null ||
    typeof value !== 'object' ||
    Array.isArray(value) ||
    JSON.stringify(value).length > most_letters
  )
    return shortened(value);
  return Object.entries(value).map(([key, inner], i) => [`${i > 0 ? ', ' : ''}${key} `, valueShown(inner, in_words)]);
}

/** The whole record, each member with its meaning. */
export function allFields(record, schema) {
  const fields = Object.entries(record).map(([name, value]) => {
    const meaning = schema.meaning(record.kind, name);
    return line(name, shortened(value), meaning && h('span', {class: 'meaning'}, meaning));
  });
  return [h('p', {class: 'meaning'}, schema.when(record.kind)), h('dl', {}, fields)];
}

// The members of a kind that has no view of its own. Causes and refusals have sections of theirs.
function ownFields(record, schema, in_words, told) {
  const shows = (name) => !schema.isStamp(name) && name !== 'because' && name !== 'refused';
  const own = Object.entries(record).filter(([name, value]) => shows(name) && value !== undefined);
  return h(
    'dl',
    {},
    own.map(([name, value]) =>
      told[name] === undefined
        ? line(name, ...[valueShown(value, in_words)].flat(Infinity).filter((one) => one !== false))
        : line(name, h('span', {title: shortened(value)}, told[name])),
    ),
  );
}

const views = {
  transition: transitionFields,
  application: applicationFields,
  reading: readingFields,
  refusal: refusalFields,
};

/** The view of the record's kind, with things named by `in_words` (a Words) and the members `told` in words; null where the sentence above the view says it all. */
export function recordView(record, schema, in_words, told) {
  if (record.kind === 'utterance' || record.kind === 'gesture') return null;
  return (
    views[record.kind]?.(record, in_words, told) ?? [
      ownFields(record, schema, in_words, told),
      refusals(record.refused),
    ]
  );
}
