// More than two runs against the first: where each parts from it, why, and what came of it.
import {dialog, h, brief, clock, counted} from '../dom.js';
import {formatAddress, fresh, linkTo} from '../model.js';
import {fetchDiff} from '../run/run_client.js';
import {verdictOf} from '../run/verdict.js';

const rowOf = (run, ...cells) =>
  h('tr', {'data-testid': 'many-row'}, h('th', {scope: 'row'}, run.name), ...cells.map((cell) => h('td', {}, cell)));
const openable = (a, run) => h('a', {href: linkTo(formatAddress(fresh(a.id, run.id)))}, 'Compare these two');

/** A dialog that fills as the answers come: `runs`, the first of which is A. */
export function compareMany([a, ...others]) {
  const rows = others.map((run) => rowOf(run, 'being compared …', '', verdictOf(run).text, ''));
  const head = ['Run', 'Parts from A', 'Cause', 'Outcome', ''].map((title) => h('th', {scope: 'col'}, title));
  const body = h('tbody', {}, rowOf(a, '', '', verdictOf(a).text, ''), rows);
  const element = dialog(
    {class: 'dialog many', 'aria-label': 'Runs compared with A', 'data-testid': 'many'},
    h('h2', {}, `A: ${a.name}, and ${counted(others.length, 'other run')}`),
    h(
      'div',
      {class: 'table', tabindex: 0, role: 'region', 'aria-label': 'Comparisons'},
      h('table', {}, h('thead', {}, h('tr', {}, head)), body),
    ),
    h('form', {method: 'dialog'}, h('button', {autofocus: true}, 'Close')),
  );
  element.addEventListener('close', () => element.remove());
  document.body.append(element);
  element.showModal();
  // One after the other: a comparison of long runs takes a while.
  (async () => {
    for (const [i, run] of others.entries()) {
      if (!element.isConnected) return;
      const told = await fetchDiff(a.id, run.id).catch((problem) => ({problem}));
      const row = rowOf(run, ...cellsOf(told), verdictOf(run).text, openable(a, run));
      rows[i].replaceWith(row);
    }
  })();
}

function cellsOf({problem, same, differences, first, cause, count, sentence}) {
  if (problem) return [problem.message, ''];
  if (same) return ['the same', ''];
  const t = differences?.[first]?.t;
  const where = `${Number.isFinite(t) ? `at ${clock(t, 2)}` : ''}${count ? `, ${counted(count, 'difference')}` : ''}`;
  return [where, brief(cause?.sentence || sentence)];
}
