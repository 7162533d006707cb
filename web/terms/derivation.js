// The derivation that the server tells of (replay/explain/explain_derivation.h) at three depths: in words, as terms, and in
// continuation-passing style. Pure; knows no page.
//
// A node is {term, structure, type, how, n, rule, children, origin}; its path is '' for the root, '0.1' for the second
// child of the first.
import {apply, lambda, literal, name, print} from './term.js';
import {cps_apply, cps_const, states, variable} from './reduce.js';

export const depths = ['gloss', 'λ', 'CPS'];

const children = (node) =>
  Array.isArray(node?.children) ? node.children.filter((one) => one && typeof one === 'object') : [];
const textOf = (value) =>
  typeof value === 'string' ? value : value === null || value === undefined ? '' : JSON.stringify(value);

/** The node's term taken apart. */
const structureOf = (node) => node.structure ?? literal(textOf(node.term));

/** [{node, path, depth}] from the root down, children in order. */
export function walk(node, path = '', depth = 0) {
  if (!node || typeof node !== 'object') return [];
  return [
    {node, path, depth},
    ...children(node).flatMap((one, i) => walk(one, path ? `${path}.${i}` : `${i}`, depth + 1)),
  ];
}

export const nodeAt = (root, path) => walk(root).find((one) => one.path === path)?.node ?? null;

/** Whether the node stands for what has not been said yet. */
export const isHole = (node) => node?.origin?.kind === 'open';

/** The origins that one goes back through: “it”, then “the plate”. */
function links(origin) {
  const found = [];
  for (let at = origin; at && typeof at === 'object' && found.length < 8; at = at.from) found.push(at);
  return found;
}

const quoted = (words) => `“${words}”`;
const short_kinds = {
  pointing: 'pointing',
  gesture: 'gesture',
  taught: 'what was taught',
  machine: 'the machine',
  choice: 'one of several',
};

