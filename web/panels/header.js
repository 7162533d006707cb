// The top line: the run and how it went, where the cursor stands, and the buttons.
import {h, s, brief, clock, icon, grouped, instant} from '../dom.js';
import {copyLink} from '../announce.js';
import {linkTo} from '../model.js';
import {listed, served} from '../run/run_client.js';
import {failuresOf, verdictLine} from '../run/verdict.js';
import {toggleTheme} from '../theme.js';

const icons = {
  first: 'M3 3h2v10H3zM13 3v10L6 8z',
  back: 'M11 3v10L4 8z',
  play: 'M4 2.5v11l9-5.5z',
  pause: 'M4 3h3v10H4zM9 3h3v10H9z',
  on: 'M5 3v10l7-5z',
  last: 'M11 3h2v10h-2zM3 3v10l7-5z',
  theme: 'M8 2a6 6 0 1 0 0 12a6 6 0 1 0 0-12zM8 3.5v9a4.5 4.5 0 0 0 0-9z',
};
const sign = (name) =>
  s(
    'svg',
    {viewBox: '0 0 16 16', width: 14, height: 14, 'aria-hidden': 'true'},
    s('path', {d: icons[name], fill: 'currentColor', 'fill-rule': 'evenodd'}),
  );

const speeds = [0.5, 1, 2, 5, 20];
const copied_ms = 1200; // how long the button says so

const button = (label, shown, action, props) =>
  h('button', {type: 'button', title: label, 'aria-label': label, onclick: action, ...props}, shown);

/** Fills `host` with the line of `page`, a RunPage, which knows whether its run still grows. */
export function mountHeader(host, page, dialogs) {
  const {data, cursor, model, comparison} = page;
  const position = h('button', {
    type: 'button',
    class: 'position',
    title: 'Go to an instant, a record or a state (#)',
    'data-testid': 'position',
    onclick: () => dialogs.go_to.open(),
  });
  const play = button('Play (Space)', sign('play'), () => cursor.play(), {
    'data-testid': 'play',
    'aria-pressed': 'false',
  });
  const home = h(
    'a',
    {class: 'brand', href: linkTo('/'), title: 'All runs'},
    h('img', {src: icon(), alt: 'All runs', width: 22, height: 22}),
  );
  home.addEventListener('click', (event) => {
    event.preventDefault();
    if (listed) model.open(null);
  });
  host.replaceChildren(
    home,
    comparison ? differenceLine(page) : runLine(page),
    position,
    transport(cursor, play),
    tools(dialogs, comparison),
  );
  return {
    render({n}) {
      showGrowth(host, page.live);
      position.replaceChildren(
        h('b', {}, instant(cursor.time)),
        ` of ${clock(data.duration)} · #${grouped(n)} of ${grouped(data.size)}`,
        h('span', {class: 'state'}, data.state(n) ?? ''),
      );
      play.replaceChildren(sign(cursor.playing ? 'pause' : 'play'));
      play.setAttribute('aria-pressed', String(cursor.playing));
    },
  };
}

// A run that is being written has no trouble yet: it only lacks its end.
function showGrowth(host, live) {
  for (const [id, shown] of Object.entries({live, trouble: !live})) {
    const badge = host.querySelector(`[data-testid=${id}]`);
    if (badge) badge.hidden = !shown;
  }
}

function transport(cursor, play) {
  const speed = h(
    'select',
    {'aria-label': 'Speed', title: 'Speed'},
    speeds.map((value) => h('option', {value, selected: value === cursor.speed}, `${value}×`)),
  );
  speed.addEventListener('change', () => {
    cursor.speed = Number(speed.value);
  });
  return h(
    'div',
    {class: 'transport', role: 'group', 'aria-label': 'Move through the run'},
    button('First (Home)', sign('first'), () => cursor.jump(0), {class: 'wide-only'}),
    button('Back (←)', sign('back'), () => cursor.stepBy(-1), {'data-testid': 'back'}),
    play,
    button('On (→)', sign('on'), () => cursor.stepBy(1), {'data-testid': 'on'}),
    button('Last (End)', sign('last'), () => cursor.jump(cursor.data.size - 1), {class: 'wide-only'}),
    speed,
  );
}

function tools(dialogs, comparison) {
  const linked = button('Copy a link to this instant (L)', 'Link', copyIt, {'data-testid': 'link'});
  async function copyIt() {
    linked.textContent = (await copyLink()) ? 'Copied' : 'Link';
    setTimeout(() => {
      linked.textContent = 'Link';
    }, copied_ms);
  }
  const opens = (name, label, shown, testid) =>
    button(label, shown, () => dialogs[name].open(), {'data-testid': testid});
  return h(
    'div',
    {class: 'transport'},
    listed && opens('compare', 'Compare with another run (C)', 'Compare', 'compare'),
    served && !comparison && opens('what_if', 'What if? (X)', 'What if', 'what-if-open'),
    linked,
    button('Light or dark (T)', sign('theme'), toggleTheme, {'data-testid': 'theme'}),
    opens('help', 'Keys (?)', '?', 'help'),
  );
}

function runLine({id, title, data: {summary}}) {
  const bad = failuresOf(summary).length > 0;
  const line = verdictLine(summary);
  return h(
    'div',
    {class: 'what'},
    h('h1', {title: id}, title, h('span', {class: 'with'}, `${summary.machine} · ${summary.scene}`)),
    h(
      'p',
      {class: bad ? 'verdict bad' : 'verdict', 'data-testid': 'verdict', title: line},
      `${bad ? '✘' : '✔'} ${line}`,
      h('span', {class: 'badge live', 'data-testid': 'live', hidden: true}, '● live'),
      summary.trouble &&
        h(
          'span',
          {'data-testid': 'trouble'},
          h('span', {class: 'badge warn'}, 'cut short'),
          h('span', {class: 'why-cut'}, summary.trouble),
        ),
    ),
  );
}

// The cause of the difference, in one sentence.
function differenceLine({id, comparison: {told, side}}) {
  return h(
    'div',
    {class: 'what compared'},
    h('h1', {}, h('span', {class: 'side'}, 'A'), ` ${id} `, h('span', {class: 'side'}, 'B'), ` ${side.id}`),
    h(
      'p',
      {class: told.same ? 'verdict' : 'verdict bad', 'data-testid': 'verdict', title: told.sentence},
      `${told.same ? '=' : '≠'} ${brief(told.sentence)}`,
    ),
  );
}
