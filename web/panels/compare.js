// Asks for the run to compare the shown run with: runs of the same trace first.
import {h, clock, dialog} from '../dom.js';
import {pairOf} from '../run/pairs.js';
import {fetchRuns, listed} from '../run/run_client.js';

const most_shown = 100;

/** `id`: of the run that is shown, `cursor`: in that run. */
export function compareDialog({id, cursor, model}) {
  const list = h('ul', {class: 'choices'});
  const filter = h('input', {
    type: 'search',
    'aria-label': 'Find a run',
    placeholder: 'Find a run',
    'data-testid': 'compare-filter',
    oninput: draw,
  });
  const element = dialog(
    {class: 'dialog', 'aria-label': 'Compare with', 'data-testid': 'compare-dialog'},
    h('h2', {}, 'Compare with'),
    filter,
    list,
    h('form', {method: 'dialog'}, h('button', {}, 'Close')),
  );
  let own = null; // the run that is shown, and those that it can be compared with
  let runs = [];

  const ofSameTrace = (run) => run.trace === cursor.data.summary.trace;
  function choose(run) {
    element.close();
    model.open(...pairOf(own, run));
  }
  const choice = (run) =>
    h(
      'button',
      {type: 'button', 'data-testid': 'compare-with', onclick: () => choose(run)},
      h('b', {}, run.name),
      ` ${clock(run.duration)}, ${run.machine}`,
      ofSameTrace(run) && h('span', {class: 'badge good'}, 'same trace'),
    );
  function draw() {
    const words = filter.value.toLowerCase().split(/\s+/).filter(Boolean);
    const fits = runs.filter((run) =>
      words.every((word) => `${run.name} ${run.trace} ${run.machine}`.toLowerCase().includes(word)),
    );
    list.replaceChildren(...fits.slice(0, most_shown).map((run) => h('li', {}, choice(run))));
    if (!fits.length) list.append(h('li', {class: 'empty'}, 'No other run.'));
  }
  return {
    element,
    async open() {
      if (!listed) return;
      element.showModal();
      const all = await fetchRuns();
      own = all.find((run) => run.id === id);
      const others = all.filter((run) => run.id !== id && !run.error && !run.pending && pairOf(own, run));
      runs = others.sort((a, b) => ofSameTrace(b) - ofSameTrace(a));
      draw();
      filter.focus();
    },
  };
}
