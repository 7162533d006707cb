// Parts of the start page that a site of exported runs has: a search through what was said, and its comparisons.
import {h, brief, counted} from '../dom.js';
import {formatAddress, fresh, linkTo} from '../model.js';

const most_shown = 3; // of a run's lines that were found

/** Lines of a run, [number of the record, text][], that contain every word of a search. */
export const linesWith = (lines, words) =>
  words.length ? lines.filter(([, text]) => words.every((word) => text.toLowerCase().includes(word))) : [];

/** Links to these lines of a run; null where there are none. */
export function linesFound(run, lines) {
  if (!lines.length) return null;
  const link = ([n, text]) =>
    h('li', {'data-testid': 'found'}, h('a', {href: linkTo(formatAddress({...fresh(run.id), n}))}, `“${brief(text)}”`));
  const more = lines.length - most_shown;
  return h(
    'ul',
    {class: 'found'},
    lines.slice(0, most_shown).map(link),
    more > 0 && h('li', {}, `and ${counted(more, 'more line')}`),
  );
}

/** All comparisons of a site, with where the runs part; null where there are none. */
export function comparisonsOf(runs) {
  const all = runs.flatMap((run) => (run.compared ?? []).map((told) => ({run, ...told})));
  if (!all.length) return null;
  const names = new Map(runs.map((run) => [run.id, run.name]));
  const item = ({run, with: other, same, sentence}) => {
    const address = linkTo(formatAddress(fresh(run.id, other)));
    const link = h('a', {class: 'name', href: address}, `${run.name} and ${names.get(other)}`);
    return h('li', {'data-testid': 'comparison'}, link, ` ${same ? '=' : '≠'} ${brief(sentence)}`);
  };
  return h('section', {class: 'comparisons'}, h('h2', {}, 'Comparisons'), h('ul', {}, all.map(item)));
}
