// The dialogue of human and avatar; words and gestures that belong together are one move.
import {h, panel, brief, clock, counted, instant} from '../dom.js';
import {calmly} from '../calmly.js';
import {lastAtMost} from '../search.js';

const at_once = 60; // moves that are in the page
export const calm_ms = 200; // between drawings of moves that are far from those before
const top_px = 4; // scrolled this close to the top, earlier moves are drawn

export const who = {speech: 'human', gesture: 'human', utterance: 'avatar', move: 'avatar', act: 'avatar', flag: 'log'};
export const how = {speech: 'says', gesture: 'shows', utterance: 'says', move: 'shows', act: 'does', flag: 'flag'};
export const hint = {gesture: 'gesture', move: 'gesture', act: 'act'};

/** All moves in order: {n, how, i}: the record, its lane, and the place there. */
export function movesOf({lanes, size}) {
  const all = Object.keys(who).flatMap((lane) => Array.from(lanes[lane].n, (n, i) => ({n, how: lane, i})));
  return all.filter(({n}) => n < size).sort((a, b) => a.n - b.n);
}

/** The words of a move, or its deed in words. */
export function wordsOf(data, move) {
  if (move.how === 'flag' && data.kind(move.n) === 'observed') return `as recorded: ${brief(data.text(move.n))}`;
  if (move.how === 'flag') return `${data.kind(move.n)}: ${data.label(move.n).split(':')[0]}`;
  return how[move.how] === 'says' ? `“${data.said(move.n)}”` : brief(data.text(move.n));
}

/** Draws a list anew and leaves it scrolled as it was. */
export function redrawn(list, draw) {
  const top = list.scrollTop;
  draw();
  list.scrollTop = top;
}

/** Which inputs were taken together, from the percepts' `because`: n -> the numbers of all of them. */
function ensembles(percepts) {
  const of = new Map();
  for (const {because} of percepts)
    if (Array.isArray(because) && because.length > 1) for (const n of because) of.set(n, because);
  return of;
}

/** Places of the moves in runs: refusals that follow one another are one run, every other move is one of its own. */
function runsOf(moves, first, last, refused) {
  const runs = [];
  for (let i = first; i < last; ++i) {
    const folded = refused(moves[i]);
    if (folded && runs.at(-1)?.folded) runs.at(-1).places.push(i);
    else runs.push({folded, places: [i]});
  }
  return runs;
}

const more = (count, when, onclick) =>
  h('li', {class: 'more'}, h('button', {type: 'button', class: 'link', onclick}, `${count} ${when}`));

class Dialogue {
  #data;
  #client;
  #jump;
  #moves;
  #numbers; // of the moves' records
  #list = h('ol', {class: 'moves', tabindex: 0, 'aria-label': 'Moves of the human and the avatar'});
  // The moves in the page: places from #first to before #last, and {row, button} of each.
  #first = 0;
  #last = 0;
  #rows = new Map();
  #current = null;
  #selected = -1;
  #opened = new Set(); // the first records of the folded refusals that the reader has opened
  #together = new Map(); // by ensembles()
  #asked_at = -1;

