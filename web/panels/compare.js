// Asks which run to compare the shown one with: those of the same trace first.
import {h, clock} from '../dom.js';
import {fetchRuns, served} from '../run/run_client.js';

export function compareDialog(app) {
  const list = h('ul', {class: 'choices'});
  const filter = h('input', {type: 'search', 'aria-label': 'Find a run', placeholder: 'Find a run', 'data-testid': 'compare-filter', oninput: () => draw()});
  const element = h('dialog', {class: 'dialog', 'aria-label': 'Compare with', 'data-testid': 'compare-dialog', onclick: (event) => { if (event.target === element) element.close(); }},
    h('h2', {}, 'Compare with'), filter, list, h('form', {method: 'dialog'}, h('button', {}, 'Close')));
  let runs = [];

  const draw = () => {
    const words = filter.value.toLowerCase().split(/\s+/).filter(Boolean);
    const fits = runs.filter((run) => words.every((word) => `${run.name} ${run.trace} ${run.machine}`.toLowerCase().includes(word)));
    list.replaceChildren(...fits.slice(0, 100).map((run) => h('li', {}, h('button', {type: 'button', 'data-testid': 'compare-with', onclick: () => { element.close(); app.openRun(app.id, run.id); }},
      h('b', {}, run.name), ` ${clock(run.duration)}, ${run.machine}`, run.trace === app.data.summary.trace && h('span', {class: 'badge good'}, 'same trace')))));
    if (!fits.length) list.append(h('li', {class: 'empty'}, 'No other run.'));
  };
  return {
    element,
    async open() {
      if (!served) return;
      element.showModal();
      const near = (run) => (run.trace === app.data.summary.trace ? 0 : 1);
      runs = (await fetchRuns()).filter((run) => run.id !== app.id && !run.error && !run.pending).sort((a, b) => near(a) - near(b));
      draw();
      filter.focus();
    },
  };
}
