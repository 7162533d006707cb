// The page: reads the address, fetches the run, sets up the panels and keeps them in step with the selection.
import {h} from './dom.js';
import {Model} from './model.js';
import {RunData} from './run_data.js';
import {fetchRun, fetchRuns, RecordClient} from './run_client.js';
import {helpDialog, onKey} from './keys.js';
import {renderStart} from './panels/start.js';
import {mountHeader} from './panels/header.js';
import {mountDialogue} from './panels/dialogue.js';
import {mountGraph} from './panels/graph.js';
import {mountScene} from './panels/scene.js';
import {mountStack} from './panels/stack.js';
import {mountLanes} from './panels/lanes.js';
import {mountRecords} from './panels/records.js';
import {mountDetails} from './panels/details.js';

const page = document.getElementById('page');
const sentence = document.getElementById('sentence');
const first_window_s = 40;  // what the timeline shows at first of a run longer than that

class App {
  constructor() {
    this.speed = 1;
    this.playing = false;
    this.panels = [];
    this.data = null;
    this.model = new Model((before) => this.changed(before));
    document.addEventListener('keydown', (event) => { if (this.data) onKey(this, event); });
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.render());
    this.open();
  }

  /** Fetches what the address names and builds the page for it. */
  async open() {
    delete document.body.dataset.ready;
    await this.show();
    await this.client?.idle();
    document.body.dataset.ready = '';
  }

  async show() {
    const id = this.model.selection.run;
    this.stop();
    this.data = null;
    this.client = null;
    page.replaceChildren(h('p', {class: 'loading'}, 'Loading…'));
    try {
      if (id === null) {
        const runs = await fetchRuns();
        if (this.model.selection.run === null) renderStart(page, runs, (run) => this.openRun(run));
        return;
      }
      const run = new RunData(await fetchRun(id));
      if (this.model.selection.run === id) this.build(id, run);
    } catch (problem) {
      page.replaceChildren(h('main', {class: 'start'}, h('h1', {}, 'This run cannot be shown'),
        h('p', {class: 'trouble', 'data-testid': 'problem'}, problem.message), h('p', {}, h('a', {href: '/'}, 'All runs'))));
    }
  }

  build(id, data) {
    this.data = data;
    this.client = new RecordClient(id);
    this.title = (data.summary.trace || id).replace(/(\.trace)?\.jsonl$/, '');
    document.title = `${this.title} – Continua`;
    const {n, zoom} = this.model.selection;
    const start = data.clamp(n ?? data.summary.first);
    this.model.settle({n: start, zoom: zoom ?? this.windowAround(start)});

    const header = h('header', {class: 'top'});
    this.graph = mountGraph(this);
    this.lanes = mountLanes(this);
    this.records = mountRecords(this);
    const dialogue = mountDialogue(this), scene = mountScene(this), stack = mountStack(this), details = mountDetails(this);
    this.dialog = helpDialog();
    page.replaceChildren(header, h('main', {class: 'run'}, dialogue.element, this.graph.element, scene.element, stack.element, this.lanes.element,
      this.records.element, details.element), this.dialog);
    this.panels = [mountHeader(header, this), dialogue, this.graph, scene, stack, this.lanes, this.records, details];
    this.render();
  }

  windowAround(n) {
    const {t, duration} = this.data, width = Math.min(first_window_s, duration || 1);
    const from = Math.max(0, Math.min(duration - width, t[n] - width / 3));
    return [from, from + width];
  }

  changed(before) {
    if (before.run !== this.model.selection.run) { this.open(); return; }
    if (!this.data) return;
    if (this.model.selection.n === null) this.model.settle({n: this.data.clamp(this.data.summary.first)});
    this.render();
  }

  render() {
    if (!this.data) return;
    const selection = this.model.selection;
    const n = this.data.clamp(selection.n);
    for (const one of this.panels) one.render({...selection, n});
    if (!this.playing) sentence.textContent = this.data.sentence(n);
  }

  /** Moves the cursor; the timeline comes along when it would leave it. */
  select(n, how) {
    n = this.data.clamp(n);
    const {zoom} = this.model.selection, t = this.data.t[n];
    const change = {n};
    if (zoom && (t < zoom[0] || t > zoom[1])) {
      const width = zoom[1] - zoom[0], from = Math.max(0, Math.min(this.data.duration - width, t - width / 3));
      change.zoom = [from, from + width];
    }
    this.model.go(change, how);
  }
  jump(n) { this.select(n, 'jump'); }
  stepBy(by) { this.stop(); this.select(this.data.stop(this.data.lanes.interest, this.model.selection.n, by), 'step'); }
  transitionBy(by) { this.stop(); this.select(this.data.stop(this.data.steps.n, this.model.selection.n, by), 'step'); }
  follow(back) {
    const {n} = this.model.selection;
    const to = back ? this.data.cause(n) : this.data.effects(n)[0] ?? -1;
    if (to >= 0) this.jump(to);
  }

  play() {
    if (this.playing) { this.stop(); return; }
    const {data} = this;
    if (this.model.selection.n >= data.size - 1) this.jump(0);
    this.playing = true;
    let n = this.model.selection.n, t = data.t[n], last = performance.now();
    const tick = (now) => {
      if (!this.playing || this.data !== data) return;
      if (this.model.selection.n !== n) t = data.t[data.clamp(this.model.selection.n)];  // the reader went elsewhere
      t += (now - last) / 1000 * this.speed;
      last = now;
      n = Math.max(data.at(t), this.model.selection.n);
      this.select(n, 'slide');
      if (t >= data.duration) this.stop(); else requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
    this.render();
  }
  stop() {
    if (!this.playing) return;
    this.playing = false;
    this.render();
  }

  async copyLink() {
    try {
      await navigator.clipboard.writeText(location.href);
      sentence.textContent = 'The link was copied.';
      return true;
    } catch {
      return false;
    }
  }

  toggleTheme() {
    setTheme(shownTheme() === 'dark' ? 'light' : 'dark');
    this.render();
  }

  help() { this.dialog.showModal(); }
  openRun(run) { this.model.go({run, n: null, zoom: null, filter: '', kind: ''}); }
}

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
