// The record at the cursor: why it came about, from the sentence that tells it all to the record field by field, and
// what came of it.
import {h, panel, shown, text, seconds} from '../dom.js';
import {Latest} from '../terms/latest.js';
import {plainFields, recordView} from '../terms/record_views.js';
import {walk} from '../terms/derivation.js';

const listOf = (value) => (Array.isArray(value) ? value.filter((one) => one && typeof one === 'object') : []);
const section = (title, ...content) => [h('h3', {}, title), ...content];

export function mountWhy(app) {
  const {data} = app;
  const body = h('div', {class: 'record', tabindex: 0, role: 'region', 'aria-label': 'The record and why it came about'});
  const title = h('span', {class: 'muted'});
  let shown_n = -1;

  const to = (n, words) => h('button', {type: 'button', class: 'link to', onclick: () => app.jump(n)}, words);
  const time = (t) => (Number.isFinite(t) ? h('span', {class: 't'}, ` ${+t.toFixed(2)} s`) : '');
  const reference = ({n, t, kind, brief}, here) => h('li', {class: `kind-${kind}`}, h('span', {class: 'n'}, `#${n}`), ' ',
    h('span', {}, to(n, [h('b', {}, kind), ' ', shown(brief)]), time(t), here && h('span', {class: 'here'}, ' ← here')));
  const chain = (list, testid, here) => h('ol', {class: 'chain', 'data-testid': testid}, list.map((one) => reference(one, one.n === here)));
  const opens = (summary, testid, open, ...content) => h('details', {open, 'data-testid': testid}, h('summary', {}, summary), ...content);

  // Who could have been meant and was not, in the readings that the record goes back to.
  const ruledOut = (explained) => listOf(explained.inputs).flatMap((input) => listOf(input.readings)).flatMap((reading) =>
    listOf(reading.resolved).filter((one) => listOf(one.ruled_out).length).map((one) => ({n: reading.n, ...one})));

  const step = (one) => h('li', {},
    to(one.n, [h('span', {class: 'n'}, `#${one.n}`), ' ', h('b', {}, text(one.id)), ` ${text(one.from)} → ${text(one.to)}`]),
    one.condition && h('span', {class: 'term'}, ` if ${shown(one.condition)}`),
    listOf(one.candidates).length > 1 && h('p', {class: 'note'}, `among ${listOf(one.candidates).map((each) => `${text(each.id)} (${text(each.weight)})`).join(', ')}`),
    listOf(one.refused).length > 0 && h('details', {}, h('summary', {}, `refused: ${listOf(one.refused).reduce((sum, each) => sum + (each.ids?.length ?? 1), 0)}`),
      h('ul', {class: 'candidates'}, listOf(one.refused).map((each) => h('li', {}, h('b', {}, [each.ids].flat().map(text).join(', ')), ' ', shown(each.reason))))));

  const application = ({node}) => h('li', {}, to(node.n, `#${node.n}`), ' ',
    h('span', {class: 'term'}, shown(node.term)), node.type && h('span', {class: 'type'}, ` : ${node.type}`), node.rule && ` raised by ${text(node.rule)}`,
    h('ul', {class: 'candidates'}, listOf(node.children).map((child) => h('li', {}, h('span', {class: 'term'}, shown(child.term)), child.type && h('span', {class: 'type'}, ` : ${child.type}`)))));

  const whyOf = (explained) => {
    const links = listOf(explained.chain), steps = listOf(explained.steps), out = ruledOut(explained);
    const built = walk(explained.derivation).filter(({node}) => node.how === 'application' && Number.isInteger(node.n));
    const inputs = listOf(explained.inputs).map((one) => ({...one, brief: `${one.told}${one.count > 1 ? `, ${one.count} samples` : ''}`}));
    const led = [...listOf(explained.brought_about)], along = listOf(explained.along);
    return [
      section('Why', links.length > 1 ? chain(links.slice(1), 'why', null) : h('p', {class: 'muted'}, 'Nothing else in the log brought this about.')),
      inputs.length > 0 && section('Who contributed', chain(inputs, 'inputs')),
      out.length > 0 && opens(`Ruled out: ${[...new Set(out.flatMap((one) => listOf(one.ruled_out).map((each) => text(each.object))))].join(', ')}`, 'who-not', false,
        out.map((one) => [h('p', {class: 'note'}, to(one.n, `#${one.n}`), ` “${text(one.words ?? '')}” means ${[one.referents ?? one.value ?? 'nothing'].flat().map(text).join(', ')}`),
          h('ul', {class: 'candidates'}, listOf(one.ruled_out).map((each) => h('li', {}, h('b', {}, text(each.object)), ' ', shown(each.reason))))])),
      steps.length > 0 && opens(`Decided in ${steps.length === 1 ? 'one step' : `${steps.length} steps`}${explained.choice ? `, ${text(explained.choice)}` : ''}`, 'decided', false, h('ol', {class: 'applications'}, steps.map(step))),
      listOf(explained.refused).length > 0 && opens('Why no transition took it', 'refused-all', true, h('ul', {class: 'candidates'}, listOf(explained.refused).map((each) => h('li', {}, h('b', {}, [each.ids].flat().map(text).join(', ')), ' ', shown(each.reason))))),
      built.length > 0 && opens(`Built from ${built.length === 1 ? 'one application' : `${built.length} applications`}`, 'derivation', false, h('ol', {class: 'applications'}, built.map(application))),
      listOf(explained.fragile).length > 0 && section('Next to nothing could have changed', h('ul', {class: 'candidates'}, listOf(explained.fragile).map((one) => h('li', {}, to(one.n, `#${one.n}`), ` margin ${text(one.margin)}`)))),
      led.length > 0 && section('What came of it', chain(led, 'effects')),
      along.length > 0 && opens('What came along with it', 'along', false, chain(along, 'along-list')),
      explained.act?.records?.length > 0 && opens(`How the act went: ${text(explained.act.outcome ?? 'not ended')}`, 'act', false,
        chain(listOf(explained.act.records).map((one) => ({...one, kind: 'act', brief: `${text(one.status)} ${text(one.program)}`})), 'act-records')),
      explained.trouble && h('p', {class: 'trouble'}, explained.trouble),
    ];
  };

  const show = ({n, record, explained, problem}) => {
    const held = body.contains(document.activeElement);
    body.replaceChildren(...[
      h('p', {class: 'sentence', 'data-testid': 'headline'}, explained?.headline ? shown(explained.headline) : [h('b', {}, record.kind), ` ${shown(data.label(n))}`]),
      recordView(record),
      problem && h('p', {class: 'trouble'}, problem.message),
      explained && whyOf(explained),
      opens('The record field by field', 'fields', false, plainFields(record, [])),
    ].flat(Infinity).filter(Boolean));
    if (n !== shown_n) body.scrollTop = 0;
    shown_n = n;
    if (held) body.focus();
  };

  const latest = new Latest(
    async (n) => {
      const explained = app.client.explain(n).then((told) => ({told}), (problem) => ({problem}));
      const record = await app.client.record(n), {told, problem} = await explained;
      return {n, record, explained: told, problem};
    },
    show, (problem) => body.replaceChildren(h('p', {class: 'trouble'}, problem.message)));

  return {
    element: panel('why', 'Why', title, body),
    render({n}) {
      title.textContent = `#${n} at ${seconds(data.t[n])}`;
      latest.want(n);
    },
  };
}
