// The start page: all runs, one line each.
import {h, clock, counted, grouped} from '../dom.js';

export function renderStart(host, runs, open) {
  document.title = 'Continua';
  const row = (run) => h('tr', {'data-testid': 'run'},
    h('td', {}, run.error
      ? h('span', {class: 'name'}, run.name)
      : h('a', {class: 'name', href: `/r/${encodeURIComponent(run.id)}`, onclick: (event) => {
          if (event.ctrlKey || event.metaKey || event.shiftKey) return;
          event.preventDefault();
          open(run.id);
        }}, run.name)),
    run.error
      ? h('td', {colspan: 7, class: 'trouble'}, run.error.message)
      : [h('td', {class: 'number'}, clock(run.duration)),
         h('td', {class: 'number'}, grouped(run.utterances)),
         h('td', {class: 'number'}, grouped(run.acts)),
         h('td', {class: 'number'}, grouped(run.refusals - run.refused_samples)),
         h('td', {}, run.machine),
         h('td', {}, run.scene),
         h('td', {}, status(run))]);
  host.replaceChildren(
    h('main', {class: 'start'},
      h('h1', {}, h('img', {src: '/icon.svg', alt: '', width: 28, height: 28}), 'Continua'),
      h('p', {class: 'lead'}, runs.length ? `${counted(runs.length, 'recorded run')}. Choose one to see what was said, shown and done, and why.`
                                          : 'No runs here yet.'),
      runs.length
        ? h('div', {class: 'table', role: 'region', 'aria-label': 'Runs', tabindex: 0},
            h('table', {'data-testid': 'runs'},
              h('thead', {}, h('tr', {}, ['Run', 'Duration', 'Utterances', 'Acts', 'Refusals', 'Machine', 'Scene', 'Log'].map((title, i) =>
                h('th', {scope: 'col', class: i >= 1 && i <= 4 ? 'number' : null}, title)))),
              h('tbody', {}, runs.map(row))))
        : h('p', {}, 'Make one with ', h('code', {}, 'continua replay TRACE -o FOLDER'),
            '; files named ', h('code', {}, '*.run.jsonl'), ' in the served folders appear here on reload.')));
}

function status(run) {
  if (run.trouble) return h('span', {class: 'badge warn', title: run.trouble}, 'cut short');
  if (run.met < run.expected) return h('span', {class: 'badge bad'}, `${run.expected - run.met} of ${run.expected} expectations not met`);
  if (run.expected) return h('span', {class: 'badge good'}, 'as expected');
  return h('span', {class: 'badge'}, 'complete');
}
