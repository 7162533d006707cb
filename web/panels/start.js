// The start page: all runs, the newest first, a search, and the choice of two to compare.
import {h, clock, icon, counted, grouped} from '../dom.js';
import {formatAddress, fresh, linkTo} from '../model.js';
import {pairOf} from '../run/pairs.js';
import {fetchRuns, fetchWords, pictureOf, served} from '../run/run_client.js';
import {failuresOf, verdictOf} from '../run/verdict.js';
import {fetchSessions} from '../talk/session_client.js';
import {helpDialog} from '../keys.js';
import {toggleTheme} from '../theme.js';
import {Arrangement} from './start_arrangement.js';
import {mountDrop} from './start_drop.js';
import {compareMany} from './start_many.js';
import {Pictures} from './start_pictures.js';
import {Rows} from './start_rows.js';
import {comparisonsOf, linesFound, linesWith} from './start_site.js';

const again_ms = 1500; // while runs are being read, or written

const letters = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ';
const own_keys = [
  [[], '/', 'search'],
  [[], 'Enter', 'in the search: open the first run'],
  [[], '↓ ↑', 'from run to run'],
  [[], 'T', 'light or dark'],
  [[], '?', 'this help'],
];
const own_help = 'A heading of the table sorts by it, and again the other way round.';

/** A name that breaks after the marks in it rather than anywhere. */
const breakable = (name) => name.split(/(?<=[/._])/).flatMap((part) => [h('wbr'), part]);

