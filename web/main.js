// The page: reads the address, fetches what it names, sets up the panels and keeps them in step with the selection.
import {h} from './dom.js';
import {fresh, Model} from './model.js';
import {readColumns} from './run/columns.js';
import {RunData} from './run/run_data.js';
import {Labels} from './run/labels.js';
import {Comparison} from './run/comparison.js';
import {fetchDiff, fetchRun, listenTo, RecordClient, served} from './run/run_client.js';
import {calmly} from './calmly.js';
import {onKey} from './keys.js';
import {buildRunPage} from './run_page.js';
import {StartPage} from './panels/start.js';
import {LivePage} from './talk/live_page.js';

const page = document.getElementById('page');
const sentence = document.getElementById('sentence');
const grow_ms = 700;        // between readings of a run that grows
const first_window_s = 40;  // what the timeline shows at first of a run longer than that

class App {
  constructor() {
    this.speed = 1;
    this.playing = false;
    this.panels = [];
    this.data = null;
    this.model = new Model((before) => this.changed(before));
    document.addEventListener('keydown', (event) => onKey(this, event));
    page.addEventListener('enlarge', (event) => this.enlarge(event.detail));
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.render());
    this.open();
  }

  /** Fetches what the address names and builds the page for it; the body says when all of it is there. */
  async open() {
    delete document.body.dataset.ready;
    await this.show();
    await this.settled();
    performance.mark('settled');
    document.body.dataset.ready = '';
  }

  async show() {
    const {run, other, live} = this.model.selection;
    const stale = () => elsewhere(this.model.selection, {run, other, live});
    this.close();
    page.replaceChildren(h('p', {class: 'loading'}, 'Loading…'));
    try {
      if (live !== undefined) {
        this.live_page = new LivePage(page, this);
        await this.live_page.load();
        return;
      }
      if (run === null) {
        this.start = new StartPage(page, this);
        await this.start.load();
        return;
      }
      const [own, compared, told] = await Promise.all([this.load(run), other === null ? null : this.load(other, true), other === null ? null : fetchDiff(run, other)]);
      if (stale()) return;
      Object.assign(this, own);
      this.comparison = compared && new Comparison(own.data, compared, told);
      this.build();
    } catch (problem) {
      if (stale()) return;
      page.replaceChildren(h('main', {class: 'start'}, h('h1', {}, live !== undefined ? 'There is no conversation here' : other === null ? 'This run cannot be shown' : 'These runs cannot be compared'),
        h('p', {class: 'trouble', 'data-testid': 'problem'}, problem.message), h('p', {}, h('a', {href: '/'}, 'All runs'))));
    }
  }

  /** {data, client, labels} of a run. */
  async load(id) {
    const fetched = await fetchRun(id);
    const client = new RecordClient(id), labels = new Labels(client, () => this.labelsArrived());
    return {id, client, labels, data: new RunData({...fetched, columns: readColumns(fetched.columns), labels})};
  }

  close() {
    this.stop();
    for (const one of this.panels) one.close?.();
    this.start?.close();
    this.live_page?.close();
    this.stream?.close();
    Object.assign(this, {panels: [], start: null, live_page: null, stream: null, data: null, client: null, labels: null, comparison: null, live: false});
  }

  build() {
    const {data, model} = this, {n, zoom} = model.selection;
    this.title = (data.summary.trace || this.id).replace(/(\.trace)?\.jsonl$/, '');
    document.title = `${this.title}${this.comparison ? ' compared' : ''} – Continua`;
    const start = data.clamp(n ?? this.comparison?.start ?? data.summary.first);
    model.settle({n: start, hunk: model.selection.hunk ?? (n === null ? this.comparison?.first ?? null : null), zoom: zoom ?? this.windowAround(start)});
    Object.assign(this, buildRunPage(page, this));
    this.render();
    performance.mark('built');
    if (served && !data.complete && !this.comparison) this.stream = listenTo(this.id, (grown) => this.grown(grown));
  }

  /** A run that is being written has more records: they are shown, and the cursor goes along if it stood at the end. */
  async grown({records, complete, live}) {
    if (!this.data) return;
    this.live = live;
    this.render();
    if (complete) this.stream?.close();
    if (records > this.data.size) this.readOn();
  }
  readOn = calmly(async () => {
    // Not while the reader writes: the page is built anew around that.
    if (document.querySelector('dialog[open]') || document.activeElement?.matches('input, textarea')) { setTimeout(this.readOn, grow_ms); return; }
    const {id, model, client, labels} = this, at_end = model.selection.n >= (this.data?.stops.at(-1) ?? 0);
    const fetched = await fetchRun(id).catch(() => null);
    if (!fetched || this.client !== client) return;
    client.forget();
    this.data = new RunData({...fetched, columns: readColumns(fetched.columns), labels});
    if (at_end) model.settle({n: this.data.stops.at(-1) ?? this.data.size - 1, zoom: this.windowAround(this.data.size - 1)});
    Object.assign(this, buildRunPage(page, this, this));
    this.render();
  }, grow_ms);

  windowAround(n) {
    const {t, duration} = this.data, width = Math.min(first_window_s, duration || 1);
    const from = Math.max(0, Math.min(duration - width, t[n] - width / 3));
    return [from, from + width];
  }

  changed(before) {
    const {selection} = this.model;
    if (elsewhere(before, selection)) { this.open(); return; }
    if (this.start) { this.start.render(selection); return; }
    if (!this.data) return;
    if (selection.n === null) this.model.settle({n: this.data.clamp(this.data.summary.first)});
    this.render();
  }

  render() {
    this.live_page?.render();
    if (!this.data) return;
    const selection = this.model.selection, n = this.data.clamp(selection.n);
    for (const one of this.panels) one.render({...selection, n});
    if (!this.playing) sentence.textContent = this.data.sentence(n);
  }
  labelsArrived() {
    if (!this.data) return;
    for (const one of this.panels) one.labelsArrived?.();
    if (!this.playing) sentence.textContent = this.data.sentence(this.data.clamp(this.model.selection.n));
  }

  /** Resolves when nothing that was asked for is still to come. */
  async settled() {
    for (let quiet = 0; quiet < 2;) {
      await Promise.all([this.client?.idle(), this.comparison?.side.client.idle()]);
      await new Promise((done) => setTimeout(done, 20));
      quiet = (this.labels?.idle ?? true) && (this.comparison?.side.labels.idle ?? true) ? quiet + 1 : 0;
    }
  }

  /** Moves the cursor; the timeline comes along when it would leave it. */
  select(n, how, more = {}) {
    n = this.data.clamp(n);
    const {zoom} = this.model.selection, t = this.data.t[n];
    const change = {n, ...more};
    if (!this.playing) this.time = null;
    if (zoom && (t < zoom[0] || t > zoom[1])) {
      const width = zoom[1] - zoom[0], from = Math.max(0, Math.min(this.data.duration - width, t - width / 3));
      change.zoom = [from, from + width];
    }
    this.model.go(change, how);
  }
  jump(n, more) { this.select(n, 'jump', more); }
  /** To where record n of the other run has its counterpart. */
  jumpOther(n) { this.jump(this.comparison.toOwn(n)); }
  stepBy(by) { this.stop(); this.select(this.data.stop(this.data.stops, this.model.selection.n, by), 'step'); }
  transitionBy(by) { this.stop(); this.select(this.data.stop(this.data.steps.n, this.model.selection.n, by), 'step'); }
  follow(back) {
    const {n} = this.model.selection;
    const to = back ? this.data.cause(n) : this.data.effects(n)[0] ?? -1;
    if (to >= 0) this.jump(to);
  }
  /** To the next (previous) difference; where one run is shown, to the next thing that went wrong. */
  next(by) {
    this.stop();
    if (this.comparison) this.differences.go(by);
    else this.select(this.data.stop(this.data.lanes.flag.n, this.model.selection.n, by), 'jump');
  }

  play() {
    if (this.playing) { this.stop(); return; }
    const {data} = this;
    if (this.model.selection.n >= data.size - 1) this.jump(0);
    this.playing = true;
    let n = this.model.selection.n, last = performance.now();
    this.time = data.t[n];
    const tick = (now) => {
      if (!this.playing || this.data !== data) return;
      if (this.model.selection.n !== n) this.time = data.t[data.clamp(this.model.selection.n)];  // the reader went elsewhere
      this.time += (now - last) / 1000 * this.speed;
      last = now;
      n = Math.max(data.at(this.time), this.model.selection.n);
      if (n === this.model.selection.n) this.render(); else this.select(n, 'slide');
      if (this.time >= data.duration) this.stop(); else requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
    this.render();
  }
  stop() {
    this.time = null;
    if (!this.playing) return;
    this.playing = false;
    this.render();
  }

  async copy(text, done) {
    try {
      await navigator.clipboard.writeText(text);
      sentence.textContent = done;
      return true;
    } catch {
      return false;
    }
  }
  copyLink() { return this.copy(location.href, 'The link was copied.'); }

  /** Brings the panel to the front of its tabs. */
  showTab(tab) { this.model.go({tab, panel: ''}, 'slide'); }
  /** Focuses the panel in this place; lets it fill the page when it has the focus already. */
  focusPanel(place) {
    const [name, part] = Object.entries(this.parts)[place] ?? [];
    if (!part) return;
    if (part.element.contains(document.activeElement)) { this.enlarge(name); return; }
    if (part.element.hidden) this.showTab(name);
    part.element.querySelector('[tabindex="0"], button:not(.larger)')?.focus();
  }
  enlarge(name) { this.model.go({panel: this.model.selection.panel === name ? '' : name}); }
  toggleTheme() {
    setTheme(shownTheme() === 'dark' ? 'light' : 'dark');
    this.render();
  }
  openRun(run, other = null) { this.model.go(fresh(run, other)); }
}

/** Whether two selections are of different pages. */
const elsewhere = (a, b) => a.run !== b.run || a.other !== b.other || a.live !== b.live;

const shownTheme = () => document.documentElement.dataset.theme ?? (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');
function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
  try { localStorage.setItem('theme', theme); } catch { /* storage may be off: the choice lasts for this page */ }
}

try {
  const theme = localStorage.getItem('theme');
  if (theme === 'dark' || theme === 'light') document.documentElement.dataset.theme = theme;
} catch { /* as above */ }
window.continua = new App();
