// A live session's run as the state graph and the stack query it: made of the records as they come. Has the part of
// RunData that they need.
import {lastAtMost} from '../search.js';

const usesOf = ({id, from, to}) => JSON.stringify([id, from, to]);

export class LiveRun {
  t = []; // of each record
  steps = {n: []}; // the transitions taken
  lanes = {state: {n: [], name: [], from: [], to: []}};
  names = [];
  /** Nothing before the first record has come. */
  graph = null;
  labels;
  #kinds = [];
  #taken = []; // {n, id, from, to}
  #places = new Map(); // name -> its place in `names`
  #edges = new Map(); // usesOf() -> edge of the graph
  #states = new Map();

  constructor(labels) {
    this.labels = labels;
    this.steps.to = [];
  }

  /** @returns whether the automaton has moved, or begun */
  take(record) {
    const {n, t, kind} = record;
    this.t[n] = t;
    this.#kinds[n] = kind;
    if (kind === 'run') this.#begin(record.graph);
    else if (kind === 'transition' && this.graph) this.#step(record);
    else return false;
    return Boolean(this.graph);
  }
  #begin(graph) {
    if (!graph?.states) return;
    const unused = (one) => ({...one, visits: 0});
    this.graph = {...graph, states: graph.states.map(unused), edges: graph.edges.map(unused)};
    for (const edge of this.graph.edges) this.#edges.set(usesOf(edge), edge);
    for (const state of this.graph.states) this.#states.set(state.id, state);
    this.#enter(graph.start, 0, 0);
  }
  #step({n, t, id, from, to}) {
    this.steps.n.push(n);
    this.steps.to.push(this.#placeOf(to));
    this.#taken.push({n, id, from, to});
    ++this.#edgeOf({id, from, to}).visits;
    if (this.#states.has(to)) ++this.#states.get(to).visits;
    this.#enter(to, n, t);
  }
  // A transition that ended elsewhere than it leads was turned away by a gate.
  #edgeOf(step) {
    const key = usesOf(step);
    if (!this.#edges.has(key)) {
      const like = this.graph.edges.find(({id, from}) => id === step.id && from === step.from);
      const edge = {input: null, condition: null, operation: '', ...like, ...step, diverted: true, visits: 0};
      this.#edges.set(key, edge);
      this.graph.edges.push(edge);
    }
    return this.#edges.get(key);
  }
  #enter(state, n, t) {
    const lane = this.lanes.state;
    if (lane.to.length) lane.to[lane.to.length - 1] = t;
    for (const [name, value] of [
      ['n', n],
      ['name', this.#placeOf(state)],
      ['from', t],
      ['to', t],
    ])
      lane[name].push(value);
  }
  #placeOf(name) {
    if (!this.#places.has(name)) this.#places.set(name, this.names.push(name) - 1);
    return this.#places.get(name);
  }

  kind(n) {
    return this.#kinds[n];
  }
  label(n) {
    return this.labels.label(n);
  }
  raw(n) {
    return this.labels.raw(n);
  }
  step(n) {
    return lastAtMost(this.steps.n, n);
  }
  stepAt(place) {
    return this.#taken[place];
  }
  state(n) {
    const step = this.step(n);
    return step < 0 ? this.graph.start : this.#taken[step].to;
  }
  count() {
    return 0;
  }
}
