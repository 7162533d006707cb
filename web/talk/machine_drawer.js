// The machine of a live session in a corner of the page: its state graph and its stack, which follow the conversation.
import {h} from '../dom.js';
import {calmly} from '../calmly.js';
import {mountGraph} from '../panels/graph.js';
import {mountStack} from '../panels/stack.js';
import {RecordClient} from '../run/run_client.js';
import {Labels} from '../run/labels.js';
import {LiveRun} from './live_run.js';

const grow_ms = 400; // between drawings of the graph with what was taken since

class MachineDrawer {
  element = h('section', {
    class: 'machine-drawer',
    'aria-label': 'Machine',
    'data-testid': 'live-machine',
    hidden: true,
  });
  #client;
  #run;
  #selection = {n: 0, branch: null, cell: ''};
  #graph = null; // null before it is opened
  #stack = null;

  /** `run`: by which the session's log is known to the server. */
  constructor(run) {
    this.#client = new RecordClient(run);
    this.#run = new LiveRun(new Labels(this.#client, () => this.#stack?.labelsArrived()));
  }

  take(record) {
    if (!this.#run.take(record)) return;
    this.#selection.n = record.n;
    if (!this.element.hidden) this.#follow();
  }
  #follow = calmly(() => {
    if (!this.#graph) this.#mount();
    this.#graph.grown();
    this.#render();
  }, grow_ms);

  #mount() {
    const jump = (n) => open(`/r/${encodeURIComponent(this.#client.id)}?n=${n}`, '_blank', 'noopener');
    const model = {
      selection: this.#selection,
      go: (change) => {
        Object.assign(this.#selection, change);
        this.#render();
      },
    };
    const needs = {
      data: this.#run,
      client: this.#client,
      model,
      jump,
      cursor: {jump, playing: false},
      comparison: null,
    };
    this.#graph = mountGraph(needs);
    this.#stack = mountStack(needs);
    this.element.replaceChildren(this.#graph.element, this.#stack.element);
  }
  #render() {
    for (const one of [this.#graph, this.#stack]) one.render(this.#selection);
  }

  /** Opens or closes it. @returns whether it is open */
  toggle() {
    this.element.hidden = !this.element.hidden;
    if (!this.element.hidden && this.#run.graph) this.#follow();
    return !this.element.hidden;
  }
  close() {
    this.#graph?.close();
  }
}

export const mountMachine = (run) => new MachineDrawer(run);
