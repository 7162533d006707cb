// The top line: what run this is, how it went, where the cursor stands, and the buttons.
import {h, s, brief, icon, counted, grouped, seconds} from '../dom.js';
import {served} from '../run/run_client.js';

const icons = {
  first: 'M3 3h2v10H3zM13 3v10L6 8z', back: 'M11 3v10L4 8z', play: 'M4 2.5v11l9-5.5z', pause: 'M4 3h3v10H4zM9 3h3v10H9z',
  on: 'M5 3v10l7-5z', last: 'M11 3h2v10h-2zM3 3v10l7-5z', theme: 'M8 2a6 6 0 1 0 0 12a6 6 0 1 0 0-12zM8 3.5v9a4.5 4.5 0 0 0 0-9z',
};
const sign = (name) => s('svg', {viewBox: '0 0 16 16', width: 14, height: 14, 'aria-hidden': 'true'}, s('path', {d: icons[name], fill: 'currentColor', 'fill-rule': 'evenodd'}));

const speeds = [0.5, 1, 2, 5, 20];

/** "99 utterances, 13 acts, 0 refusals, 503 s" */
export function verdict(summary) {
  const parts = [counted(summary.utterances, 'utterance'), counted(summary.acts, 'act'),
                 counted(summary.refusals - summary.refused_samples, 'refusal'),
                 `${Math.round(summary.duration)} s`];
  if (summary.problems) parts.push(counted(summary.problems, 'problem'));
  if (summary.expected) parts.push(`${summary.met} of ${counted(summary.expected, 'expectation')} met`);
  if (summary.refused_samples) parts.push(`${counted(summary.refused_samples, 'pointing sample')} not awaited`);
  return parts.join(', ');
}

export function mountHeader(host, app) {
  const {data, comparison} = app;
  const position = h('output', {class: 'position', 'data-testid': 'position'});
  const button = (label, shown, action, props) =>
    h('button', {type: 'button', title: label, 'aria-label': label, onclick: action, ...props}, shown);
  const play = button('Play (Space)', sign('play'), () => app.play(), {'data-testid': 'play', 'aria-pressed': 'false'});
  const speed = h('select', {'aria-label': 'Speed', title: 'Speed', onchange: () => { app.speed = Number(speed.value); }},
    speeds.map((value) => h('option', {value, selected: value === app.speed}, `${value}×`)));
  const linked = button('Copy a link to this instant (L)', 'Link', async () => {
    linked.textContent = await app.copyLink() ? 'Copied' : 'Link';
    setTimeout(() => { linked.textContent = 'Link'; }, 1200);
  }, {'data-testid': 'link'});
  host.replaceChildren(
    h('a', {class: 'brand', href: '/', title: 'All runs', onclick: (event) => { event.preventDefault(); if (served) app.openRun(null); }},
      h('img', {src: icon(), alt: 'All runs', width: 22, height: 22})),
    comparison ? differenceLine(app) : runLine(app),
    position,
    h('div', {class: 'transport', role: 'group', 'aria-label': 'Move through the run'},
      button('First (Home)', sign('first'), () => app.jump(0), {class: 'wide-only'}),
      button('Back (←)', sign('back'), () => app.stepBy(-1), {'data-testid': 'back'}),
      play,
      button('On (→)', sign('on'), () => app.stepBy(1), {'data-testid': 'on'}),
      button('Last (End)', sign('last'), () => app.jump(data.size - 1), {class: 'wide-only'}),
      speed),
    h('div', {class: 'transport'},
      served && button('Compare with another run (C)', 'Compare', () => app.dialogs.compare.open(), {'data-testid': 'compare'}),
      served && !comparison && button('What if? (X)', 'What if', () => app.dialogs.what_if.open(), {'data-testid': 'what-if-open'}),
      linked,
      button('Light or dark (T)', sign('theme'), () => app.toggleTheme(), {'data-testid': 'theme'}),
      button('Keys (?)', '?', () => app.dialogs.help.open(), {'data-testid': 'help'})));
  return {
    render({n}) {
      for (const [id, shown] of [['live', app.live], ['trouble', !app.live]]) {
        const badge = host.querySelector(`[data-testid=${id}]`);
        if (badge) badge.hidden = !shown;
      }
      position.replaceChildren(h('b', {}, seconds(app.time ?? data.t[n])), ` #${grouped(n)} of ${grouped(data.size - 1)}`,
        h('span', {class: 'state'}, data.state(n) ?? ''));
      play.replaceChildren(sign(app.playing ? 'pause' : 'play'));
      play.setAttribute('aria-pressed', String(app.playing));
    },
  };
}

function runLine(app) {
  const {summary} = app.data, bad = summary.met < summary.expected;
  return h('div', {class: 'what'},
    h('h1', {title: app.id}, app.title, h('span', {class: 'with'}, `${summary.machine} · ${summary.scene}`)),
    h('p', {class: bad ? 'verdict bad' : 'verdict', 'data-testid': 'verdict'}, `${bad ? '✘' : '✔'} ${verdict(summary)}`,
      h('span', {class: 'badge live', 'data-testid': 'live', hidden: true}, '● live'),
      summary.trouble && h('span', {'data-testid': 'trouble'}, h('span', {class: 'badge warn'}, 'cut short'), h('span', {class: 'why-cut'}, summary.trouble))));
}

// What makes the difference, in one sentence.
function differenceLine(app) {
  const {told, side} = app.comparison;
  return h('div', {class: 'what compared'},
    h('h1', {}, h('span', {class: 'side'}, 'A'), ` ${app.id} `, h('span', {class: 'side'}, 'B'), ` ${side.id}`),
    h('p', {class: told.same ? 'verdict' : 'verdict bad', 'data-testid': 'verdict', title: told.sentence}, `${told.same ? '=' : '≠'} ${brief(told.sentence)}`));
}