// A slot or register has its value since an input: "slot options since “Yes” (2.0 s)  #7".
const since = (link) => textOf(link.text).match(/ since (.*?) \(\d/)?.[1] ?? '';
const kept = (link) => textOf(link.text).match(/^(?:slot|register) \S+/)?.[0] ?? 'what was remembered';

/** The short name of one origin: “there”, pointing, gesture. */
function linkText(link) {
  if (link.words) return quoted(link.words);
  if (link.kind === 'words') return textOf(link.text).match(/“[^”]*”/)?.[0] ?? 'words';
  if (link.kind === 'slot' || link.kind === 'memory') return [since(link), kept(link)].filter(Boolean).join(', in ');
  return short_kinds[link.kind] ?? textOf(link.kind);
}

const isOfMachine = (node) => !children(node).length && node.origin?.kind === 'machine';

/** The meaning of a node in plain words: “put” + “there” (pointing). Parts of the machine itself are told alone only. */
export function gloss(node) {
  const parts = children(node),
    said = parts.filter((part) => !isOfMachine(part));
  const below = said.length ? said : parts;
  if (isHole(node)) return '▢';
  if (below.length && node.how === 'taught') return `one step of ${gloss(below[0])}`;
  if (below.length)
    return below
      .map(gloss)
      .filter((one, i, all) => one !== all[i - 1])
      .join(' + ');
  const told = links(node.origin).map(linkText);
  if (!told.length || ['machine', 'slot', 'memory'].includes(node.origin?.kind))
    return print(structureOf(node), {sign: 'λ'});
  return told.length > 1 ? `${told[0]} (${told.slice(1).join(', ')})` : told[0];
}

/** "from “there” at #2 and pointing at #3"; empty where nobody can be named. */
export function told(origin) {
  const from = links(origin).filter((link) => link.kind !== 'machine' && link.kind !== 'open');
  return from.length
    ? `from ${from.map((link) => `${linkText(link)}${numberOf(link) === null ? '' : ` at #${numberOf(link)}`}`).join(', ')}`
    : '';
}

const numberOf = (link) => (Number.isInteger(link.input) ? link.input : Number.isInteger(link.n) ? link.n : null);

/** The words and gestures behind a derivation, in the order of the log: [{key, n, text, kind, paths}]; `paths`: their leaves. */
export function sources(root) {
  const found = new Map();
  for (const {node, path} of walk(root)) {
    if (children(node).length) continue;
    for (const link of links(node.origin)) {
      const n = numberOf(link);
      if (n === null || link.kind === 'machine') continue;
      const held = since(link);
      const kind = held
        ? held.startsWith('“')
          ? 'words'
          : 'gesture'
        : ['words', 'choice', 'open'].includes(link.kind)
          ? 'words'
          : link.kind;
      const text =
        link.kind === 'open' || link.kind === 'choice'
          ? (textOf(link.text).match(/“[^”]*”(?= \()/)?.[0] ?? 'left open')
          : held || linkText(link);
      const key = `${n} ${kind} ${text}`;
      if (!found.has(key)) found.set(key, {key, n, kind, text, paths: []});
      if (!found.get(key).paths.includes(path)) found.get(key).paths.push(path);
    }
  }
  return [...found.values()].sort((a, b) => a.n - b.n);
}

/** 'e -> loc -> t' as its arguments and result: [['e', 'loc'], 't']. */
export function arrows(type) {
  const args = [];
  let rest = textOf(type).trim();
  for (;;) {
    let depth = 0;
    let at = -1;
    for (let i = 0; i < rest.length && at < 0; ++i) {
      if ('([<'.includes(rest[i])) ++depth;
      else if (')]'.includes(rest[i]) || (rest[i] === '>' && rest[i - 1] !== '-')) --depth;
      else if (!depth && rest.startsWith('->', i)) at = i;
    }
    if (at < 0) return [args, rest];
    args.push(rest.slice(0, at).trim());
    rest = rest.slice(at + 2).trim();
  }
}

export const shownType = (type) => textOf(type).replaceAll('->', '→');

/** The type of a computation that gives a value of this type: Comp a r = (a → r) → r. */
export function compType(type) {
  const text = shownType(type) || 'a';
  return `Comp ${/[ →]/.test(text) ? `(${text})` : text} r`;
}

const raised = (node, term) =>
  node.rule ? apply(name(textOf(node.rule), !/^\w+$/.test(textOf(node.rule))), term) : term;

// The function that is applied, with its arguments still open: put : e → loc → t is λx v. put(x, v).
function opened(node, term) {
  const [args] = arrows(typeOf(node));
  if (term.kind !== 'name' || !args.length) return term;
  const used = new Set([term.name]);
  const variables = args.map((type) => {
    let one = {e: 'x', loc: 'v', t: 'p', num: 'i', text: 's'}[type] ?? 'f';
    while (used.has(one)) one += "'";
    used.add(one);
    return one;
  });
  return variables.reduceRight((body, one) => lambda(one, body), apply(term, ...variables.map((one) => name(one))));
}

const binders = (node) => {
  const found = [];
  for (let at = structureOf(node); at.kind === 'lambda'; at = at.body) found.push(at.name);
  return found;
};

/** The type of a node, where the log leaves it out that of a lambda by its variables and its body. */
export function typeOf(node) {
  if (node.type || node.how !== 'abstraction') return textOf(node.type);
  const body = children(node)[0];
  const all = walk(body).map((one) => one.node);
  const types = binders(node).map((one) => all.find((each) => each.how === 'leaf' && each.term === one)?.type);
  return body?.type && types.every(Boolean)
    ? [...types, textOf(body.type)]
        .map((type, i) => (i < types.length && type.includes('->') ? `(${type})` : type))
        .join(' -> ')
    : '';
}

/** The term of a node before anything in it is applied. */
export function unreduced(node) {
  const below = children(node);
  if (node.how === 'application' && below.length === 2) {
    const [f, x] = below;
    const head = unreduced(f);
    return apply(f.how === 'leaf' ? opened(f, head) : head, raised(node, unreduced(x)));
  }
  if (node.how === 'abstraction' && below.length === 1)
    return binders(node).reduceRight((body, one) => lambda(one, body), unreduced(below[0]));
  if (node.how === 'taught' && below.length === 1) return unreduced(below[0]);
  return structureOf(node);
}

/** A node as a computation: applications by cpsApply, all else by cpsConst. */
export function computation(node) {
  const below = children(node);
  if (node.how === 'application' && below.length === 2) {
    const [f, x] = below.map(computation);
    return apply(cps_apply, f, node.rule ? apply(cps_apply, apply(cps_const, name(textOf(node.rule))), x) : x);
  }
  if (node.how === 'taught' && below.length === 1) return computation(below[0]);
  return apply(cps_const, structureOf(node));
}

// A term that waits for its argument is a function that gives a computation.
function asked(node) {
  const below = children(node);
  if (node.how === 'abstraction' && below.length === 1 && below[0].how === 'application')
    return binders(node).reduceRight((body, one) => lambda(one, body), apply(computation(below[0]), variable('k')));
  return apply(computation(node), variable('k'));
}

// The outermost term that the name is applied to something in.
function appliedBy(term, rule) {
  if (term.kind === 'apply' && term.head.kind === 'name' && term.head.name === rule) return term;
  for (const part of [term.head, term.body, ...(term.args ?? term.parts ?? [])]) {
    const found = part && appliedBy(part, rule);
    if (found) return found;
  }
  return null;
}

/** The states of the derivation at a depth, [{term, redex, rule, haskell}], the last with nothing left to do. */
export function stepsAt(root, depth) {
  if (!root || depth === 'gloss') return [];
  const haskell = depth === 'CPS';
  const all = states(haskell ? asked(root) : unreduced(root));
  // The machine knows the effect of a raising rule on its argument: the log has only the result.
  const last = all.at(-1);
  const rule = textOf(walk(root).find(({node}) => node.rule)?.node.rule);
  const raising = rule && !last.redex ? appliedBy(last.term, rule) : null;
  const result = structureOf(root);
  if (raising && root.how === 'application') {
    all[all.length - 1] = {...last, redex: raising, rule};
    all.push({term: haskell ? apply(variable('k'), result) : result, redex: null, rule: ''});
  }
  return all.map((one) => ({...one, haskell}));
}

/** One line for a node: {text, type}. */
export function line(node, depth) {
  if (depth === 'gloss') return {text: gloss(node), type: ''};
  const term = textOf(node.term);
  if (depth === 'λ') return {text: print(structureOf(node), {sign: 'λ'}), type: shownType(typeOf(node))};
  if (node.how === 'application')
    return {
      text: node.rule ? `cpsApply m (cpsApply (cpsConst ${textOf(node.rule)}) n)` : 'cpsApply m n',
      type: compType(node.type),
    };
  if (isHole(node)) return {text: `cpsConst ${term}`, type: compType(node.type)};
  if (node.how === 'abstraction') return {text: `λ ${binders(node).join(' ')} → …`, type: shownType(typeOf(node))};
  const structure = structureOf(node);
  const simple = structure.kind !== 'apply' && structure.kind !== 'lambda';
  return {text: `cpsConst ${simple ? term : `(${print(structure, {sign: 'λ'})})`}`, type: compType(node.type)};
}

const hows = {
  application: '',
  abstraction: 'what it lacks is left open',
  parts: 'put together by the machine; the log has no application of it',
  taught: 'one step of what was taught',
  leaf: '',
};

/** All that is known of a node in words, for those who do not see the tree. */
export function described(node) {
  const type = shownType(typeOf(node));
  return [
    type && `type ${type}`,
    hows[node.how] ?? textOf(node.how),
    node.rule && `raised by ${textOf(node.rule)}`,
    textOf(node.origin?.text),
  ]
    .filter(Boolean)
    .join('; ');
}
