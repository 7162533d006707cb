// What the two said and did, as a conversation; words and gestures that belong together are one move.
import {h, panel, brief, clock} from '../dom.js';
import {calmly} from '../calmly.js';
import {lastAtMost} from '../run/run_data.js';

const at_once = 60;    // moves that are in the page
const calm_ms = 200;   // between drawings of moves that are far from those before

/** All moves in order: {n, how}: where each is told of, and which lane it is of. */
function movesOf({lanes, size}) {
  const kinds = ['speech', 'gesture', 'utterance', 'move', 'act', 'flag'];
  const all = kinds.flatMap((how) => Array.from(lanes[how].n, (n, i) => ({n, how, i}))).filter(({n}) => n < size);
  return all.sort((a, b) => a.n - b.n);
}

const who = {speech: 'human', gesture: 'human', utterance: 'avatar', move: 'avatar', act: 'avatar', flag: 'log'};
const how = {speech: 'says', gesture: 'shows', utterance: 'says', move: 'shows', act: 'does', flag: 'flag'};
const hint = {gesture: 'gesture', move: 'gesture', act: 'act'};

/** Which inputs were taken together, from the percepts' `because`: n -> the numbers of all of them. */
function ensembles(percepts) {
  const of = new Map();
  for (const {because} of percepts)
    if (Array.isArray(because) && because.length > 1) for (const n of because) of.set(n, because);
  return of;
}

export function mountDialogue(app) {
  const {data, client} = app;
  const all = movesOf(data), numbers = Uint32Array.from(all, (move) => move.n);
  const list = h('ol', {class: 'moves', tabindex: 0, 'aria-label': 'Moves of the human and the avatar', onscroll: () => scrolled()});
  const body = all.length ? list : h('p', {class: 'empty'}, 'Nobody said or showed anything in this run.');
  const element = panel('dialogue', 'Dialogue',
    h('span', {class: 'legend'}, h('i', {class: 'human'}), 'human', h('i', {class: 'avatar'}), 'avatar'), body);
  let first = 0, last = 0, rows = new Map(), current = null, selected = -1, together = new Map(), asked_at = -1;

  const status = ({i}) => data.names[data.lanes.act.status?.[i]];
  const words = (move) => {
    if (move.how === 'flag') return `${data.kind(move.n)}: ${data.label(move.n).split(':')[0]}`;
    const text = data.text(move.n);
    return how[move.how] === 'says' ? `“${text}”` : brief(text);
  };
  const bubble = (move) => h('button', {type: 'button', class: how[move.how], onclick: () => app.jump(move.n), 'data-n': move.n, title: `#${move.n}, ${data.t[move.n].toFixed(3)} s`},
    h('span', {class: 'unseen'}, `${who[move.how]} ${how[move.how]} `),
    hint[move.how] && h('span', {class: 'hint', 'aria-hidden': 'true'}, hint[move.how]),
    h('span', {class: 'words'}, words(move)),
    move.how === 'act' && status(move) !== 'done' && h('span', {class: `status ${status(move)}`}, status(move)));

  const draw = () => {
    rows = new Map();
    const items = [];
    data.labels.want(all.slice(first, last).map(({n}) => n));
    if (first > 0) items.push(h('li', {class: 'more'}, h('button', {type: 'button', class: 'link', onclick: () => reach(first - at_once / 2)}, `${first} earlier`)));
    for (let i = first; i < last; ++i) {
      const move = all[i], group = together.get(move.n);
      const previous = items.at(-1);
      if (group && previous?.members?.some((n) => group.includes(n))) {
        // What was said and shown as one is one move, with all its parts.
        previous.members.push(move.n);
        previous.element.classList.add('ensemble');
        const part = bubble(move);
        previous.element.querySelector('.parts').append(part);
        rows.set(i, {row: previous.element, button: part});
        continue;
      }
      const button = bubble(move);
      const row = h('li', {class: `${who[move.how]} ${how[move.how]}`}, h('div', {class: 'parts'}, button), h('time', {}, clock(data.t[move.n])));
      items.push({element: row, members: [move.n]});
      rows.set(i, {row, button});
    }
    if (last < all.length) items.push(h('li', {class: 'more'}, h('button', {type: 'button', class: 'link', onclick: () => reach(last)}, `${all.length - last} later`)));
    list.replaceChildren(...items.map((item) => item.element ?? item));
    for (const item of items)
      if (item.members?.length > 1) item.element.prepend(h('span', {class: 'unseen'}, 'human, as one: '));
  };
  /** Draws the moves around this place. */
  const reach = (place) => {
    first = Math.max(0, Math.min(all.length - at_once, Math.floor(place - at_once / 2)));
    last = Math.min(all.length, first + at_once);
    draw();
    light();
    bind();
  };
  const reachCalmly = calmly(() => reach(Math.max(0, lastAtMost(numbers, selected))), calm_ms);
  // Which of them belong together comes from the log's percepts.
  const bind = async () => {
    if (!all.length || asked_at === first || !data.count('percept')) return;
    asked_at = first;
    try {
      const percepts = await client.records('percept', numbers[first], 2 * at_once);
      if (asked_at !== first) return;
      together = ensembles(percepts);
      draw();
      light();
    } catch { /* they are shown one by one */ }
  };
  const scrolled = () => {
    if (list.scrollTop < 4 && first > 0 && list.matches(':hover')) {
      const height = list.scrollHeight;
      reach(first);
      list.scrollTop = Math.max(5, list.scrollHeight - height);
    }
  };
  const light = () => {
    current?.row.classList.remove('current');
    current?.button.removeAttribute('aria-current');
    current = rows.get(lastAtMost(numbers, selected)) ?? null;
    if (!current) return;
    current.row.classList.add('current');
    current.button.setAttribute('aria-current', 'true');
    const {row} = current, above = row.offsetTop - list.scrollTop, below = above + row.offsetHeight - list.clientHeight;
    if (above < 8 || below > -8) list.scrollTop = row.offsetTop - list.clientHeight * 0.6;
  };
  return {
    element,
    labelsArrived: calmly(() => {
      const top = list.scrollTop;
      draw();
      light();
      list.scrollTop = top;
    }, calm_ms),
    render({n}) {
      if (selected === n) return;
      selected = n;
      const place = lastAtMost(numbers, n);
      if (rows.has(place)) light(); else if (all.length) reachCalmly();
    },
  };
}
