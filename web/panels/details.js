// The record at the cursor in full, why it came about, and what came of it.
import {h, panel, shown, text, seconds} from '../dom.js';

const line = (name, ...value) => h('div', {class: 'field'}, h('dt', {}, name), h('dd', {}, ...value));

function objectText(value) {
  if (value === null || typeof value !== 'object' || Array.isArray(value)) return text(value);
  return Object.entries(value).map(([key, inner]) => `${key} ${objectText(inner)}`).join(', ');
}

function operationText(operation) {
  if (typeof operation !== 'object' || operation === null) return text(operation);
  return Object.entries(operation).map(([name, value]) =>
    value === null || value === true || value === '' ? name : `${name} ${objectText(value)}`).join(', ');
}

function transitionFields(record) {
  const candidates = record.candidates ?? [];
  const fields = [
    line('input', record.input === null ? 'ε' : text(record.input)),
    line('operation', operationText(record.operation)),
    line('taken', h('b', {}, record.id), candidates.length > 1 ? `, one of ${candidates.length} applicable` : ', the only one applicable',
      record.draw === null || record.draw === undefined ? '' : `, draw ${record.draw}`),
  ];
  for (const gate of record.gates)
    fields.push(line('gate', `${gate.state}: ${shown(gate.condition)} `, h('b', {class: gate.passed ? 'yes' : 'no'}, gate.passed ? 'passed' : 'not passed')));
  if (record.margin !== null && record.margin !== undefined) fields.push(line('margin', text(record.margin)));
  return [h('dl', {}, fields),
    candidates.length > 1 && h('details', {open: true}, h('summary', {}, `${candidates.length} applicable`),
      h('ul', {class: 'candidates'}, candidates.map((one) =>
        h('li', {class: one.id === record.id ? 'chosen' : null}, h('b', {}, one.id), ` weight ${one.weight}`,
          one.id === record.id && h('span', {class: 'yes'}, ' taken'))))),
    refusals(record.refused)];
}

const refusals = (refused, open = false) => refused?.length > 0 &&
  h('details', {open, 'data-testid': 'refused'}, h('summary', {}, `${refused.length} refused`),
    h('ul', {class: 'candidates'}, refused.map((one) => h('li', {}, h('b', {}, one.id), ' ', shown(one.reason)))));

function refusalFields(record) {
  return [h('dl', {}, line('state', record.state), line('input', text(record.input)), line('reason', shown(record.reason))),
          refusals(record.refused, true)];
}

function applicationFields(record) {
  const types = record.types ?? {};
  const part = (name) => line(name, h('span', {class: 'term'}, shown(record[name])), types[name] && h('span', {class: 'type'}, ` : ${types[name]}`));
  return h('dl', {}, part('function'), part('argument'), part('result'), record.rule && line('raised by', record.rule));
}

const whyMissing = {unsaid: 'not said', several: 'may be', none: 'there is none'};

function readingFields(record) {
  const fields = [];
  const term = (name, value, type) => fields.push(line(name, h('span', {class: 'term'}, shown(value)), type && h('span', {class: 'type'}, ` : ${type}`)));
  fields.push(line('move', record.move ?? 'not understood'));
  if (record.words) fields.push(line('words', `“${record.words}”`));
  if (record.reading) term('says', record.reading);
  if (record.meaning) term('means', record.meaning, record.type);
  for (const gap of record.missing ?? [])
    fields.push(line('missing', `${gap.type}${gap.words ? `, “${gap.words}”` : ''}: ${whyMissing[gap.why] ?? gap.why} ${(gap.choices ?? []).join(', ')}`));
  if (record.referents) fields.push(line('referents', record.referents.join(', ') || 'none'));
  for (const words of ['unknown', 'unused']) if (record[words]) fields.push(line(`${words} words`, record[words].join(', ')));
  const ruledOut = (one) => h('ul', {class: 'candidates'}, one.ruled_out.map((each) => h('li', {}, h('b', {}, each.object), ' ', shown(each.reason))));
  const phrases = [...(record.resolved ?? []), ...(record.ruled_out ? [{words: 'pointing', by: 'pointed', referents: record.referents, ruled_out: record.ruled_out}] : [])];
  return [h('dl', {}, fields),
    phrases.map((one) => h('details', {open: phrases.length < 3, 'data-testid': 'resolved'},
      h('summary', {}, `“${one.words || shown(one.phrase)}” `, h('b', {}, one.referents ? one.referents.join(', ') || 'nothing' : shown(one.value)), ` by ${one.by}`),
      one.ruled_out?.length > 0 && ruledOut(one))),
    record.parses?.length > 1 && h('details', {}, h('summary', {}, `${record.parses.length} readings`),
      h('ol', {class: 'candidates'}, record.parses.map((one, rank) =>
        h('li', {class: rank === record.rank ? 'chosen' : null}, h('span', {class: 'term'}, shown(one.reading)), ` ${one.category}, cost ${one.cost}`))))];
}

