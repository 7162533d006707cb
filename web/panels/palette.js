// Goes to whatever is typed: a record, an instant, a state, a panel, another run; or does what a key does. Suggestions
// come while it is typed.
import {dialog, h} from '../dom.js';
import {keys} from '../keys.js';
import {fetchRuns, listed} from '../run/run_client.js';
import {placeOf} from './go_to.js';

const most_shown = 12;

/** The choices that hold all words of `text`, those that begin with it first. Pure. */
export function fitting(choices, text) {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  const of = ({name}) => name.toLowerCase();
  return choices
    .filter((one) => words.every((word) => of(one).includes(word)))
    .toSorted((a, b) => of(b).startsWith(words[0] ?? '') - of(a).startsWith(words[0] ?? ''));
}

/** `page()`: the RunPage that is shown. */
export function paletteDialog(page) {
  let runs = null;
  let shown = [];
  let chosen = 0;
  const list = h('ul', {id: 'palette-list', role: 'listbox', 'aria-label': 'Suggestions'});
  const field = h('input', {
    type: 'text',
    role: 'combobox',
    'aria-expanded': 'true',
    'aria-controls': 'palette-list',
    'aria-label': 'Record, instant, state, panel, run or command',
    placeholder: '#137, 1:02.5, a state, a panel, a run, a command',
    spellcheck: 'false',
    autocomplete: 'off',
    'data-testid': 'go-to',
    oninput: () => suggest(),
    onkeydown: (event) => onKey(event),
  });
  const trouble = h(
    'p',
    {class: 'trouble', role: 'alert', hidden: true},
    'There is no such record, instant, state, panel, run or command.',
  );
  const button = (text, props) => h('button', {type: 'button', ...props}, text);
  const element = dialog(
    {class: 'dialog palette-dialog', 'aria-label': 'Go to'},
    h('h2', {}, 'Go to'),
    field,
    trouble,
    list,
    h(
      'div',
      {class: 'dialog-buttons'},
      button('Close', {onclick: () => element.close()}),
      button('Go', {class: 'primary', onclick: () => go()}),
    ),
  );

  function choices() {
    const {data, cursor, parts, model} = page();
    const states = data.graph.states.map(({id}) => ({
      name: id,
      kind: 'state',
      act: () => {
        const n = placeOf(data, id, cursor.n);
        if (n !== null) cursor.jump(n);
      },
    }));
    const panels = Object.entries(parts).map(([name, {element: part}]) => ({
      name: part.getAttribute('aria-label'),
      kind: 'panel',
      act: () => (part.closest('.tabs') ? page().showTab(name) : model.enlarge(name)),
    }));
    const commands = keys
      .filter(([names]) => names.length === 1)
      .map(([[key], , what, act]) => ({name: what, kind: key, act: () => act(page(), {key, shift: false})}));
    const others = (runs ?? []).map(({id, name}) => ({name, kind: 'run', act: () => model.open(id)}));
    return [...states, ...panels, ...commands, ...others];
  }
  function suggest() {
    const text = field.value.trim();
    const {data, cursor} = page();
    const place = /^[#\d]/.test(text) ? placeOf(data, text, cursor.n) : null;
    const direct =
      place === null ? [] : [{name: `#${place}: ${data.kind(place)}`, kind: 'record', act: () => cursor.jump(place)}];
    shown = [...direct, ...(text ? fitting(choices(), text) : [])].slice(0, most_shown);
    chosen = 0;
    trouble.hidden = true;
    draw();
  }
  function draw() {
    list.replaceChildren(
      ...shown.map((one, i) =>
        h(
          'li',
          {
            id: `palette-${i}`,
            role: 'option',
            'aria-selected': String(i === chosen),
            onclick: () => {
              chosen = i;
              go();
            },
          },
          h('span', {}, one.name),
          h('span', {class: 'muted'}, one.kind),
        ),
      ),
    );
    if (shown.length) field.setAttribute('aria-activedescendant', `palette-${chosen}`);
    else field.removeAttribute('aria-activedescendant');
    list.children[chosen]?.scrollIntoView({block: 'nearest'});
  }
  function onKey(event) {
    const by = {ArrowDown: 1, ArrowUp: -1}[event.key];
    if (event.key === 'Enter') go();
    else if (by && shown.length) {
      chosen = (chosen + by + shown.length) % shown.length;
      draw();
    } else return;
    event.preventDefault();
  }
  function go() {
    const one = shown[chosen];
    trouble.hidden = Boolean(one);
    if (!one) return;
    element.close();
    one.act();
  }
  return {
    element,
    open() {
      field.value = '';
      suggest();
      element.showModal();
      field.focus();
      if (!runs && listed)
        fetchRuns().then(
          (all) => {
            runs = all.filter((run) => !run.error);
          },
          () => {},
        );
    },
  };
}