  constructor({data, client, jump}) {
    this.#data = data;
    this.#client = client;
    this.#jump = jump;
    this.#moves = movesOf(data);
    this.#numbers = Uint32Array.from(this.#moves, (move) => move.n);
    this.#list.addEventListener('scroll', () => this.#scrolled());
    // A list of another height, such as behind a panel that fills the page, has lost its place.
    new ResizeObserver(() => this.#light()).observe(this.#list);
    const nothing = h('p', {class: 'empty'}, 'Nobody said or showed anything in this run.');
    const legend = [h('i', {class: 'human'}), 'human', h('i', {class: 'avatar'}), 'avatar'];
    this.element = panel(
      'dialogue',
      'Dialogue',
      h('span', {class: 'legend'}, legend),
      this.#moves.length ? this.#list : nothing,
    );
  }

  #bubble(move) {
    const {lanes, names, t} = this.#data;
    const status = names[lanes.act.status?.[move.i]];
    const title = `#${move.n}, ${instant(t[move.n])}`;
    return h(
      'button',
      {type: 'button', class: how[move.how], onclick: () => this.#jump(move.n), 'data-n': move.n, title},
      h('span', {class: 'unseen'}, `${who[move.how]} ${how[move.how]} `),
      hint[move.how] && h('span', {class: 'hint', 'aria-hidden': 'true'}, hint[move.how]),
      h('span', {class: 'words'}, wordsOf(this.#data, move)),
      move.how === 'act' && status !== 'done' && h('span', {class: `status ${status}`}, status),
    );
  }

  #draw() {
    this.#rows = new Map();
    this.#data.labels.want(this.#numbers.slice(this.#first, this.#last));
    const items = [];
    const refused = ({how: lane, n}) => lane === 'flag' && this.#data.kind(n) === 'refusal';
    for (const {folded, places} of runsOf(this.#moves, this.#first, this.#last, refused)) {
      const [i] = places;
      const group = this.#together.get(this.#moves[i].n);
      const previous = items.at(-1);
      if (folded && places.length > 1) items.push(this.#fold(places));
      else if (group && previous?.members.some((n) => group.includes(n))) this.#join(previous, i);
      else items.push(this.#item(i));
    }
    const earlier = this.#first;
    const later = this.#moves.length - this.#last;
    this.#list.replaceChildren(
      ...(earlier > 0 ? [more(earlier, 'earlier', () => this.#reach(this.#first - at_once / 2))] : []),
      ...items.map(({row}) => row),
      ...(later > 0 ? [more(later, 'later', () => this.#reach(this.#last))] : []),
    );
  }
  #item(i) {
    const move = this.#moves[i];
    const button = this.#bubble(move);
    const time = h('time', {}, clock(this.#data.t[move.n]));
    const row = h('li', {class: `${who[move.how]} ${how[move.how]}`}, h('div', {class: 'parts'}, button), time);
    this.#rows.set(i, {row, button});
    return {row, members: [move.n]};
  }
  // Inputs that were refused one after the other, in one line that opens; `places` in the moves.
  #fold(places) {
    const buttons = places.map((i) => this.#bubble(this.#moves[i]));
    const summary = h('summary', {}, `${counted(places.length, 'input')} refused`);
    const open = this.#opened.has(this.#moves[places[0]].n);
    const details = h('details', {open, class: 'folded'}, summary, h('div', {class: 'parts'}, buttons));
    details.addEventListener('toggle', () => this.#opened[details.open ? 'add' : 'delete'](this.#moves[places[0]].n));
    const row = h('li', {class: 'log flag'}, details);
    places.forEach((i, k) => this.#rows.set(i, {row, button: buttons[k]}));
    return {row, members: places.map((i) => this.#moves[i].n)};
  }
  // Words and gestures that were taken together are one move, with all its parts.
  #join(item, i) {
    const button = this.#bubble(this.#moves[i]);
    if (item.members.length === 1) item.row.prepend(h('span', {class: 'unseen'}, 'human, as one: '));
    item.members.push(this.#moves[i].n);
    item.row.classList.add('ensemble');
    item.row.querySelector('.parts').append(button);
    this.#rows.set(i, {row: item.row, button});
  }

  /** Draws the moves around this place. */
  #reach(place) {
    this.#first = Math.max(0, Math.min(this.#moves.length - at_once, Math.floor(place - at_once / 2)));
    this.#last = Math.min(this.#moves.length, this.#first + at_once);
    this.#draw();
    this.#light();
    this.#bind();
  }
  #reachCalmly = calmly(() => this.#reach(Math.max(0, lastAtMost(this.#numbers, this.#selected))), calm_ms);

  // Which of them belong together comes from the log's percepts.
  async #bind() {
    if (!this.#moves.length || this.#asked_at === this.#first || !this.#data.count('percept')) return;
    const asked_at = (this.#asked_at = this.#first);
    try {
      const percepts = await this.#client.records('percept', this.#numbers[asked_at], 2 * at_once);
      if (this.#asked_at !== asked_at) return;
      this.#together = ensembles(percepts);
      this.#draw();
      this.#light();
    } catch {
      /* they are shown one by one */
    }
  }
  #scrolled() {
    const list = this.#list;
    if (list.scrollTop >= top_px || this.#first === 0 || !list.matches(':hover')) return;
    const height = list.scrollHeight;
    this.#reach(this.#first);
    list.scrollTop = Math.max(top_px + 1, list.scrollHeight - height);
  }

  #light() {
    this.#current?.row.classList.remove('current');
    this.#current?.button.removeAttribute('aria-current');
    this.#current = this.#rows.get(lastAtMost(this.#numbers, this.#selected)) ?? null;
    if (!this.#current) return;
    const {row, button} = this.#current;
    row.classList.add('current');
    button.setAttribute('aria-current', 'true');
    const list = this.#list;
    const above = row.offsetTop - list.scrollTop;
    const below = above + row.offsetHeight - list.clientHeight;
    if (above < 8 || below > -8) list.scrollTop = row.offsetTop - list.clientHeight * 0.6;
  }

  labelsArrived = calmly(() => {
    redrawn(this.#list, () => {
      this.#draw();
      this.#light();
    });
  }, calm_ms);

  render({n}) {
    if (this.#selected === n) return;
    this.#selected = n;
    if (this.#rows.has(lastAtMost(this.#numbers, n))) this.#light();
    else if (this.#moves.length) this.#reachCalmly();
  }
}

export const mountDialogue = (needs) => new Dialogue(needs);
