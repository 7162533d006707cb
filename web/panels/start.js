// The start page: all runs, the newest first; search; two of them held against each other.
import {h, clock, icon, counted, grouped} from '../dom.js';
import {fetchRuns, pictureOf} from '../run/run_client.js';
import {fetchSessions} from '../talk/session_client.js';

const again_ms = 1500;   // while runs are being read, or written
const at_most = 200;     // lines in the page; the rest is found by searching

export class StartPage {
  constructor(host, app) {
    this.app = app;
    this.runs = [];
    this.sessions = new Map();   // run -> the live session that writes it
    this.chosen = [];
    this.pictures = new Pictures();
    document.title = 'Continua';
    this.lead = h('p', {class: 'lead'}, 'Looking for runs …');
    this.search = h('input', {type: 'search', placeholder: 'Search  ( / )', 'aria-label': 'Search runs', 'data-testid': 'search', spellcheck: 'false', autocomplete: 'off',
      oninput: () => app.model.go({search: this.search.value}, 'slide')});
    this.compare = h('button', {type: 'button', class: 'primary', disabled: true, 'data-testid': 'compare-chosen', onclick: () => app.openRun(...this.chosen)}, 'Compare');
    this.record = h('a', {class: 'button primary', href: '/live', hidden: true, 'data-testid': 'record-session', title: 'Talk and point to the avatar'}, 'Record a session');
    this.hint = h('span', {class: 'muted', role: 'status'});
    this.body = h('tbody', {});
    this.table = h('div', {class: 'table', role: 'region', 'aria-label': 'Runs', tabindex: 0, hidden: true},
      h('table', {'data-testid': 'runs'}, h('thead', {}, h('tr', {}, ['Choose', 'Scene', 'Run', 'Verdict', 'Length', 'Said', 'Acts', 'Refused', 'Machine, scene', 'Changed'].map((title, i) =>
        h('th', {scope: 'col', class: i >= 4 && i <= 7 ? 'number' : null}, i < 2 ? h('span', {class: 'unseen'}, title) : title)))), this.body));
    host.replaceChildren(h('main', {class: 'start'},
      h('h1', {}, h('img', {src: icon(), alt: '', width: 28, height: 28}), 'Continua', this.record), this.lead,
      h('div', {class: 'tools'}, this.search, this.compare, this.hint), this.table));
  }

  async load() {
    const [runs, live] = await Promise.all([fetchRuns(), fetchSessions().catch(() => null)]);
    this.runs = runs;
    this.record.hidden = !live;
    this.sessions = new Map((live?.sessions ?? []).filter((one) => one.live).map((one) => [one.run, one.id]));
    this.render(this.app.model.selection);
    if (this.runs.some((run) => run.pending || run.live)) this.timer = setTimeout(() => this.load().catch(() => {}), again_ms);
  }
  close() {
    clearTimeout(this.timer);
    this.pictures.close();
  }
  onKey(key) {
    if (key === '/') this.search.focus();
    if (key === 't') this.app.toggleTheme();
  }

  render({search}) {
    const {runs} = this, words = search.toLowerCase().split(/\s+/).filter(Boolean);
    if (this.search.value !== search) this.search.value = search;
    const told = (run) => `${run.name} ${run.trace ?? ''} ${run.machine ?? ''} ${run.scene ?? ''} ${verdictOf(run).text}`.toLowerCase();
    const found = runs.filter((run) => words.every((word) => told(run).includes(word)));
    this.lead.replaceChildren(...(runs.length
      ? [`${counted(runs.length, 'recorded run')}. Open one to see what was said, shown and done, and why; or choose two to see where they part.`]
      : ['No runs here yet. Make one with ', h('code', {}, 'continua replay TRACE -o FOLDER'), '; files named ', h('code', {}, '*.run.jsonl'), ' in the served folders appear here.']));
    this.table.hidden = !found.length;
    this.search.parentElement.hidden = !runs.length;
    this.body.replaceChildren(...found.slice(0, at_most).map((run) => this.row(run)));
    this.hint.textContent = words.length || found.length > at_most ? `${grouped(found.length)} of ${grouped(runs.length)}${found.length > at_most ? `, the first ${at_most} shown` : ''}` : '';
    this.tellChosen();
  }

  row(run) {
    const open = (event) => {
      if (event.ctrlKey || event.metaKey || event.shiftKey) return;
      event.preventDefault();
      this.app.openRun(run.id);
    };
    const readable = !run.error && !run.pending;
    const box = readable && h('input', {type: 'checkbox', 'aria-label': `Choose ${run.name} to compare`, 'data-testid': 'choose', checked: this.chosen.includes(run.id),
      onchange: () => { this.chosen = this.chosen.filter((id) => id !== run.id).concat(box.checked ? [run.id] : []).slice(-2); this.tellChosen(); }});
    if (box) box.run = run.id;
    const picture = readable && run.drawable && this.pictures.picture(pictureOf(run.id, pictureTime(run), '192x108'));
    const verdict = verdictOf(run);
    return h('tr', {'data-testid': 'run'}, h('td', {}, box || null), h('td', {class: 'pictured'}, picture || null),
      h('td', {}, readable ? h('a', {class: 'name', href: `/r/${encodeURIComponent(run.id)}`, onclick: open}, run.name) : h('span', {class: 'name'}, run.name),
        run.what_if_of && h('span', {class: 'badge'}, `what if of ${run.what_if_of}`)),
      run.error ? h('td', {colspan: 7, class: 'trouble'}, run.error.message)
        : [h('td', {}, h('span', {class: `badge ${verdict.kind}`, title: run.trouble || null}, verdict.text),
             this.sessions.has(run.id) && [' ', h('a', {href: `/live/${encodeURIComponent(this.sessions.get(run.id))}`}, 'Follow')]),
           [clock(run.duration ?? 0), grouped(run.utterances ?? 0), grouped(run.acts ?? 0), grouped((run.refusals ?? 0) - (run.refused_samples ?? 0))].map((value) => h('td', {class: 'number'}, run.pending ? '' : value)),
           h('td', {}, run.machine ?? '', h('span', {class: 'scene-name'}, run.scene ?? '')), h('td', {class: 'when'}, run.changed ? h('time', {datetime: new Date(run.changed * 1000).toISOString()}, when(run.changed)) : '')]);
  }

  tellChosen() {
    for (const box of this.body.querySelectorAll('input[type=checkbox]')) box.checked = this.chosen.includes(box.run);
    this.compare.disabled = this.chosen.length < 2;
    this.compare.textContent = this.chosen.length === 1 ? 'Choose one more' : 'Compare';
  }
}

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
  if (run.met < run.expected) return {kind: 'bad', text: `✘ ${run.expected - run.met} of ${run.expected} not as expected`};
  if (run.trouble || !run.complete) return {kind: 'warn', text: '! cut short'};
  if (run.problems) return {kind: 'warn', text: `! ${counted(run.problems, 'problem')}`};
  if (run.expected) return {kind: 'good', text: '✔ as expected'};
  return {kind: '', text: 'complete'};
}

/** "today 14:03", "yesterday 9:15", "3 Oct 2025" */
function when(seconds) {
  const then = new Date(seconds * 1000), now = new Date();
  const days = Math.round((new Date(now.toDateString()) - new Date(then.toDateString())) / 86400000);
  const time = then.toLocaleTimeString([], {hour: '2-digit', minute: '2-digit'});
  if (days === 0) return `today ${time}`;
  if (days === 1) return `yesterday ${time}`;
  return then.toLocaleDateString([], {day: 'numeric', month: 'short', year: 'numeric'});
}