export class StartPage {
  refusal = 'The runs cannot be listed';
  #host;
  #model;
  #runs = null; // null before they are known
  #words = null; // of a site: what was said, shown and done in each run
  #sessions = new Map(); // run -> the live session that writes it
  #chosen = []; // ids of runs, in the order in which they were chosen
  #pictures = new Pictures();
  #timer = 0;
  #closed = false;
  #lead = h('div', {class: 'lead'}, 'Looking for runs …');
  #search = h('input', {
    type: 'search',
    placeholder: 'Search  ( / )',
    'aria-label': 'Search runs',
    'data-testid': 'search',
    spellcheck: 'false',
    autocomplete: 'off',
    oninput: () => this.#model.go({search: this.#search.value}, 'slide'),
    onkeydown: (event) => {
      const first = this.#grid.querySelector('a.name');
      if (event.key === 'Enter') first?.click();
      else if (event.key === 'ArrowDown') first?.focus();
      else return;
      event.preventDefault();
    },
  });
  #compare = h(
    'button',
    {
      type: 'button',
      class: 'primary',
      disabled: true,
      'data-testid': 'compare-chosen',
      onclick: () => this.#compareChosen(),
    },
    'Compare',
  );
  #record = h(
    'a',
    {
      class: 'button primary',
      href: '/live',
      hidden: true,
      'data-testid': 'record-session',
      title: 'Talk and point to the avatar',
    },
    'Record a session',
  );
  #hint = h('span', {class: 'muted', role: 'status'});
  #drop = mountDrop((run) => this.#model.open(run));
  #found = []; // the runs that are shown
  #words_sought = [];
  #grid = h('table', {'data-testid': 'runs', onkeydown: (event) => this.#walk(event)});
  #rows = new Rows(
    this.#grid,
    (i) => [this.#arrangement.heading(this.#found[i], this.#found[i - 1]), this.#row(this.#found[i])],
    () => this.#showChosen(),
  );
  #arrangement = new Arrangement(() => this.render());
  #help = helpDialog(own_keys, own_help);
  #comparisons = h('div', {});
  #nothing = h(
    'p',
    {class: 'empty', hidden: true, 'data-testid': 'nothing-found'},
    'No run fits. ',
    h('button', {type: 'button', class: 'link', onclick: () => this.#showAll()}, 'Show all'),
  );
  #table = h('div', {
    class: served ? 'table' : 'table exported',
    role: 'region',
    'aria-label': 'Runs',
    tabindex: 0,
    hidden: true,
  });

  constructor(host, model) {
    this.#host = host;
    this.#model = model;
  }

  #build() {
    document.title = 'Continua';
    const heads = h('thead', {}, h('tr', {}, this.#arrangement.heads));
    this.#grid.append(heads);
    this.#table.append(this.#grid);
    const logo = h('img', {src: icon(), alt: '', width: 28, height: 28});
    const button = (label, shown, act) =>
      h('button', {type: 'button', title: label, 'aria-label': label, onclick: act}, shown);
    const own = h(
      'span',
      {class: 'own-tools'},
      served && this.#drop.button,
      button('Light or dark (T)', '◐', toggleTheme),
      button('Keys (?)', '?', this.#help.open),
    );
    const tools = h('div', {class: 'tools'}, this.#search, this.#arrangement.filters, this.#compare, this.#hint);
    const title = h('h1', {}, logo, 'Continua', this.#record, own);
    const parts = [title, this.#lead, this.#drop.said, tools, this.#table, this.#nothing, this.#comparisons];
    const main = h('main', {class: 'start'}, parts);
    if (served) this.#drop.listen(main);
    this.#host.replaceChildren(main, this.#help.element);
  }

  async load() {
    this.#build();
    await this.#read();
  }
  async #read() {
    const sessions = served ? fetchSessions().catch(() => null) : null;
    const [runs, words, live] = await Promise.all([fetchRuns(), fetchWords(), sessions]);
    if (this.#closed) return;
    this.#runs = runs;
    this.#words = words;
    this.#comparisons.replaceChildren(comparisonsOf(runs) ?? '');
    this.#record.hidden = !live;
    this.#sessions = new Map((live?.sessions ?? []).filter((one) => one.live).map((one) => [one.run, one.id]));
    this.render();
    if (runs.some((run) => run.pending || run.live))
      this.#timer = setTimeout(() => this.#read().catch(() => {}), again_ms);
  }
  close() {
    this.#closed = true;
    clearTimeout(this.#timer);
    this.#pictures.close();
    this.#rows.close();
  }
  onKey(key) {
    if (key === '/') this.#search.focus();
    else if (key === 't') toggleTheme();
    else if (key === '?') this.#help.open();
    else if (key === 'ArrowDown') this.#grid.querySelector('a.name')?.focus();
    else return false;
    return true;
  }

  // The arrows go from run to run, and up from the first to the search.
  #walk(event) {
    const by = {ArrowDown: 1, ArrowUp: -1}[event.key];
    if (!by || !event.target.matches('a.name')) return;
    event.preventDefault();
    const links = this.#rows.links('a.name');
    (links[links.indexOf(event.target) + by] ?? (by < 0 ? this.#search : event.target)).focus();
  }

  render() {
    if (!this.#runs) return;
    const {search} = this.#model.selection;
    const words = search.toLowerCase().split(/\s+/).filter(Boolean);
    if (this.#search.value !== search) this.#search.value = search;
    this.#arrangement.learn(this.#runs);
    const found = this.#arrangement.arranged(
      this.#runs.filter((run) => words.every((word) => searched(run).includes(word)) || this.#lines(run, words).length),
    );
    const all = this.#runs.length;
    this.#lead.replaceChildren(...leadWords(all));
    this.#table.hidden = !found.length;
    this.#search.parentElement.hidden = !all;
    this.#nothing.hidden = found.length > 0 || !all;
    const focused = this.#grid.contains(document.activeElement) && document.activeElement.getAttribute('href');
    this.#found = found;
    this.#words_sought = words;
    this.#rows.show(found);
    if (focused) this.#grid.querySelector(`a[href="${CSS.escape(focused)}"]`)?.focus();
    this.#hint.textContent = found.length < all ? `${grouped(found.length)} of ${grouped(all)}` : '';
  }

  #lines = (run, words) => linesWith(this.#words?.[run.id] ?? [], words);

  #row(run) {
    const readable = !run.error && !run.pending;
    const address = pictureOf(run.id, pictureTime(run), '120x120');
    const picture = served && readable && run.drawable ? this.#pictures.picture(address) : null;
    return h(
      'tr',
      {'data-testid': 'run'},
      h('td', {}, readable && this.#box(run)),
      h('td', {class: 'pictured'}, picture),
      h(
        'td',
        {class: 'named'},
        readable ? this.#link(run) : h('span', {class: 'name'}, run.name),
        run.what_if_of && h('span', {class: 'badge'}, `what if of ${run.what_if_of}`),
        linesFound(run, this.#lines(run, this.#words_sought)),
      ),
      run.error ? h('td', {colspan: 7, class: 'trouble'}, run.error.message) : this.#facts(run),
    );
  }
  #box(run) {
    const box = h('input', {
      type: 'checkbox',
      'aria-label': `Choose ${run.name} to compare`,
      'data-testid': 'choose',
      checked: this.#chosen.includes(run.id),
    });
    box.run = run.id;
    box.addEventListener('change', () => {
      const others = this.#chosen.filter((id) => id !== run.id);
      this.#chosen = box.checked ? [...others, run.id] : others;
      this.#showChosen();
    });
    return [box, h('span', {class: 'side', 'aria-hidden': 'true'})];
  }
  #link(run) {
    const link = h('a', {class: 'name', href: linkTo(formatAddress(fresh(run.id)))}, breakable(run.name));
    link.addEventListener('click', (event) => {
      if (event.ctrlKey || event.metaKey || event.shiftKey) return;
      event.preventDefault();
      this.#model.open(run.id);
    });
    return link;
  }
  #facts(run) {
    const verdict = verdictOf(run);
    const session = this.#sessions.get(run.id);
    const numbers = [
      clock(run.duration ?? 0),
      grouped(run.utterances ?? 0),
      grouped(run.acts ?? 0),
      grouped(run.refusals ?? 0),
    ];
    const follow = session && [' ', h('a', {href: `/live/${encodeURIComponent(session)}`}, 'Follow')];
    const changed = run.changed
      ? h('time', {datetime: new Date(run.changed * 1000).toISOString()}, when(run.changed))
      : '';
    return [
      h(
        'td',
        {},
        h(
          'span',
          {class: `badge ${verdict.kind}`, title: [...failuresOf(run), run.trouble].filter(Boolean).join('; ') || null},
          verdict.text,
        ),
        follow,
      ),
      numbers.map((value) => h('td', {class: 'number'}, run.pending ? '' : value)),
      h('td', {}, run.machine ?? '', h('span', {class: 'scene-name'}, run.scene ?? '')),
      h('td', {class: 'when'}, changed),
    ];
  }

  #showChosen() {
    for (const box of this.#grid.querySelectorAll('input[type=checkbox]')) {
      const place = this.#chosen.indexOf(box.run);
      box.checked = place >= 0;
      box.nextSibling.textContent = place < 0 ? '' : (letters[place] ?? `${place + 1}`);
    }
    const many = served && this.#chosen.length > 2;
    const pair = this.#chosen.length === 2 && this.#pair();
    this.#compare.disabled = !pair && !many;
    this.#compare.textContent = many
      ? `Compare ${this.#chosen.length} with A`
      : this.#chosen.length === 1
        ? 'Choose one more'
        : pair || !this.#chosen.length
          ? 'Compare'
          : 'Not compared here';
  }
  #compareChosen() {
    if (this.#chosen.length === 2) this.#model.open(...this.#pair());
    else compareMany(this.#chosen.map((id) => this.#runs.find((run) => run.id === id)).filter(Boolean));
  }
  #showAll() {
    this.#arrangement.reset();
    this.#model.go({search: ''}, 'slide');
    this.render();
    this.#search.focus();
  }
  /** The ids of the chosen two, if they can be compared. */
  #pair() {
    const [a, b] = this.#chosen.map((id) => this.#runs.find((run) => run.id === id));
    return a && b ? pairOf(a, b) : null;
  }
}

// The text of a run that a search looks through.
const searched = (run) =>
  `${run.name} ${run.trace ?? ''} ${run.machine ?? ''} ${run.scene ?? ''} ${verdictOf(run).text}`.toLowerCase();

const code = (text) => h('code', {}, text);
function leadWords(runs) {
  if (runs)
    return [
      `${counted(runs, 'recorded run')}. Open one to see what was said, shown and done, and why; or choose two to see where they part.`,
    ];
  return [
    'No runs here yet. Three ways to one:',
    h(
      'ul',
      {class: 'ways', 'data-testid': 'no-runs'},
      served && h('li', {}, h('a', {href: '/live'}, 'Talk to the avatar'), ': the conversation is recorded as a run.'),
      served && h('li', {}, 'Drop a run log or a trace on this page; a trace is replayed.'),
      h(
        'li',
        {},
        'Replay traces into the folder that is served: ',
        code('continua replay TRACE -o FOLDER'),
        '. Files named ',
        code('*.run.jsonl'),
        ' or ',
        code('*.run.jsonl.gz'),
        ' in it appear here.',
      ),
    ),
  ];
}

// The instant shown in small: the last, at which runs differ most.
const pictureTime = (run) => (Math.floor(1000 * (run.duration ?? 0)) / 1000).toFixed(3);

/** "today 14:03", "yesterday 9:15", "3 Oct 2025" */
function when(seconds) {
  const then = new Date(seconds * 1000);
  const now = new Date();
  const days = Math.round((new Date(now.toDateString()) - new Date(then.toDateString())) / 86400000);
  const time = then.toLocaleTimeString([], {hour: '2-digit', minute: '2-digit'});
  if (days === 0) return `today ${time}`;
  if (days === 1) return `yesterday ${time}`;
  return then.toLocaleDateString([], {day: 'numeric', month: 'short', year: 'numeric'});
}
