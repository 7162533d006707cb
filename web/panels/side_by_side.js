// The panels of run B next to those of A, and the marks on their differences.
import {mountStack} from './stack.js';
import {mountDerivation} from './derivation.js';

/** {stack_b, derivation_b}: panels that show B's counterpart of the record of A that is selected. */
export function otherSide({comparison, model, jump}) {
  const {data, client} = comparison.side;
  const needs = {data, client, model, jump: (n) => jump(comparison.toOwn(n))};
  const sided = (name, mounted) => {
    rename(mounted.element, name);
    return {
      element: mounted.element,
      render: (selection) => mounted.render({...selection, n: comparison.otherOf(selection)}),
      labelsArrived: () => mounted.labelsArrived?.(),
      close: () => mounted.close?.(),
    };
  };
  return {stack_b: sided('stack_b', mountStack(needs)), derivation_b: sided('derivation_b', mountDerivation(needs))};
}

function rename(element, name) {
  const title = `${element.getAttribute('aria-label')} B`;
  element.dataset.panel = name;
  element.dataset.testid = `panel-${name}`;
  element.setAttribute('aria-label', title);
  element.querySelector('h2').textContent = title;
  for (const part of element.querySelectorAll('[role=region], [role=tree], [role=group]'))
    part.setAttribute('aria-label', `${part.getAttribute('aria-label')}, of B`);
}

/** Marks the parts of two panels (those that fit `selector`) that differ, whenever either panel has changed. */
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

// The words of a part, without when and where they were set.
const saying = (part) => (part.querySelector('.pair, .term') ?? part).textContent;
