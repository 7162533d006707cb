// Terms taken apart, as the server tells them (engine/term/term_structure.h), for display. Pure; knows no page.
//
// A term is one of
//   {kind: 'literal', text}                 a number, 'a text', null, true, false
//   {kind: 'name', name, quoted}            a variable or a constant; quoted: `in backquotes`
//   {kind: 'lambda', name, type, body}      of one variable; type: text or null
//   {kind: 'apply', head, args}             head(a, b); operators too: their head is a name such as '+'
//   {kind: 'list', parts}  {kind: 'point', parts}

export const literal = (text) => ({kind: 'literal', text});
export const name = (text, quoted = false) => ({kind: 'name', name: text, quoted});
export const lambda = (variable, body, type = null) => ({kind: 'lambda', name: variable, type, body});
/** f(a)(b) is f(a, b). */
export const apply = (head, ...args) =>
  head.kind === 'apply' ? {kind: 'apply', head: head.head, args: [...head.args, ...args]} : {kind: 'apply', head, args};

// sign → [strength of its binding, weakest term to its left, to its right]
const infixes = new Map([
  ['or', [1, 1, 2]],
  ['and', [2, 2, 3]],
  ['+', [5, 5, 6]],
  ['-', [5, 5, 6]],
  ['*', [6, 6, 7]],
  ['/', [6, 6, 7]],
  ...['=', '!=', '<', '<=', '>', '>='].map((sign) => [sign, [4, 5, 5]]),
]);
const negation = 3;
const sum = 5;
const minus = 7;
const operand = 8;
const keywords = new Set(['null', 'true', 'false', 'and', 'or', 'not']);
const plain = /^[A-Za-z_][A-Za-z_0-9]*'*$/;

/** Pieces of text, [{text, marked}], of which those of the sub-term `mark` (the very object) are marked. */
export class Printer {
  #pieces = [];
  #marked = false;

  /** `haskell`: functions that no name of the world is are written before their arguments without commas: k (f x). */
  constructor({sign = '\\', mark = null, haskell = false} = {}) {
    Object.assign(this, {sign, mark, haskell});
  }

  #put(text) {
    const last = this.#pieces.at(-1);
    if (last && last.marked === this.#marked) last.text += text;
    else this.#pieces.push({text, marked: this.#marked});
  }

  #name(one) {
    if (one.quoted || !(plain.test(one.name) && !keywords.has(one.name)))
      this.#put(
        infixes.has(one.name) || one.name === 'not' ? `(${one.name})` : `\`${one.name.replace(/[`\\]/g, '\\$&')}\``,
      );
    else this.#put(one.name);
  }

  #list(parts, open, close, least) {
    this.#put(open);
    parts.forEach((part, i) => {
      if (i) this.#put(', ');
      this.#print(part, least);
    });
    this.#put(close);
  }

  #closed(on, print) {
    if (on) this.#put('(');
    print();
    if (on) this.#put(')');
  }

  #lambda(term, least) {
    this.#closed(least > 0, () => {
      this.#put(this.sign + (this.haskell ? ' ' : ''));
      let body = term;
      let first = true;
      for (; body.kind === 'lambda' && (first || body !== this.mark); body = body.body) {
        this.#put(first ? body.name : ` ${body.name}`);
        first = false;
        if (body.type !== null) {
          this.#put(`: ${body.type}`);
          body = body.body;
          break;
        }
      }
      this.#put(this.haskell ? ' → ' : '. ');
      this.#print(body, 0);
    });
  }

  #apply(term, least) {
    const {head, args} = term;
    const sign = head.kind === 'name' && !head.quoted ? head.name : '';
    const row = infixes.get(sign);
    if (row && args.length === 2)
      return this.#closed(row[0] < least, () => {
        this.#print(args[0], row[1]);
        this.#put(` ${sign} `);
        this.#print(args[1], row[2]);
      });
    if (sign === 'not' && args.length === 1)
      return this.#closed(negation < least, () => {
        this.#put('not ');
        this.#print(args[0], negation);
      });
    if (sign === 'negate' && args.length === 1)
      return this.#closed(minus < least, () => {
        this.#put('-');
        this.#print(args[0], minus);
      });
    if (this.haskell && !(head.kind === 'name' && !head.variable))
      return this.#closed(least > sum, () => {
        this.#print(head, operand);
        for (const one of args) {
          this.#put(' ');
          const call = one.kind === 'apply' && one.head.kind === 'name' && !one.head.variable;
          this.#closed(call, () => this.#print(one, call ? 0 : operand));
        }
      });
    this.#print(head, operand);
    return this.#list(args, '(', ')', 0);
  }

  #print(term, least) {
    const outer = this.#marked;
    if (term === this.mark) this.#marked = true;
    if (term.kind === 'literal') this.#put(term.text);
    else if (term.kind === 'name') this.#name(term);
    else if (term.kind === 'lambda') this.#lambda(term, least);
    else if (term.kind === 'list') this.#list(term.parts, '[', ']', 0);
    else if (term.kind === 'point') this.#list(term.parts, '<', '>', sum);
    else this.#apply(term, least);
    this.#marked = outer;
  }

  pieces(term) {
    this.#pieces = [];
    this.#print(term, 0);
    return this.#pieces;
  }
}

export const print = (term, options) =>
  new Printer(options)
    .pieces(term)
    .map(({text}) => text)
    .join('');

/** The text with its numbers rounded to three decimals. */
export const shorter = (text) => text.replace(/-?\d+\.\d{3,}/g, (number) => String(+Number(number).toFixed(3)));
