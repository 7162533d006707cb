// The page of a run, or of two that are compared: fetches them, and keeps the panels in step with the selection.
import {announce} from './announce.js';
import {calmly} from './calmly.js';
import {keys} from './keys.js';
import {buildPanels} from './run_panels.js';
import {readColumns} from './run/columns.js';
import {Comparison} from './run/comparison.js';
import {Labels} from './run/labels.js';
import {fetchDiff, fetchRun, listenTo, RecordClient, served} from './run/run_client.js';
import {RunData} from './run/run_data.js';

const grow_ms = 700; // between readings of a run that grows
const first_window_s = 40; // the timeline's first window of a longer run

const dataOf = (fetched, labels) => new RunData({...fetched, columns: readColumns(fetched.columns), labels});

export class RunPage {
  /** The run, and in a comparison the two of them; null before they are loaded. */
  data = null;
  comparison = null;
  /** Whether the run is being written. */
  live = false;
  /** By name: what the mount functions give; all that is rendered. */
  parts = null;
  dialogs = null;
  panels = [];
  #host;
  #closed = false;
  #stream = null;

  constructor(host, model, cursor) {
    this.#host = host;
    this.model = model;
    this.cursor = cursor;
    ({run: this.id, other: this.other} = model.selection);
    this.refusal = this.other === null ? 'This run cannot be shown' : 'These runs cannot be compared';
  }

  async load() {
    const both = this.other !== null;
    const [own, compared, told] = await Promise.all([
      this.#fetch(this.id),
      both ? this.#fetch(this.other) : null,
      both ? fetchDiff(this.id, this.other) : null,
    ]);
    if (this.#closed) return;
    Object.assign(this, own);
    this.comparison = compared && new Comparison(own.data, compared, told);
    this.#begin();
  }

  /** {id, client, labels, data} of a run. */
  async #fetch(id) {
    const fetched = await fetchRun(id);
    const client = new RecordClient(id);
    const labels = new Labels(client, () => this.#labelsArrived());
    return {id, client, labels, data: dataOf(fetched, labels)};
  }

  // Fills in the parts that the address left open, and builds the page.
  #begin() {
    const {data, model, comparison} = this;
    const {n, zoom, hunk} = model.selection;
    this.title = (data.summary.trace || this.id).replace(/(\.trace)?\.jsonl(\.gz)?$/, '');
    document.title = `${this.title}${comparison ? ' compared' : ''} – Continua`;
    const start = data.clamp(n ?? comparison?.start ?? data.summary.first);
    model.settle({
      n: start,
      hunk: hunk ?? (n === null ? (comparison?.first ?? null) : null),
      zoom: zoom ?? this.#windowAround(start),
    });
    this.#build();
    performance.mark('built');
    if (served && !data.complete && !comparison) this.#stream = listenTo(this.id, (grown) => this.#grown(grown));
  }
  #build(before = null) {
    this.cursor.data = this.data;
    Object.assign(this, buildPanels(this.#host, this, before));
    this.render();
  }
  #windowAround(n) {
    return this.data.windowAround(this.data.t[n], Math.min(first_window_s, this.data.duration || 1));
  }

  /** A run that is being written has more records: they are shown, and a cursor at the end goes along. */
  #grown({records, complete, live}) {
    if (this.#closed) return;
    this.live = live;
    this.render();
    if (complete) this.#stream?.close();
    if (records > this.data.size) this.#readOn();
  }
  #readOn = calmly(async () => {
    if (this.#closed) return;
    // The page is built anew: not while the reader writes.
    if (document.querySelector('dialog[open]') || document.activeElement?.matches('input, textarea')) {
      setTimeout(this.#readOn, grow_ms);
      return;
    }
    const at_end = this.model.selection.n >= (this.data.stops.at(-1) ?? 0);
    const fetched = await fetchRun(this.id).catch(() => null);
    if (!fetched || this.#closed) return;
    this.client.forget();
    this.data = dataOf(fetched, this.labels);
    const {stops, size} = this.data;
    if (at_end) this.model.settle({n: stops.at(-1) ?? size - 1, zoom: this.#windowAround(size - 1)});
    this.#build(this);
  }, grow_ms);

  render() {
    if (!this.parts) return;
    // A link without a record, such as one that Back leads to, is of the first.
    if (this.model.selection.n === null) this.model.settle({n: this.data.clamp(this.data.summary.first)});
    const {n} = this.cursor;
    for (const one of this.panels) one.render({...this.model.selection, n});
    this.#announce();
  }
  #labelsArrived() {
    if (!this.parts) return;
    for (const one of this.panels) one.labelsArrived?.();
    this.#announce();
  }
  #announce() {
    if (!this.cursor.playing) announce(this.data.sentence(this.cursor.n));
  }

  /** Resolves when nothing that was asked for is still to come. */
  async settled() {
    const all = this.comparison ? [this, this.comparison.side] : [this];
    for (let quiet = 0; quiet < 2; ) {
      await Promise.all(all.map(({client}) => client?.idle()));
      await new Promise((done) => setTimeout(done, 20));
      quiet = all.every(({labels}) => labels?.idle ?? true) ? quiet + 1 : 0;
    }
  }

  onKey(key, shift) {
    const row = this.parts && keys.find(([names]) => names.includes(key));
    row?.[3](this, {key, shift});
    return Boolean(row);
  }
  /** To the next (previous) difference; where one run is shown, to the next record of something that went wrong. */
  next(by) {
    if (!this.comparison) {
      this.cursor.flagBy(by);
      return;
    }
    this.cursor.stop();
    this.parts.differences.go(by);
  }
  /** Brings the panel to the front of its tabs. */
  showTab(tab) {
    this.model.go({tab, panel: ''}, 'slide');
  }
  /** Focuses the panel in this place; a panel that has the focus already fills the page. */
  focusPanel(place) {
    const [name, part] = Object.entries(this.parts)[place] ?? [];
    if (!part) return;
    if (part.element.contains(document.activeElement)) {
      this.model.enlarge(name);
      return;
    }
    if (part.element.hidden) this.showTab(name);
    part.element.querySelector('[tabindex="0"], button:not(.larger)')?.focus();
  }

  close() {
    this.#closed = true;
    this.#stream?.close();
    for (const one of this.panels) one.close?.();
    this.panels = [];
    this.parts = null;
    this.cursor.stop();
    this.cursor.data = null;
  }
}
