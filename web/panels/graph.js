// The automaton: its states and transitions, how often each was used, and where it stands.
import {h, s, panel, counted} from '../dom.js';
import {drawEdge, drawNode, rowText} from '../graph/graph_draw.js';
import {mergedGraph, layOut} from '../graph/graph_layout.js';
import {PanZoom} from '../graph/pan_zoom.js';
import {Refusals} from '../graph/refusals.js';

const keyOf = (from, to) => JSON.stringify([from, to]);

class Graph {
  #data;
  #client;
  #model;
  #cursor;
  #comparison;
  #view = s('g', {});
  #canvas;
  #sight;
  #refusals;
  #card = h('div', {class: 'edge-card', role: 'status', hidden: true, 'data-testid': 'edge-card'});
  #count = h('span', {class: 'muted', 'data-testid': 'graph-count'});
  #only_taken = h('input', {type: 'checkbox', checked: true, 'data-testid': 'taken-only'});
  #placed = null; // by layOut()
  #nodes = new Map(); // state -> element
  #edges = new Map(); // keyOf() -> element
  #lit = []; // elements that tell where the automaton stands
  #told = null; // the edge on the card
  #n = 0;
  #size = '';

  /** `comparison`: with the run that this one is compared with, or null. */
  constructor({data, client, model, cursor, comparison}) {
    this.#data = data;
    this.#client = client;
    this.#model = model;
    this.#cursor = cursor;
    this.#comparison = comparison;
    this.#refusals = new Refusals(data, client);
    const svg = s('svg', {role: 'group', 'aria-label': 'State graph', 'data-testid': 'graph'}, this.#view);
    this.#canvas = h('div', {class: 'canvas'}, svg, this.#refusals.list, this.#card);
    this.#sight = new PanZoom(svg, this.#view);
    this.#only_taken.addEventListener('change', () => this.#build());
    const fit = h('button', {type: 'button', title: 'Fit into the panel (F)', onclick: () => this.fit()}, 'Fit');
    const controls = [this.#count, h('label', {}, this.#only_taken, 'taken only'), fit];
    this.element = panel('graph', 'State graph', controls, this.#canvas);
    new ResizeObserver(() => this.#resized()).observe(this.#canvas);
  }

  #resized() {
    const size = `${this.#canvas.clientWidth}x${this.#canvas.clientHeight}`;
    if (size === this.#size) return;
    this.#size = size;
    this.#build();
  }

  // Lays the graph out for the panel's shape.
  #build() {
    const {clientWidth, clientHeight} = this.#canvas;
    const {graph} = this.#data;
    const compared = Boolean(this.#comparison);
    const merged = mergedGraph(graph, this.#only_taken.checked, this.#comparison?.side.data.graph);
    const placed = (this.#placed = layOut(merged, Math.max(0.2, clientWidth / Math.max(1, clientHeight))));
    const edge = (one) => drawEdge(one, {compared, tell: () => this.#tell(one)});
    const node = (one) =>
      drawNode(one, {compared, begins: one.id === graph.start, jump: () => this.#jumpToVisit(one.id)});
    this.#edges = new Map(placed.edges.map((one) => [keyOf(one.from, one.to), edge(one)]));
    this.#nodes = new Map(placed.nodes.map((one) => [one.id, node(one)]));
    const by_use = placed.edges.toSorted((a, b) => a.visits - b.visits);
    const arrows = by_use.map(({from, to}) => this.#edges.get(keyOf(from, to)));
    this.#view.replaceChildren(...arrows, ...this.#nodes.values(), this.#refusals.layer);
    const own = graph.edges.filter((one) => !one.diverted);
    const taken = own.filter((one) => one.visits).length;
    const states = `${placed.nodes.length} of ${counted(graph.states.length, 'state')}`;
    this.#count.textContent = `${states}, ${taken} of ${counted(own.length, 'transition')} taken`;
    this.#lit = [];
    this.fit();
    this.#light();
  }

  /** Shows the whole graph. */
  fit() {
    if (this.#placed) this.#sight.fit(this.#placed);
  }

  // Goes to the next time after the cursor that the automaton entered this state; after the last, to the first.
  #jumpToVisit(id) {
    const {steps, names} = this.#data;
    const from = this.#data.step(this.#model.selection.n) + 1;
    for (let i = 0; i < steps.n.length; ++i) {
      const place = (from + i) % steps.n.length;
      if (names[steps.to[place]] !== id) continue;
      this.#cursor.jump(steps.n[place]);
      return;
    }
  }

  // The transitions of an arrow, in words, until it is pressed again.
  #tell(edge) {
    this.#told = this.#told === edge ? null : edge;
    this.#card.hidden = !this.#told;
    if (!this.#told) return;
    const rows = edge.rows.map((row) => h('li', {}, rowText(row)));
    this.#card.replaceChildren(h('b', {}, `${edge.from} → ${edge.to}`), h('ul', {}, rows));
  }

  // Marks where the automaton stands at record #n.
  #light() {
    const n = this.#n;
    for (const one of this.#nodes.values()) one.classList.remove('branch');
    for (const one of this.#lit) one.classList.remove('current', 'last', 'current-b');
    this.#lit = [];
    const state = this.#data.state(n);
    const node = this.#nodes.get(state);
    this.#mark(node, 'current');
    this.#lightStep(this.#data.step(n));
    if (this.#comparison) {
      const {side} = this.#comparison;
      const other = this.#nodes.get(side.data.state(this.#comparison.otherOf(this.#model.selection)));
      if (other !== node) this.#mark(other, 'current-b');
    }
    this.#lightBranch(n);
    if (!this.#sight.fitted) this.#reveal(state);
    this.#refusals.show(n, this.#placed, this.#cursor.playing);
  }
  #mark(element, name) {
    element?.classList.add(name);
    if (element) this.#lit.push(element);
  }
  // The arrow that was followed last lies above the others.
  #lightStep(step) {
    if (step < 0) return;
    const {from, to} = this.#data.stepAt(step);
    const edge = this.#edges.get(keyOf(from, to));
    if (!edge) return;
    this.#mark(edge, 'last');
    edge.parentNode.insertBefore(edge, this.#nodes.values().next().value);
  }
  // Where the selected one of several configurations is.
  async #lightBranch(n) {
    const {branch} = this.#model.selection;
    if (branch === null || !this.#data.count('branches')) return;
    const stack = await this.#client.stack(n, branch).catch(() => null);
    if (!stack?.branch || this.#n !== n || this.#model.selection.branch !== branch) return;
    for (const one of this.#nodes.values()) one.classList.toggle('branch', one.dataset.state === stack.branch.state);
  }
  #reveal(state) {
    const node = this.#placed.nodes.find((one) => one.id === state);
    if (node) this.#sight.reveal(node);
  }

  render({n}) {
    this.#n = n;
    if (this.#placed) this.#light();
  }
}

export const mountGraph = (needs) => new Graph(needs);
