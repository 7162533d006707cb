// The start page: all runs, the newest first, a search, and the choice of two to compare.
import {h, clock, icon, counted, grouped} from '../dom.js';
import {formatAddress, fresh, linkTo} from '../model.js';
import {pairOf} from '../run/pairs.js';
import {fetchRuns, fetchWords, pictureOf, served} from '../run/run_client.js';
import {fetchSessions} from '../talk/session_client.js';
import {toggleTheme} from '../theme.js';
import {comparisonsOf, linesFound, linesWith} from './start_site.js';

const again_ms = 1500; // while runs are being read, or written
const at_most = 200; // lines in the page; the rest is found by searching

const columns = ['Choose', 'Scene', 'Run', 'Verdict', 'Length', 'Said', 'Acts', 'Refused', 'Machine, scene', 'Changed'];
const unseen_columns = ['Choose', 'Scene'];
const number_columns = ['Length', 'Said', 'Acts', 'Refused'];

export class StartPage {
  refusal = 'The runs cannot be listed';
  #host;
  #model;
  #runs = null; // null before they are known
  #words = null; // of a site: what was said, shown and done in each run
  #sessions = new Map(); // run -> the live session that writes it
  #chosen = []; // ids of at most two runs
  #pictures = new Pictures();
  #timer = 0;
  #closed = false;
  #lead = h('p', {class: 'lead'}, 'Looking for runs …');
  #search = h('input', {
    type: 'search',
    placeholder: 'Search  ( / )',
    'aria-label': 'Search runs',
    'data-testid': 'search',
    spellcheck: 'false',
    autocomplete: 'off',
    oninput: () => this.#model.go({search: this.#search.value}, 'slide'),
  });
  #compare = h(
    'button',
    {
      type: 'button',
      class: 'primary',
      disabled: true,
      'data-testid': 'compare-chosen',
      onclick: () => this.#model.open(...this.#pair()),
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
  #rows = h('tbody', {});
  #comparisons = h('div', {});
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
    const heads = columns.map((title) => {
      const shown = unseen_columns.includes(title) ? h('span', {class: 'unseen'}, title) : title;
      return h('th', {scope: 'col', class: number_columns.includes(title) ? 'number' : null}, shown);
    });
    this.#table.append(h('table', {'data-testid': 'runs'}, h('thead', {}, h('tr', {}, heads)), this.#rows));
    const logo = h('img', {src: icon(), alt: '', width: 28, height: 28});
    const tools = h('div', {class: 'tools'}, this.#search, this.#compare, this.#hint);
    const title = h('h1', {}, logo, 'Continua', this.#record);
    this.#host.replaceChildren(h('main', {class: 'start'}, title, this.#lead, tools, this.#table, this.#comparisons));
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
  }
  onKey(key) {
    if (key === '/') this.#search.focus();
    else if (key === 't') toggleTheme();
    else return false;
    return true;
  }

  render() {
    if (!this.#runs) return;
    const {search} = this.#model.selection;
    const words = search.toLowerCase().split(/\s+/).filter(Boolean);
    if (this.#search.value !== search) this.#search.value = search;
    const found = this.#runs.filter(
      (run) => words.every((word) => searched(run).includes(word)) || this.#lines(run, words).length,
    );
    const shown = found.slice(0, at_most);
    const all = this.#runs.length;
    this.#lead.replaceChildren(...leadWords(all));
    this.#table.hidden = !found.length;
    this.#search.parentElement.hidden = !all;
    this.#rows.replaceChildren(...shown.map((run) => this.#row(run, words)));
    const rest = found.length > at_most ? `, the first ${at_most} shown` : '';
    this.#hint.textContent = words.length || rest ? `${grouped(found.length)} of ${grouped(all)}${rest}` : '';
    this.#showChosen();
  }

  #lines = (run, words) => linesWith(this.#words?.[run.id] ?? [], words);

  #row(run, words) {
    const readable = !run.error && !run.pending;
    const address = pictureOf(run.id, pictureTime(run), '192x108');
    const picture = served && readable && run.drawable ? this.#pictures.picture(address) : null;
    return h(
      'tr',
      {'data-testid': 'run'},
      h('td', {}, readable && this.#box(run)),
      h('td', {class: 'pictured'}, picture),
      h(
        'td',
        {},
        readable ? this.#link(run) : h('span', {class: 'name'}, run.name),
        run.what_if_of && h('span', {class: 'badge'}, `what if of ${run.what_if_of}`),
        linesFound(run, this.#lines(run, words)),
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
      this.#chosen = (box.checked ? [...others, run.id] : others).slice(-2);
      this.#showChosen();
    });
    return box;
  }
  #link(run) {
    const link = h('a', {class: 'name', href: linkTo(formatAddress(fresh(run.id)))}, run.name);
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
      grouped((run.refusals ?? 0) - (run.refused_samples ?? 0)),
    ];
    const follow = session && [' ', h('a', {href: `/live/${encodeURIComponent(session)}`}, 'Follow')];
    const changed = run.changed
      ? h('time', {datetime: new Date(run.changed * 1000).toISOString()}, when(run.changed))
      : '';
    return [
      h('td', {}, h('span', {class: `badge ${verdict.kind}`, title: run.trouble || null}, verdict.text), follow),
      numbers.map((value) => h('td', {class: 'number'}, run.pending ? '' : value)),
      h('td', {}, run.machine ?? '', h('span', {class: 'scene-name'}, run.scene ?? '')),
      h('td', {class: 'when'}, changed),
    ];
  }

  #showChosen() {
    for (const box of this.#rows.querySelectorAll('input[type=checkbox]')) box.checked = this.#chosen.includes(box.run);
    const pair = this.#pair();
    this.#compare.disabled = !pair;
    this.#compare.textContent =
      this.#chosen.length === 1 ? 'Choose one more' : pair || !this.#chosen.length ? 'Compare' : 'Not compared here';
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

const leadWords = (runs) =>
  runs
    ? [
        `${counted(runs, 'recorded run')}. Open one to see what was said, shown and done, and why; or choose two to see where they part.`,
      ]
    : [
        'No runs here yet. Make one with ',
        h('code', {}, 'continua replay TRACE -o FOLDER'),
        '; files named ',
        h('code', {}, '*.run.jsonl'),
        ' or ',
        h('code', {}, '*.run.jsonl.gz'),
        ' in the served folders appear here.',
      ];

// Pictures are drawn by the server, which takes a while: one after the other, those in sight, so that nothing else waits.
class Pictures {
  #waiting = [];
  #busy = false;
  #seen = new IntersectionObserver((entries) => {
    for (const {target, isIntersecting} of entries) {
      if (!isIntersecting) continue;
      this.#seen.unobserve(target);
      this.#waiting.push(target);
    }
    this.#next();
  });
  #known = new Map();

  picture(address) {
    if (!this.#known.has(address)) {
      const image = h('img', {class: 'thumbnail', alt: '', width: 96, height: 54});
      image.wanted = address;
      this.#known.set(address, image);
      this.#seen.observe(image);
    }
    return this.#known.get(address);
  }
  close() {
    this.#seen.disconnect();
    this.#waiting = [];
  }
  #next() {
    if (this.#busy) return;
    const image = this.#waiting.shift();
    if (!image) return;
    const done = (drawn) => {
      this.#busy = false;
      if (!drawn) image.remove();
      this.#next();
    };
    this.#busy = true;
    image.onload = () => done(true);
    image.onerror = () => done(false);
    image.src = image.wanted;
  }
}

// The instant shown in small: where the page would open, else the middle.
const pictureTime = (run) => (run.first_t ?? (run.duration ?? 0) / 2).toFixed(3);

function verdictOf(run) {
  if (run.error) return {kind: 'bad', text: 'unreadable'};
  if (run.pending) return {kind: '', text: 'being read'};
  if (run.live) return {kind: 'live', text: '● live'};
  if (run.met < run.expected)
    return {kind: 'bad', text: `✘ ${run.expected - run.met} of ${run.expected} not as expected`};
  if (run.trouble || !run.complete) return {kind: 'warn', text: '! cut short'};
  if (run.problems) return {kind: 'warn', text: `! ${counted(run.problems, 'problem')}`};
  if (run.expected) return {kind: 'good', text: '✔ as expected'};
  return {kind: '', text: 'complete'};
}

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
