// The dialogues of two runs side by side: moves that are the same, or each other's counterparts, share a row.
import {h, panel, clock, instant} from '../dom.js';
import {calmly} from '../calmly.js';
import {changedWords} from '../run/changed_words.js';
import {lastAtMost} from '../search.js';
import {calm_ms, hint, how, movesOf, redrawn, who, wordsOf} from './dialogue.js';

const at_once = 120; // rows that are in the page

/** [{a, b, n}]: the moves of each row, null where a run has none there; `n`: the record of A that the row belongs to. */
export function pairsOf(comparison) {
  const {own, side} = comparison;
  const [in_a, in_b] = [movesOf(own), movesOf(side.data)];
  const place_b = new Map(in_b.map((move, i) => [move.n, i]));
  const rows = [];
  let next_b = 0;
  const alone = (move) => ({a: null, b: move, n: comparison.toOwn(move.n)});
  const upTo = (end, t) => {
    while (next_b < end && comparison.timeToOwn(side.data.t[in_b[next_b].n]) <= t) rows.push(alone(in_b[next_b++]));
  };
  for (const move of in_a) {
    const place = place_b.get(comparison.toOther(move.n)) ?? -1;
    const pairs = place >= next_b && in_b[place].how === move.how && comparison.toOwn(in_b[place].n) === move.n;
    if (pairs) upTo(place, Infinity);
    else upTo(in_b.length, own.t[move.n] - 1e-9);
    rows.push({a: move, b: pairs ? in_b[next_b++] : null, n: move.n});
  }
  upTo(in_b.length, Infinity);
  return rows;
}

class DialoguePair {
  #comparison;
  #jump;
  #rows;
  #numbers; // of A's records, growing
  #first = 0;
  #drawn = new Map(); // place -> element
  #list = h('ol', {class: 'moves pairs', tabindex: 0, 'aria-label': 'Moves in both runs'});
  #selected = -1;

  constructor({comparison, jump}) {
    this.#comparison = comparison;
    this.#jump = jump;
    this.#rows = pairsOf(comparison);
    let least = 0;
    this.#numbers = this.#rows.map(({n}) => (least = Math.max(least, n)));
    const heads = h('div', {class: 'pair-heads', 'aria-hidden': 'true'}, h('b', {}, 'A'), h('b', {}, 'B'));
    const nothing = h('p', {class: 'empty'}, 'Nobody said or showed anything in these runs.');
    this.element = panel('dialogue', 'Dialogue', null, this.#rows.length ? [heads, this.#list] : nothing);
    new ResizeObserver(() => this.#light()).observe(this.#list);
  }

  #cell(name, data, move, text, differs, jump) {
    if (!move)
      return h('div', {class: `cell-${name} none`}, h('span', {class: 'unseen'}, `nothing in ${name.toUpperCase()}`));
    const {before, own, after} = text;
    return h(
      'div',
      {class: `cell-${name} ${who[move.how]} ${how[move.how]}${differs ? ' differs-here' : ''}`},
      h('time', {}, clock(data.t[move.n], 1)),
      h(
        'button',
        {
          type: 'button',
          class: how[move.how],
          title: `${name.toUpperCase()} #${move.n}, ${instant(data.t[move.n])}: ${data.raw(move.n) ?? data.label(move.n)}`,
          onclick: jump,
        },
        h('span', {class: 'unseen'}, `${name.toUpperCase()}: ${who[move.how]} ${how[move.how]} `),
        hint[move.how] && h('span', {class: 'hint', 'aria-hidden': 'true'}, hint[move.how]),
        before,
        own && (differs && before + after ? h('mark', {}, own) : own),
        after,
      ),
    );
  }
  #row({a, b, n}, i) {
    const {own, side} = this.#comparison;
    const [one, other] = [a ? wordsOf(own, a) : '', b ? wordsOf(side.data, b) : ''];
    const differs = !a || !b || one !== other;
    const {before, after, ...middle} = a && b ? changedWords(one, other) : {before: '', after: '', a: one, b: other};
    const jump = () => this.#jump(n);
    const element = h(
      'li',
      {'data-testid': 'pair', class: differs ? 'differing' : null},
      this.#cell('a', own, a, {before, own: middle.a, after}, differs, jump),
      this.#cell('b', side.data, b, {before, own: middle.b, after}, differs, jump),
    );
    this.#drawn.set(i, element);
    return element;
  }

  #reach(place) {
    this.#first = Math.max(0, Math.min(this.#rows.length - at_once, place - at_once / 2));
    this.#draw();
    this.#light();
  }
  #draw() {
    const {own, side} = this.#comparison;
    this.#drawn = new Map();
    const rows = this.#rows.slice(this.#first, this.#first + at_once);
    own.labels.want(rows.flatMap(({a}) => (a ? [a.n] : [])));
    side.data.labels.want(rows.flatMap(({b}) => (b ? [b.n] : [])));
    const later = this.#rows.length - this.#first - rows.length;
    const more = (count, when, place) =>
      count > 0 &&
      h(
        'li',
        {class: 'more'},
        h('button', {type: 'button', class: 'link', onclick: () => this.#reach(place)}, `${count} ${when}`),
      );
    this.#list.replaceChildren(
      ...[
        more(this.#first, 'earlier', this.#first),
        ...rows.map((row, k) => this.#row(row, this.#first + k)),
        more(later, 'later', this.#first + rows.length),
      ].filter(Boolean),
    );
  }
  #light() {
    this.#list.querySelector('.current')?.classList.remove('current');
    const row = this.#drawn.get(lastAtMost(this.#numbers, this.#selected));
    if (!row) return;
    row.classList.add('current');
    const list = this.#list;
    const above = row.offsetTop - list.scrollTop;
    if (above < 8 || above + row.offsetHeight > list.clientHeight - 8)
      list.scrollTop = row.offsetTop - list.clientHeight * 0.4;
  }

  labelsArrived = calmly(() => {
    redrawn(this.#list, () => {
      this.#draw();
      this.#light();
    });
  }, calm_ms);

  render({n}) {
    if (n === this.#selected || !this.#rows.length) return;
    this.#selected = n;
    const place = Math.max(0, lastAtMost(this.#numbers, n));
    if (this.#drawn.has(place)) this.#light();
    else this.#reach(place);
  }
}

/** `comparison`: a Comparison; `jump(n)`: to a record of A. */
export const mountDialoguePair = (needs) => new DialoguePair(needs);
