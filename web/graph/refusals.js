// The transitions that were refused where the automaton stood: a list, and on demand dashed arrows in the graph, numbered.
import {h, s, shown, counted} from '../dom.js';
import {calmly} from '../calmly.js';
import {drawRefused, visitsText} from './graph_draw.js';
import {boxesOf} from './graph_labels.js';

const most_arrows = 6;
const calm_ms = 150; // between questions to the server

export class Refusals {
  layer = s('g', {class: 'refused-layer'});
  list = h('details', {class: 'refused-list', hidden: true, 'data-testid': 'graph-refused'});
  #data;
  #client;
  #covers;
  #placed = null; // the graph as layOut() gives it
  #at = -1; // the record that is shown
  #told = {from: null, refused: []};

  /** `covers(element)`: whether an element over the graph covers a state. */
  constructor(data, client, covers) {
    this.#data = data;
    this.#client = client;
    this.#covers = covers;
    this.list.addEventListener('toggle', () => this.#draw());
  }

  /** Shows what was refused at the step, or the refusal, that leads to record n. `quiet`: only takes away the last. */
  show(n, placed, quiet) {
    const data = this.#data;
    const step = data.step(n);
    const at = data.kind(n) === 'refusal' ? n : step < 0 ? -1 : data.steps.n[step];
    if (at === this.#at && placed === this.#placed) return;
    this.#at = at;
    this.#placed = placed;
    this.#tell(null, []);
    if (at >= 0 && !quiet) this.#ask(at);
  }

  #ask = calmly(async (at) => {
    if (at !== this.#at) return;
    const record = await this.#client.record(at).catch(() => null);
    if (!record || at !== this.#at) return;
    const refused = (record.refused ?? []).filter((one) => one?.id).map((one, i) => ({...one, number: i + 1}));
    this.#tell(record.from ?? record.state, refused);
  }, calm_ms);

  #tell(from, refused) {
    this.#told = {from, refused};
    this.list.hidden = !refused.length;
    const items = refused.map((one) => h('li', {}, h('b', {}, one.id), ` ${shown(one.reason)}`));
    this.list.replaceChildren(h('summary', {}, `${counted(refused.length, 'candidate')} refused`), h('ol', {}, items));
    if (refused.length && !this.list.open) this.#stand();
    this.#draw();
  }
  // The closed list stands in the corner where no state is, if there is one.
  #stand() {
    const {classList} = this.list;
    classList.remove('right');
    if (!this.#covers(this.list)) return;
    classList.add('right');
    classList.toggle('right', !this.#covers(this.list));
  }
  #draw() {
    const {from, refused} = this.#told;
    this.layer.replaceChildren(...(this.list.open && refused.length ? this.#arrows(from, refused) : []));
  }

  // An arrow to each state that a refused transition leads to.
  #arrows(from, refused) {
    const targets = new Map();
    for (const one of refused)
      for (const {id, from: source, to, diverted} of this.#data.graph.edges)
        if (id === one.id && source === from && !diverted) targets.set(to, [...(targets.get(to) ?? []), one]);
    const nodeOf = (id) => this.#placed.nodes.find((one) => one.id === id);
    const taken = boxesOf(this.#placed, (edge) => visitsText(edge, false));
    return [...targets]
      .slice(0, most_arrows)
      .map(([to, ones], i) =>
        nodeOf(from) && nodeOf(to) ? drawRefused(nodeOf(from), nodeOf(to), ones, i, taken) : null,
      )
      .filter(Boolean);
  }
}
