// Panels of the run B beside those of A, and what differs between them.
import {mountStack} from './stack.js';
import {mountDerivation} from './derivation.js';

/** {stack_b, derivation_b}: what panels of B show where a record of A is selected. */
export function otherSide(app) {
  const {data, client} = app.comparison.side;
  const other = Object.create(app, {data: {value: data}, client: {value: client}, comparison: {value: null}, jump: {value: (n) => app.jumpOther(n)}});
  const sided = (name, mounted) => {
    const {element} = mounted, title = `${element.getAttribute('aria-label')} B`;
    element.dataset.panel = name;
    element.dataset.testid = `panel-${name}`;
    element.setAttribute('aria-label', title);
    element.querySelector('h2').textContent = title;
    for (const part of element.querySelectorAll('[role=region], [role=tree], [role=group]')) part.setAttribute('aria-label', `${part.getAttribute('aria-label')}, of B`);
    return {...mounted, render: (selection) => mounted.render({...selection, n: app.comparison.otherOf(selection)})};
  };
  return {stack_b: sided('stack_b', mountStack(other)), derivation_b: sided('derivation_b', mountDerivation(other))};
}

/** Marks the parts (what fits `selector`) of two panels that are not the same, whenever either has changed. */
export function keepMarked(a, b, selector) {
  const mark = () => {
    const [of_a, of_b] = [a, b].map((element) => [...element.querySelectorAll(selector)]);
    const [said_a, said_b] = [of_a, of_b].map((parts) => new Set(parts.map(saying)));
    for (const part of of_a) part.classList.toggle('differs', !said_b.has(saying(part)));
    for (const part of of_b) part.classList.toggle('differs', !said_a.has(saying(part)));
  };
  const observer = new MutationObserver(mark);
  for (const element of [a, b]) observer.observe(element, {childList: true, subtree: true});
}

// What a part says for itself, without when and where that was set.
const saying = (part) => (part.querySelector('.pair, .term') ?? part).textContent;
