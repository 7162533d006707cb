// The server's addresses. Every answer is JSON; an error carries a sentence for the reader.

async function get(path, signal) {
  const response = await fetch(path, {signal, headers: {Accept: 'application/json'}});
  const body = await response.json().catch(() => null);
  if (!response.ok) throw new Error(body?.error?.message ?? `${path}: ${response.status}`);
  return body;
}

const run = (id) => `/api/runs/${encodeURIComponent(id)}`;

export const fetchRuns = () => get('/api/runs').then((answer) => answer.runs);

/** Everything the page needs at once. */
export async function fetchRun(id) {
  const [summary, graph, lanes] = await Promise.all([get(run(id)), get(`${run(id)}/graph`), get(`${run(id)}/lanes`)]);
  return {summary, graph, lanes};
}

/** Answers about single records, the latest few hundred kept: a log does not change under its index. */
export class RecordClient {
  #id;
  #kept = new Map();

  constructor(id) { this.#id = id; }

  record(n) {
    return this.#keep(`record ${n}`, () => get(`${run(this.#id)}/records?after=${n}&limit=1`).then((a) => a.records[0]));
  }
  stack(n) { return this.#keep(`stack ${n}`, () => get(`${run(this.#id)}/stack?n=${n}`)); }
  derivation(n) { return this.#keep(`derivation ${n}`, () => get(`${run(this.#id)}/derivation?n=${n}`)); }
  scene() { return this.#keep('scene', () => get(`${run(this.#id)}/scene`)); }
  /** Not kept: Motion keeps what it needs. */
  poses(from, to) { return get(`${run(this.#id)}/poses?from=${from.toFixed(6)}&to=${to.toFixed(6)}`); }
  frameAddress(t, width, height) { return `${run(this.#id)}/frame?t=${Math.max(0, t).toFixed(3)}&size=${width}x${height}`; }

  #keep(key, fetched) {
    if (!this.#kept.has(key)) {
      if (this.#kept.size >= 400) this.#kept.delete(this.#kept.keys().next().value);
      this.#kept.set(key, fetched().catch((problem) => { this.#kept.delete(key); throw problem; }));
    }
    return this.#kept.get(key);
  }

  /** Resolves when all that was asked for has come. */
  idle() { return Promise.allSettled(this.#kept.values()); }
}
