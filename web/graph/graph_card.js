// The card about a state or an arrow of the graph: while the pointer is over it, or until it is put away once pressed.
import {h, clock, counted} from '../dom.js';
import {rowText} from './graph_draw.js';

const most_ways = 6;

const list = (title, items) =>
  items.length > 0 && [
    h('p', {class: 'muted'}, title),
    h(
      'ul',
      {},
      items.map((item) => h('li', {}, item)),
    ),
  ];
const byUse = (edges) => edges.toSorted((a, b) => b.visits - a.visits);
const ways = (edges, name) => [
  ...byUse(edges)
    .slice(0, most_ways)
    .map((edge) => `${edge[name]}, ${edge.visits ? counted(edge.visits, 'time') : 'never'}`),
  ...(edges.length > most_ways ? [`and ${edges.length - most_ways} more`] : []),
];

/** Seconds that the run spent in the state. */
function timeIn({lanes: {state}, names, graph}, id) {
  let sum = 0;
  for (let i = 0; i < state.n.length; ++i)
    if ((state.name[i] < 0 ? graph.start : names[state.name[i]]) === id) sum += state.to[i] - state.from[i];
  return sum;
}

export class GraphCard {
  element = h('div', {class: 'edge-card', role: 'status', hidden: true, 'data-testid': 'edge-card'});
  #data;
  #pinned = null; // the edge that was pressed

  constructor(data) {
    this.#data = data;
  }

  /** Shows the transitions of an arrow until it is pressed again, another is, or put away; null: puts it away. */
  pin(edge) {
    this.#pinned = this.#pinned === edge ? null : edge;
    this.#fill(this.#pinned && this.#ofEdge(this.#pinned));
  }
  /** While the pointer is over it: an arrow or a state, {edge} or {node, edges}; null: over none. */
  hover(over) {
    if (this.#pinned) return;
    this.#fill(over && (over.edge ? this.#ofEdge(over.edge) : this.#ofNode(over)));
  }

  #fill(content) {
    this.element.hidden = !content;
    if (content) this.element.replaceChildren(...content.flat(Infinity).filter(Boolean));
  }
  #ofEdge({from, to, rows}) {
    return [
      h('b', {}, `${from} → ${to}`),
      h(
        'ul',
        {},
        rows.map((row) => h('li', {}, rowText(row))),
      ),
    ];
  }
  #ofNode({node: {id, visits}, edges}) {
    return [
      h('b', {}, id),
      h('p', {}, `entered ${counted(visits, 'time')}, ${clock(timeIn(this.#data, id))} in all`),
      list(
        'on to',
        ways(
          edges.filter(({from}) => from === id),
          'to',
        ),
      ),
      list(
        'from',
        ways(
          edges.filter(({to}) => to === id),
          'from',
        ),
      ),
    ];
  }
}
