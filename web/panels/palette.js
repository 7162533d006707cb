// Goes to whatever is typed: a record, an instant, a state, an object, a panel, another run; or does what a key does. Suggestions
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

/** All that `page` can go to by a name, besides records and instants. `runs`: the listed ones. */
function choicesOf(page, runs) {
  const {data, cursor, parts, model} = page;
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
    act: () => (part.closest('.tabs') ? page.showTab(name) : model.enlarge(name)),
  }));
  const commands = keys
    .filter(([names]) => names.length === 1)
    .map(([[key], , what, act]) => ({name: what, kind: key, act: () => act(page, {key, shift: false})}));
  const things = parts.scene.things.map((one) => ({...one, kind: 'object'}));
  const others = runs.map(({id, name}) => ({name, kind: 'run', act: () => model.open(id)}));
  return [...states, ...things, ...panels, ...commands, ...others];
}

/** The record or instant that `text` names, and the choices that fit it. */
function suggestionsFor(text, page, runs) {
  const {data, cursor} = page;
  const place = /^[#\d]/.test(text) ? placeOf(data, text, cursor.n) : null;
  const direct =
    place === null ? [] : [{name: `#${place}: ${data.kind(place)}`, kind: 'record', act: () => cursor.jump(place)}];
  return [...direct, ...(text ? fitting(choicesOf(page, runs), text) : [])].slice(0, most_shown);
}

class Palette {
  constructor(page) {
    this.page = page;
    this.runs = [];
    this.shown = [];
    this.chosen = 0;
    this.list = h('ul', {id: 'palette-list', role: 'listbox', 'aria-label': 'Suggestions'});
    this.field = h('input', {
      type: 'text',
      role: 'combobox',
      'aria-expanded': 'true',
      'aria-controls': 'palette-list',
      'aria-label': 'Record, instant, state, object, panel, run or command',
      placeholder: '#137, 1:02.5, a state, an object, a panel, a run, a command',
      spellcheck: 'false',
      autocomplete: 'off',
      'data-testid': 'go-to',
      oninput: () => this.suggest(),
      onkeydown: (event) => this.onKey(event),
    });
    this.trouble = h(
      'p',
      {class: 'trouble', role: 'alert', hidden: true},
      'There is no such record, instant, state, object, panel, run or command.',
    );
    const button = (text, props) => h('button', {type: 'button', ...props}, text);
    this.element = dialog(
      {class: 'dialog palette-dialog', 'aria-label': 'Go to'},
      h('h2', {}, 'Go to'),
      this.field,
      this.trouble,
      this.list,
      h(
        'div',
        {class: 'dialog-buttons'},
        button('Close', {onclick: () => this.element.close()}),
        button('Go', {class: 'primary', onclick: () => this.go()}),
      ),
    );
  }

  open() {
    this.field.value = '';
    this.suggest();
    this.element.showModal();
    this.field.focus();
    if (!this.runs.length && listed)
      fetchRuns().then(
        (all) => {
          this.runs = all.filter((run) => !run.error);
        },
        () => {},
      );
  }

  suggest() {
    this.shown = suggestionsFor(this.field.value.trim(), this.page(), this.runs);
    this.chosen = 0;
    this.trouble.hidden = true;
    this.draw();
  }

  draw() {
    const option = ({name, kind}, i) =>
      h(
        'li',
        {
          id: `palette-${i}`,
          role: 'option',
          'aria-selected': String(i === this.chosen),
          onclick: () => {
            this.chosen = i;
            this.go();
          },
        },
        h('span', {}, name),
        h('span', {class: 'muted'}, kind),
      );
    this.list.replaceChildren(...this.shown.map(option));
    if (this.shown.length) this.field.setAttribute('aria-activedescendant', `palette-${this.chosen}`);
    else this.field.removeAttribute('aria-activedescendant');
    this.list.children[this.chosen]?.scrollIntoView({block: 'nearest'});
  }

  onKey(event) {
    const by = {ArrowDown: 1, ArrowUp: -1}[event.key];
    if (event.key === 'Enter') this.go();
    else if (by && this.shown.length) {
      this.chosen = (this.chosen + by + this.shown.length) % this.shown.length;
      this.draw();
    } else return;
    event.preventDefault();
  }

  go() {
    const one = this.shown[this.chosen];
    this.trouble.hidden = Boolean(one);
    if (!one) return;
    this.element.close();
    one.act();
  }
}

/** `page()`: the RunPage that is shown. */
export function paletteDialog(page) {
  return new Palette(page);
}
