// Where two runs differ: why, then one difference after the other.
import {h, panel, brief, clock, counted, instant, put, text} from '../dom.js';
import {changedWords} from '../run/changed_words.js';
import {failuresOf} from '../run/verdict.js';

const described = {
  input: 'another input',
  happened: 'something else happened',
  decided: 'the same, decided by something else',
  timing: 'at another time',
  outcome: 'an act came to something else',
  poses: 'bodies are elsewhere',
};
const telling = ({kind, a, b}) =>
  kind === 'input' && (a[0] ?? b[0]).kind === 'expect' ? 'another expectation' : (described[kind] ?? kind);
const sign = (hunk) => (!hunk.a.length ? '+' : !hunk.b.length ? '−' : '~');
const most_lines = 6;
const copied_ms = 1200; // how long the button says so

const line = (mark, side, record) =>
  h(
    'li',
    {class: `line ${side}`, title: record.raw ?? null},
    h('span', {class: 'sign', 'aria-hidden': 'true'}, mark),
    h('span', {class: 'unseen'}, side === 'a' ? 'in A ' : 'in B '),
    h('span', {class: 'n'}, `#${record.n}`),
    ` ${record.kind} ${brief(record.brief)}`,
  );
const lines = (mark, side, records) => [
  records.slice(0, most_lines).map((one) => line(mark, side, one)),
  records.length > most_lines && h('li', {class: 'muted'}, `and ${records.length - most_lines} more`),
];
const hunkItem = (hunk, show) =>
  h(
    'li',
    {class: `hunk ${hunk.kind}`, 'data-testid': 'hunk'},
    h(
      'button',
      {type: 'button', onclick: show},
      h('span', {class: 'sign'}, sign(hunk)),
      ` ${telling(hunk)}, ${instant(hunk.t)}`,
    ),
    h('ul', {}, lines('−', 'a', hunk.a), lines('+', 'b', hunk.b)),
  );

// A heading with a list below it; nothing for an empty list.
const section = (title, name, sentences) =>
  sentences.length > 0 && [
    h('h3', {}, title),
    h(
      'ul',
      {class: name},
      sentences.map((one) => h('li', {}, one)),
    ),
  ];

// The changed thing in both runs, with the changed words marked; nothing where the runs share no words of it.
function changeOf(cause) {
  if (!cause || cause.a === null || cause.b === null || cause.a === undefined || cause.b === undefined) return null;
  const {before, a, b, after} = changedWords(text(cause.a), text(cause.b));
  if (!(before + after).trim()) return null;
  const side = (name, own) =>
    h('p', {class: 'change'}, h('span', {class: 'side'}, name), ' ', before, own && h('mark', {}, own), after);
  return h('div', {class: 'changes', 'data-testid': 'change'}, side('A', a), side('B', b));
}

// "puts the blue cup there, done", with what went wrong.
function endOf(data) {
  const {act, utterance} = data.lanes;
  const last = act.n.at(-1);
  const status = data.names[act.status?.at(-1)] ?? '';
  const done =
    last === undefined
      ? utterance.n.length
        ? `says “${data.text(utterance.n.at(-1))}”`
        : 'does nothing'
      : `${brief(data.text(last))} (${status})`;
  const bad = failuresOf(data.summary).map((part) => part.split(':')[0]);
  return [done, ...bad].join(', ');
}

class Differences {
  #comparison;
  #model;
  #jump;
  #body = h('div', {class: 'body', tabindex: 0, role: 'region', 'aria-label': 'Cause and differences'});
  #rows;
  #current = null;
  #shown = false; // whether a difference has been shown
  #ending = h('p', {class: 'ending', 'data-testid': 'ending'});