// Whatever the log says, field by field: what every kind that has no view of its own gets.
function plainFields(record) {
  const fields = [];
  for (const [key, value] of Object.entries(record)) {
    if (['kind', 'n', 't', 'cause', 'because'].includes(key)) continue;
    if (key === 'refused' || value === undefined) continue;
    const long = JSON.stringify(value).length > 2000;
    fields.push(line(key, long ? `(${JSON.stringify(value).length} letters)` : objectText(value)));
  }
  return [h('dl', {}, fields), refusals(record.refused)];
}

// The sentence above says all there is.
const nothingMore = () => null;

const views = {transition: transitionFields, application: applicationFields, reading: readingFields, refusal: refusalFields, utterance: nothingMore, gesture: nothingMore};

export function mountDetails(app) {
  const {data} = app;
  const body = h('div', {class: 'record', tabindex: 0, role: 'region', 'aria-label': 'The record in full'});
  const title = h('span', {class: 'muted'});
  let asked = -1;

  const to = (n, words) => h('button', {type: 'button', class: 'link to', onclick: () => app.jump(n), title: `#${n}`}, words);
  const reference = (n) => h('li', {class: `kind-${data.kind(n)}`}, h('span', {class: 'n'}, `#${n}`), ' ',
    to(n, h('span', {}, h('b', {}, data.kind(n)), ` ${shown(data.label(n))}`)));

  const show = (record, derivation) => {
    const chain = derivation.chain.slice(1), effects = data.effects(record.n);
    const applications = derivation.applications.filter((one) => one.n !== record.n);
    body.replaceChildren(...[
      h('p', {class: 'sentence'}, h('b', {}, record.kind), ` ${shown(data.label(record.n))}`),
      (views[record.kind] ?? plainFields)(record),
      h('h3', {}, 'Why'),
      chain.length
        ? h('ol', {class: 'chain', 'data-testid': 'why'}, chain.map((one) => reference(one.n)))
        : h('p', {class: 'muted'}, 'Nothing else in the log brought this about.'),
      derivation.inputs.length > 1 && [h('h3', {}, 'Who contributed'), h('ol', {class: 'chain'}, derivation.inputs.map((one) => reference(one.n)))],
      applications.length > 0 && [h('h3', {}, 'Built from'),
        h('ol', {class: 'applications', 'data-testid': 'derivation'}, applications.map((one) => h('li', {}, to(one.n, `#${one.n}`), applicationFields(one))))],
      effects.length > 0 && [h('h3', {}, 'What came of it'), h('ol', {class: 'chain'}, effects.map(reference))],
    ].flat(Infinity).filter(Boolean));
    body.scrollTop = 0;
  };

  return {
    element: panel('why', 'Why', title, body),
    async render({n}) {
      if (asked === n) return;
      asked = n;
      title.textContent = `#${n} at ${seconds(data.t[n])}`;
      try {
        const [record, derivation] = await Promise.all([app.client.record(n), app.client.derivation(n)]);
        if (asked === n) show(record, derivation);
      } catch (problem) {
        if (asked === n) body.replaceChildren(h('p', {class: 'trouble'}, problem.message));
      }
    },
  };
}
