// Which lanes are shown, which of them are tall, and which stand first: the reader's choice, remembered.
import {h} from '../dom.js';
import {kept} from '../kept.js';

const keyOf = ({name, colour}) => `${colour} ${name}`;
const choices = kept('lanes', {});
const ways = [
  ['shown', 'shown'],
  ['tall', 'tall'],
  ['first', 'first'],
];

function arranged(rows) {
  const of = (row) => ({shown: true, tall: false, first: false, ...choices.value[keyOf(row)]});
  return rows
    .filter((row) => of(row).shown)
    .map((row) => ({...row, tall: of(row).tall}))
    .toSorted((a, b) => of(b).first - of(a).first);
}

/** {element: a list to choose from, rows: those chosen}. `rows`: as of laneRows(); `changed(rows)` when others are. */
export function laneChoice(rows, changed) {
  const box = (row, way, label) => {
    const of = choices.value[keyOf(row)] ?? {};
    const input = h('input', {
      type: 'checkbox',
      checked: of[way] ?? way === 'shown',
      'aria-label': `${row.name}: ${label}`,
      'data-testid': `lane-${way}`,
    });
    input.addEventListener('change', () => {
      choices.set({...choices.value, [keyOf(row)]: {...choices.value[keyOf(row)], [way]: input.checked}});
      changed(arranged(rows));
    });
    return h('td', {}, input);
  };
  const line = (row) =>
    h(
      'tr',
      {},
      h('th', {scope: 'row'}, row.name),
      ways.map(([way, label]) => box(row, way, label)),
    );
  const heads = ways.map(([, label]) => h('th', {scope: 'col'}, label));
  const table = h('table', {}, h('tr', {}, h('td', {}), heads), rows.map(line));
  const element = h('details', {class: 'lane-choice', 'data-testid': 'lane-choice'}, h('summary', {}, 'Lanes'), table);
  element.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape' || !element.open) return;
    event.stopPropagation();
    element.open = false;
    element.querySelector('summary').focus();
  });
  return {element, rows: arranged(rows)};
}