  constructor({comparison, model, jump, copy}) {
    this.#comparison = comparison;
    this.#model = model;
    this.#jump = jump;
    const {told, hunks} = comparison;
    this.#rows = hunks.map((hunk, i) => hunkItem(hunk, () => this.#show(i)));
    this.#fill(told);
    const step = (by, label, title, arrow) =>
      h('button', {type: 'button', title, 'aria-label': label, onclick: () => this.go(by)}, arrow);
    this.element = panel(
      'differences',
      'Differences',
      [
        step(-1, 'Previous difference', 'Previous difference (P)', '↑'),
        step(1, 'Next difference', 'Next difference (N)', '↓'),
        told.markdown && copyButton(told.markdown, copy),
      ],
      this.#body,
    );
  }

  #fill({evidence, count, meet, givens, sentence, cause, same}) {
    const list = [h('h3', {}, counted(count, 'difference')), h('ol', {class: 'hunks'}, this.#rows)];
    const parts = [
      h('p', {class: `cause-box${same ? '' : ' bad'}`, 'data-testid': 'cause'}, brief(sentence)),
      this.#ending,
      changeOf(cause),
      section('What speaks for the cause', 'evidence', evidence.map(brief)),
      this.#rows.length ? list : h('p', {class: 'empty'}, 'Nothing that happened differs.'),
      meet && this.#meeting(meet),
      section(
        'What the runs do not have in common',
        'givens',
        givens.map((one) => `${one.kind}: ${one.sentence}`),
      ),
    ];
    this.#body.append(...parts.flat(Infinity).filter(Boolean));
  }
  #meeting({a, b}) {
    const there = h('button', {type: 'button', class: 'link', onclick: () => this.#jump(a)}, `A #${a}, B #${b}`);
    const {own, side} = this.#comparison;
    const times = `, at ${clock(own.t[a], 2)} in A and ${clock(side.data.t[b], 2)} in B`;
    return h('p', {class: 'meet'}, 'They meet again: ', there, times);
  }

  // The last deed of each run, or its last words, and its unmet expectations.
  #end() {
    const {own, side, told} = this.#comparison;
    if (told.same) return;
    const [a, b] = [own, side.data].map(endOf);
    const sentence = a === b ? `In the end both: ${a}.` : `In the end: A ${a}; B ${b}.`;
    put(this.#ending, sentence);
  }
  labelsArrived() {
    this.#end();
  }

  #show(i) {
    this.#jump(this.#comparison.recordOf(i), {hunk: i});
  }
  /** To the difference `by` places after the one that is shown. */
  go(by) {
    const last = this.#rows.length - 1;
    if (last < 0) return;
    const {hunk} = this.#model.selection;
    if (hunk === null) this.#show(by > 0 ? 0 : last);
    else this.#show(Math.max(0, Math.min(last, hunk + by)));
  }

  render({hunk}) {
    this.#end();
    const row = this.#rows[hunk] ?? null;
    if (row === this.#current) return;
    this.#current?.classList.remove('current');
    this.#current?.firstChild.removeAttribute('aria-current');
    this.#current = row;
    if (!row) return;
    row.classList.add('current');
    row.firstChild.setAttribute('aria-current', 'true');
    // Scrolls the panel alone: the page stays where it is. The first difference is below the cause, which comes first.
    if (this.#rows.indexOf(row) === this.#comparison.first && !this.#shown) {
      this.#shown = true;
      return;
    }
    const body = this.#body;
    const top = row.offsetTop - body.offsetTop;
    if (top < body.scrollTop || top + row.offsetHeight > body.scrollTop + body.clientHeight) body.scrollTop = top - 8;
  }
}

function copyButton(markdown, copy) {
  const button = h('button', {type: 'button', 'data-testid': 'markdown'}, 'Copy as Markdown');
  button.addEventListener('click', async () => {
    button.textContent = (await copy(markdown, 'The comparison was copied as Markdown.')) ? 'Copied' : 'Not copied';
    setTimeout(() => {
      button.textContent = 'Copy as Markdown';
    }, copied_ms);
  });
  return button;
}

export const mountDifferences = (needs) => new Differences(needs);
