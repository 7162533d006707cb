// Terms as logs write them (RUNLOG.md), taken apart for display and put together again. Pure; knows no page.
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
const most_letters = 200_000;
const deepest = 400;

const token =
  /\s*(?:(\d+(?:\.\d+)?(?:[eE][+-]?\d+)?)|([A-Za-z_][A-Za-z_0-9]*'*)|('(?:\\.|[^'\\])*')|(`(?:\\.|[^`\\])*`)|(!=|<=|>=|[()[\]<>,.:=+\-*/\\λ]))/y;

function* tokens(text) {
  token.lastIndex = 0;
  while (token.lastIndex < text.length) {
    const from = token.lastIndex;
    if (!text.slice(from).trim()) break;
    const found = token.exec(text);
    if (!found) throw new SyntaxError(`nothing of a term begins at letter ${from + 1}`);
    const [, number, word, quoted, back, sign] = found;
    const at = token.lastIndex;
    if (number) yield {kind: 'number', text: number, at};
    else if (quoted) yield {kind: 'text', text: quoted, at};
    else if (back) yield {kind: 'back', text: back.slice(1, -1).replace(/\\(.)/g, '$1'), at};
    else if (word && !['and', 'or', 'not'].includes(word)) yield {kind: 'word', text: word, at};
    else yield {kind: 'sign', text: word ?? (sign === 'λ' ? '\\' : sign), at};
    token.lastIndex = at;
  }
  yield {kind: 'end', text: '', at: text.length};
}

class Parser {
  constructor(text) {
    this.text = text;
    this.all = [...tokens(text)];
    this.place = 0;
    this.depth = 0;
  }
  get next() {
    return this.all[this.place];
  }
  is(sign) {
    return this.next.kind === 'sign' && this.next.text === sign;
  }
  take(sign) {
    if (!this.is(sign)) throw new SyntaxError(`found '${this.next.text}', expected '${sign}'`);
    ++this.place;
  }

  whole() {
    const term = this.expression(1);
    if (this.next.kind !== 'end') throw new SyntaxError(`found '${this.next.text}' after the term`);
    return term;
  }

  expression(least) {
    if (++this.depth > deepest) throw new SyntaxError('nested too deep');
    let left = this.prefixed();
    for (;;) {
      const sign = this.next;
      const row = sign.kind === 'sign' ? infixes.get(sign.text) : null;
      if (!row || row[0] < least) break;
      ++this.place;
      left = {kind: 'apply', head: name(sign.text), args: [left, this.expression(row[0] + 1)]};
    }
    --this.depth;
    return left;
  }

  prefixed() {
    if (this.is('not')) {
      ++this.place;
      return {kind: 'apply', head: name('not'), args: [this.expression(4)]};
    }
    if (!this.is('-')) return this.postfixed();
    ++this.place;
    const number = this.next.kind === 'number';
    const inner = this.expression(operand);
    return number && inner.kind === 'literal'
      ? literal(`-${inner.text}`)
      : {kind: 'apply', head: name('negate'), args: [inner]};
  }

  postfixed() {
    let term = this.primary();
    while (this.is('(')) {
      ++this.place;
      term = apply(term, ...this.separated(')'));
    }
    return term;
  }

  primary() {
    const {kind, text} = this.next;
    if (this.is('\\')) return this.lambda();
    if (this.is('(')) return this.parenthesised();
    if (this.is('[')) {
      ++this.place;
      return {kind: 'list', parts: this.is(']') ? (++this.place, []) : this.separated(']')};
    }
    if (this.is('<')) return this.point();
    if (kind === 'sign' || kind === 'end') throw new SyntaxError(`found '${text}', expected a term`);
    ++this.place;
    if (kind === 'number' || kind === 'text' || (kind === 'word' && keywords.has(text))) return literal(text);
    return name(text, kind === 'back');
  }

  parenthesised() {
    this.take('(');
    const sign = this.next;
    const after = this.all[this.place + 1];
    if (sign.kind === 'sign' && (infixes.has(sign.text) || sign.text === 'not') && after?.text === ')') {
      this.place += 2;
      return name(sign.text);
    }
    const inner = this.expression(1);
    this.take(')');
    return inner;
  }

  point() {
    this.take('<');
    const parts = [];
    for (let i = 0; i < 3; ++i) {
      if (i) this.take(',');
      parts.push(this.expression(sum));
    }
    this.take('>');
    return {kind: 'point', parts};
  }

  lambda() {
    this.take('\\');
    const names = [];
    while (this.next.kind === 'word') names.push(this.all[this.place++].text);
    if (!names.length) throw new SyntaxError('a lambda without a variable');
    let type = null;
    if (this.is(':')) {
      const from = this.next.at;
      while (!this.is('.') && this.next.kind !== 'end') ++this.place;
      type = this.text.slice(from, this.next.at - 1).trim();
    }
    this.take('.');
    return names.reduceRight(
      (body, one, i) => lambda(one, body, i === names.length - 1 ? type : null),
      this.expression(1),
    );
  }

  separated(close) {
    const parts = [this.expression(1)];
    while (this.is(',')) {
      ++this.place;
      parts.push(this.expression(1));
    }
    this.take(close);
    return parts;
  }
}

/** The term that the text is, or a literal of the whole text where it is none that can be read. */
export function parse(text) {
  try {
    if (text.length > most_letters) throw new SyntaxError('too long');
    return new Parser(text).whole();
  } catch (problem) {
    if (!(problem instanceof SyntaxError) && !(problem instanceof RangeError)) throw problem;
    return literal(text);
  }
}

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
