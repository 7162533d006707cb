// Brief texts of records, fetched when a panel first asks and kept: a run of a million records has too many to send at once.

const most_asked = 500;
const most_kept = 20000;
const wait_ms = 15;

export class Labels {
  #client;
  #arrived;
  #known = new Map();
  #wanted = new Set();
  #timer = 0;
  #coming = 0;

  /** `arrived()` is called when labels that were asked for have come. */
  constructor(client, arrived) {
    this.#client = client;
    this.#arrived = arrived;
  }

  /** The record in brief, in words, '' until it has come. */
  label(n) {
    const [logged, , in_words] = this.#pair(n);
    return in_words ?? logged;
  }
  /** The same as logged where that is something else, otherwise null. */
  raw(n) {
    const [logged, , in_words] = this.#pair(n);
    return in_words == null ? null : logged;
  }
  /** Why an act went otherwise, in words; '' where there is no reason, or until it has come. */
  reason(n) {
    return this.#pair(n)[3] ?? '';
  }
  /** The words alone of something said, shown, done or observed. */
  text(n) {
    return this.#pair(n)[1];
  }
  /** Asks for many at once. */
  want(numbers) {
    for (const n of numbers) this.#pair(n);
  }
  get idle() {
    return !this.#timer && !this.#coming;
  }

  #pair(n) {
    const known = this.#known.get(n);
    if (known) return known;
    this.#wanted.add(n);
    this.#timer ||= setTimeout(() => this.#fetch(), wait_ms);
    return nothing;
  }

  async #fetch() {
    this.#timer = 0;
    // The latest wishes first: records that were scrubbed past matter less.
    const wanted = [...this.#wanted].filter((n) => !this.#known.has(n)).slice(-most_asked);
    this.#wanted.clear();
    if (!wanted.length) return;
    ++this.#coming;
    try {
      const labels = await this.#client.labels(wanted);
      if (this.#known.size > most_kept) this.#known.clear();
      for (const [n, pair] of Object.entries(labels)) this.#known.set(Number(n), pair);
    } catch {
      for (const n of wanted) this.#known.set(n, ['(could not be read)', '']);
    }
    --this.#coming;
    this.#arrived();
  }
}
const nothing = ['', ''];
