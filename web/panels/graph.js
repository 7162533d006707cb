// The automaton: its states and transitions, how often each was used, and where it stands.
import {h, s, panel, counted} from '../dom.js';
import {download} from '../download.js';
import {GraphCard} from '../graph/graph_card.js';
import {drawCount, drawEdge, drawNode, visitsText} from '../graph/graph_draw.js';
import {graphFile} from '../graph/graph_file.js';
import {placeLabels} from '../graph/graph_labels.js';
import {mergedGraph, layOut} from '../graph/graph_layout.js';
import {PanZoom} from '../graph/pan_zoom.js';
import {Trail} from '../graph/graph_trail.js';
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
  #card;
  #trail;
  #count = h('span', {class: 'muted', 'data-testid': 'graph-count'});
  #only_taken = h('input', {type: 'checkbox', checked: true, 'data-testid': 'taken-only'});
  #placed = null; // by layOut()
  #nodes = new Map(); // state -> element
  #edges = new Map(); // keyOf() -> element
  #lit = []; // elements that tell where the automaton stands
  #counts = new Map(); // keyOf() -> the count of its uses
  #shown = -1; // the step that the picture follows
  #n = 0;
  #size = '';

  /** `comparison`: with the run that this one is compared with, or null. */
  constructor({data, client, model, cursor, comparison}) {
    this.#data = data;
    this.#client = client;
    this.#model = model;
    this.#cursor = cursor;
    this.#comparison = comparison;
    this.#refusals = new Refusals(data, client, (one) => this.#sight.covered(one, this.#placed.nodes));
    this.#card = new GraphCard(data);
    this.#trail = new Trail(data);
    const svg = s('svg', {role: 'group', 'aria-label': 'State graph', 'data-testid': 'graph'}, this.#view);
    svg.addEventListener('click', (event) => {
      if (!event.target.closest('.edge')) this.#card.pin(null);
    });
    this.#canvas = h('div', {class: 'canvas'}, svg, this.#refusals.list, this.#card.element);
    this.#canvas.addEventListener('keydown', (event) => this.#putAway(event));
    this.#sight = new PanZoom(svg, this.#view);
    this.#only_taken.addEventListener('change', () => this.#build());
    const button = (title, text, onclick) => h('button', {type: 'button', title, onclick}, text);
    const controls = [
      this.#count,
      h('label', {}, this.#only_taken, 'taken only'),
      button('Fit into the panel, or follow the state (F)', 'Fit', () => this.fit()),
      button('Save the graph as an SVG file', 'SVG', () => this.#save()),
    ];
    this.element = panel('graph', 'State graph', controls, this.#canvas);
    new ResizeObserver(() => this.#resized()).observe(this.#canvas);
  }

  #resized() {
    const size = `${this.#canvas.clientWidth}x${this.#canvas.clientHeight}`;
    if (size === this.#size) return;
    this.#size = size;
    this.#build();
  }

  /** More was taken: it is drawn anew, where the reader has moved it to. */
  grown() {
    if (this.#placed) this.#build(!this.#sight.fitted);
  }

  // Lays the graph out for the panel's shape. `stays`: what is in sight stays so.
  #build(stays = false) {
    const {clientWidth, clientHeight} = this.#canvas;
    const {graph} = this.#data;
    const compared = Boolean(this.#comparison);
    const merged = mergedGraph(graph, this.#only_taken.checked, this.#comparison?.side.data.graph);
    const room = {width: Math.max(1, clientWidth), height: Math.max(1, clientHeight)};
    const label = (one) => placeLabels(one, (edge) => visitsText(edge, compared));
    const placed = (this.#placed = layOut(merged, room, label));
    label(placed);
    const edge = (one) =>
      drawEdge(one, {
        compared,
        tell: () => this.#card.pin(one),
        over: (is) => this.#card.hover(is && {edge: one}),
      });
    const node = (one) =>
      drawNode(one, {
        compared,
        begins: one.id === graph.start,
        jump: () => this.#jumpToVisit(one.id),
        over: (is) => this.#card.hover(is && {node: one, edges: placed.edges}),
      });
    this.#edges = new Map(placed.edges.map((one) => [keyOf(one.from, one.to), edge(one)]));
    this.#nodes = new Map(placed.nodes.map((one) => [one.id, node(one)]));
    const by_use = placed.edges.toSorted((a, b) => a.visits - b.visits);
    const arrows = by_use.map(({from, to}) => this.#edges.get(keyOf(from, to)));
    const counts = placed.edges.map((one) => [keyOf(one.from, one.to), drawCount(one, compared)]);
    this.#counts = new Map(counts.filter(([, count]) => count));
    this.#view.replaceChildren(
      ...arrows,
      s('g', {class: 'counts'}, ...this.#counts.values()),
      ...this.#nodes.values(),
      this.#refusals.layer,
      this.#trail.token,
    );
    this.#card.pin(null);
    // A transition that leaves several states is one.
    const own = new Set(graph.edges.filter((one) => !one.diverted).map(({id}) => id));
    const taken = new Set(graph.edges.filter((one) => !one.diverted && one.visits).map(({id}) => id)).size;
    const states = `${placed.nodes.length} of ${counted(graph.states.length, 'state')}`;
    this.#count.textContent = `${states}, ${taken} of ${counted(own.size, 'transition')} taken`;
    this.#lit = [];
    if (!stays) this.fit();
    this.#light();
  }

  /** Shows the whole graph or, where its letters would be too small then, the state with its neighbours. */
  fit() {
    if (!this.#placed) return;
    this.#sight.fit(this.#placed);
    this.#follow(false);
  }
  // The state comes first, then those that it came from and can go on to, those used most first.
  #follow(calmly) {
    const {nodes, edges} = this.#placed;
    const state = this.#data.state(this.#n);
    const last = this.#data.step(this.#n);
    const from = last < 0 ? state : this.#data.stepAt(last).from;
    const near = edges
      .filter((edge) => edge.from === state || edge.to === state)
      .toSorted((a, b) => b.visits - a.visits)
      .map((edge) => (edge.from === state ? edge.to : edge.from));
    const boxes = [...new Set([state, from, ...near])].map((id) => nodes.find((one) => one.id === id)).filter(Boolean);
    this.#sight.follow(boxes, this.#placed, calmly);
  }
  #putAway(event) {
    if (event.key !== 'Escape' || this.#card.element.hidden) return;
    event.stopPropagation();
    this.#card.pin(null);
  }
  #save() {
    download(graphFile(this.#view, this.#placed), 'state_graph.svg', 'image/svg+xml');
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

  // Marks where the automaton stands at record #n.
  #light() {
    const n = this.#n;
    for (const one of this.#nodes.values()) one.classList.remove('branch');
    for (const one of this.#lit) one.classList.remove('current', 'last', 'current-b');
    this.#lit = [];
    const state = this.#data.state(n);
    const node = this.#nodes.get(state);
    this.#mark(node, 'current');
    const step = this.#data.step(n);
    this.#lightStep(step);
    this.#trail.show(step, ({from, to}) => this.#edges.get(keyOf(from, to)), true);
    if (this.#comparison) {
      const {side} = this.#comparison;
      const other = this.#nodes.get(side.data.state(this.#comparison.otherOf(this.#model.selection)));
      if (other !== node) this.#mark(other, 'current-b');
    }
    this.#lightBranch(n);
    if (step !== this.#shown) this.#card.pin(null);
    if (!this.#sight.fitted) this.#reveal(state);
    else if (step !== this.#shown) this.#follow(true);
    this.#shown = step;
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
    this.#mark(this.#counts.get(keyOf(from, to)), 'last');
    edge.parentNode.insertBefore(edge, this.#view.querySelector('.counts'));
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
  close() {
    this.#trail.close();
  }
}

export const mountGraph = (needs) => new Graph(needs);
