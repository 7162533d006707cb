// The record at the cursor and its reasons, from one sentence to the record field by field, and its consequences.
import {h, panel, shown, instant} from '../dom.js';
import {Latest} from '../terms/latest.js';
import {Words} from '../run/words.js';
import {allFields, recordView} from '../terms/record_views.js';
import {
  actRecords,
  built,
  causes,
  contributors,
  decisions,
  effects,
  folded,
  fragile,
  lastDecision,
  membersInWords,
  refusals,
  ruledOut,
} from './why_parts.js';

const sections = [causes, contributors, ruledOut, decisions, refusals, built, fragile, effects, actRecords];

// The headline with the log's own names, where it has others.
const rawOf = (explained) => (explained && explained.raw !== explained.headline ? shown(explained.raw) : null);

export function mountWhy({data, client, jump}) {
  const title = h('span', {class: 'muted'});
  const label = 'The record and why it came about';
  const body = h('div', {class: 'record', tabindex: 0, role: 'region', 'aria-label': label});
  const words = new Words(data.summary.titles);
  let shown_n = -1;

  const to = (n, words) => h('button', {type: 'button', class: 'link to', onclick: () => jump(n)}, words);
  async function ask(n) {
    const explained = client.explain(n).then(
      (told) => ({told}),
      (problem) => ({problem}),
    );
    const record = await client.record(n);
    const {told, problem} = await explained;
    return {n, record, explained: told, problem};
  }
  function show({n, record, explained, problem}) {
    const held = body.contains(document.activeElement);
    const headline = explained?.headline
      ? shown(explained.headline)
      : [h('b', {}, record.kind), ` ${shown(data.label(n))}`];
    const parts = [
      h('p', {class: 'sentence', title: rawOf(explained), 'data-testid': 'headline'}, headline),
      explained && lastDecision(explained, to),
      recordView(record, data.schema, words, explained ? membersInWords(explained, n) : {}),
      problem && h('p', {class: 'trouble'}, problem.message),
      explained && sections.map((section) => section(explained, to, words)),
      explained?.trouble && h('p', {class: 'trouble'}, explained.trouble),
      folded('The record field by field', 'fields', false, allFields(record, data.schema)),
    ];
    body.replaceChildren(...parts.flat(Infinity).filter(Boolean));
    if (n !== shown_n) body.scrollTop = 0;
    shown_n = n;
    if (held) body.focus();
  }

  const latest = new Latest(ask, show, (problem) => body.replaceChildren(h('p', {class: 'trouble'}, problem.message)));
  return {
    element: panel('why', 'Why', title, body),
    render({n}) {
      title.textContent = `#${n} at ${instant(data.t[n])}`;
      latest.want(n);
    },
  };
}
