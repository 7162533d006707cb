// The kinds of records and their members, as the program that serves the page declares them.

const none = {when: '', members: []};

export class Schema {
  #kinds;
  #stamp;

  /** `stamp` and `kinds` as /api/schema gives them. */
  constructor({stamp, kinds}) {
    this.#kinds = new Map(kinds.map((kind) => [kind.name, kind]));
    this.#stamp = stamp;
  }

  /** One sentence: when a record of the kind is written; '' for a kind that the program does not know. */
  when(kind) {
    return this.#of(kind).when;
  }

  /** Whether records of every kind have the member. */
  isStamp(name) {
    return name === 'kind' || this.#stamp.some((member) => member.name === name);
  }

  /** One sentence: the meaning of a record's member; '' if it is not declared. */
  meaning(kind, name) {
    return [...this.#of(kind).members, ...this.#stamp].find((member) => member.name === name)?.meaning ?? '';
  }

  #of(kind) {
    return this.#kinds.get(kind) ?? none;
  }
}
