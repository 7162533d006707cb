// Terms worked out step by step: β, and the two functions of continuation-passing style. Pure; knows no page.
import {apply, lambda, name} from './term.js';

/** A name that is bound, or one of the two functions below: written before what it is applied to. */
export const variable = (text) => ({...name(text), variable: true});
export const cps_apply = variable('cpsApply');
export const cps_const = variable('cpsConst');

const parts = (term) =>
  term.kind === 'apply' ? [term.head, ...term.args] : term.kind === 'lambda' ? [term.body] : (term.parts ?? []);

function rebuilt(term, make) {
  if (term.kind === 'lambda') return {...term, body: make(term.body)};
  if (term.kind === 'apply') return apply(make(term.head), ...term.args.map(make));
  if (term.parts) return {...term, parts: term.parts.map(make)};
  return term;
}

/** The names that stand free in the term. */
export function free(term, found = new Set(), bound = []) {
  if (term.kind === 'name' && !term.quoted && !bound.includes(term.name)) found.add(term.name);
  for (const part of parts(term)) free(part, found, term.kind === 'lambda' ? [...bound, term.name] : bound);
  return found;
}

const unused = (text, taken) => {
  while (taken.has(text)) text += "'";
  return text;
};

/** `term` with `value` for the free variable; binders that would catch a name of the value get another. */
export function substituted(term, variable_name, value, reach = free(value)) {
  if (term.kind === 'name') return term.name === variable_name && !term.quoted ? value : term;
  if (term.kind !== 'lambda') return rebuilt(term, (part) => substituted(part, variable_name, value, reach));
  if (term.name === variable_name) return term;
  let {name: binder, body} = term;
  if (reach.has(binder)) {
    const inner = free(body);
    if (inner.has(variable_name)) {
      const other = unused(binder, new Set([...reach, ...inner]));
      body = substituted(body, binder, variable(other));
      binder = other;
    }
  }
  return {...term, name: binder, body: substituted(body, variable_name, value, reach)};
}

function contracted({head, args}) {
  if (head.kind === 'lambda') {
    const [first, ...rest] = args;
    const made = substituted(head.body, head.name, first);
    return ['β', rest.length ? apply(made, ...rest) : made];
  }
  if (head === cps_const && args.length >= 2) return ['cpsConst', apply(args[1], args[0], ...args.slice(2))];
  if (head !== cps_apply || args.length < 3) return null;
  const [m, n, k, ...rest] = args;
  const taken = new Set([...free(m), ...free(n), ...free(k)]);
  const b = unused('b', taken);
  const a = unused('a', taken);
  const made = apply(n, lambda(b, apply(m, lambda(a, apply(k, apply(variable(a), variable(b)))))));
  return ['cpsApply', rest.length ? apply(made, ...rest) : made];
}

/** The leftmost outermost redex worked out: {term, redex: the very object, rule}, or null where there is none. */
export function step(term) {
  const made = term.kind === 'apply' ? contracted(term) : null;
  if (made) return {rule: made[0], term: made[1], redex: term};
  let found = null;
  const next = rebuilt(term, (part) => {
    if (found) return part;
    found = step(part);
    return found ? found.term : part;
  });
  return found && {...found, term: next};
}

const size = (term) => 1 + parts(term).reduce((sum, part) => sum + size(part), 0);
const most_steps = 120;
const largest = 3000;

/** [{term, redex, rule}]: each state of the term with the redex that is worked out next, null in the last. */
export function states(term) {
  const all = [];
  for (;;) {
    const next = all.length < most_steps && size(term) < largest ? step(term) : null;
    all.push({term, redex: next?.redex ?? null, rule: next?.rule ?? ''});
    if (!next) return all;
    term = next.term;
  }
}
