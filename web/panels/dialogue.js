// What the two said and did, as a conversation.
import {h, panel, brief, clock} from '../dom.js';
import {lastAtMost} from '../run_data.js';

/** All moves in order: [{n, t, who, how, text}]. */
function moves({lanes}) {
  const all = [];
  for (const [t, , n, said] of lanes.speech) all.push({n, t, who: 'human', how: 'says', text: `“${said}”`});
  for (const [t, , n, name] of lanes.gesture) all.push({n, t, who: 'human', how: 'shows', text: name});
  for (const [t, n, said] of lanes.utterance) all.push({n, t, who: 'avatar', how: 'says', text: `“${said}”`});
  for (const [t, n, term] of lanes.move) all.push({n, t, who: 'avatar', how: 'shows', text: brief(term)});
  for (const [t, , n, program, status] of lanes.act)
    all.push({n, t, who: 'avatar', how: 'does', text: brief(program), status});
  for (const [t, n, kind] of lanes.flags) all.push({n, t, who: 'log', how: kind, text: ''});
  return all.sort((a, b) => a.n - b.n);
}

const hint = {says: '', shows: 'gesture', does: 'act'};

export function mountDialogue(app) {
  const {data} = app;
  const all = moves(data);
  const numbers = all.map((move) => move.n);
  const item = (move) => {
    const label = move.who === 'log' ? `${move.how}: ${data.label(move.n).split(':')[0]}` : move.text;
    return h('li', {class: `${move.who} ${move.how}`},
      h('button', {type: 'button', onclick: () => app.jump(move.n), 'data-n': move.n, title: `#${move.n}, ${move.t.toFixed(3)} s`},
        h('span', {class: 'unseen'}, `${move.who} ${move.how} `),
        hint[move.how] && h('span', {class: 'hint', 'aria-hidden': 'true'}, hint[move.how]),
        h('span', {class: 'words'}, label),
        move.status && move.status !== 'done' && h('span', {class: `status ${move.status}`}, move.status)),
      h('time', {}, clock(move.t)));
  };
  const list = h('ol', {class: 'moves', tabindex: 0, 'aria-label': 'Moves of the human and the avatar'}, all.map(item));
  const rows = [...list.children];
  let current = null;
  const body = all.length ? list : h('p', {class: 'empty'}, 'Nobody said or showed anything in this run.');
  const element = panel('dialogue', 'Dialogue',
    h('span', {class: 'legend'}, h('i', {class: 'human'}), 'human', h('i', {class: 'avatar'}), 'avatar'), body);
  return {
    element,
    render({n}) {
      const row = rows[lastAtMost(numbers, n)] ?? null;
      if (row === current) return;
      current?.classList.remove('current');
      current?.firstChild.removeAttribute('aria-current');
      current = row;
      if (!row) return;
      row.classList.add('current');
      row.firstChild.setAttribute('aria-current', 'true');
      const above = row.offsetTop - list.scrollTop, below = above + row.offsetHeight - list.clientHeight;
      if (above < 8 || below > -8) list.scrollTop = row.offsetTop - list.clientHeight * 0.6;
    },
  };
}
