// Stands in for the server in an exported page, which carries the answers about its one run.
import {readColumns} from './columns.js';
import {lastAtMost} from '../search.js';

const bytesOf = (base64) => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)).buffer;

export class Recorded {
  #answers;
  #parsed = new Map();

  /** `answers`: what was asked -> the answer as JSON text; `media`: number of a recording in the file -> its address. */
  constructor({answers, media}) {
    this.#answers = answers;
    this.media = media;
    const numbers = (kind) =>
      [
        ...new Set(
          [...answers.keys()].filter((key) => key.startsWith(`${kind} `)).map((key) => Number(key.split(' ')[1])),
        ),
      ].sort((a, b) => a - b);
    this.marks = numbers('stack');
    this.branchings = numbers('branch');
  }

  /** As fetch() would answer a request for this path. */
  async answer(path) {
    const url = new URL(path, 'http://localhost');
    const query = url.searchParams;
    const sound = /\/media\/(\d+)\/peaks$/.exec(url.pathname)?.[1];
    const view = sound ? `peaks ${sound}` : /^\/api\/(?:runs\/[^/]+\/?)?([a-z]*)$/.exec(url.pathname)?.[1] || 'run';
    const n = Number(query.get('n'));
    const own = {
      columns: () => this.#columns(),
      labels: () => ({labels: this.#labels(query)}),
      find: () => this.#find(query),
      records: () => this.#records(query),
      stack: () =>
        query.has('branch')
          ? this.#get(`branch ${this.branchings[lastAtMost(this.branchings, n)]} ${query.get('branch')}`)
          : this.#get(`stack ${this.marks[Math.max(0, lastAtMost(this.marks, n))]}`),
      explain: () => (query.has('cell') ? undefined : this.#get(`explain ${n}`)),
    }[view];
    const body = own ? own() : this.#get(view);
    if (body === undefined)
      return {
        ok: false,
        status: 404,
        json: async () => ({
          error: {
            message: 'An exported page tells this of the records that the arrow keys stop at; a served one of all.',
          },
        }),
      };
    return {ok: true, status: 200, json: async () => body, arrayBuffer: async () => body};
  }

  #get(key) {
    if (!this.#parsed.has(key)) {
      const text = this.#answers.get(key);
      if (text === undefined) return undefined;
      this.#parsed.set(key, JSON.parse(text));
    }
    return this.#parsed.get(key);
  }
  #columns() {
    return bytesOf(this.#get('columns'));
  }
  #labels(query) {
    const all = this.#get('labels');
    return Object.fromEntries(
      (query.get('n') ?? '')
        .split(',')
        .filter(Boolean)
        .map((n) => [n, all[Number(n)] ?? ['', '']]),
    );
  }
  #find(query) {
    const {kinds, columns} = (this.#columns_read ??= readColumns(this.#columns()));
    const words = query.get('text').toLowerCase().split(/\s+/).filter(Boolean);
    const kind = query.get('kind');
    const labels = this.#get('labels');
    const numbers = kind === '' ? columns.stop : columns.kind.keys();
    const found = [];
    for (const n of numbers) {
      const name = kinds[columns.kind[n]];
      if (kind !== '' && kind !== '*' && name !== kind) continue;
      const line = `${name} ${labels[n]?.[0] ?? ''}\n${labels[n]?.[2] ?? ''}`.toLowerCase();
      if (words.every((word) => line.includes(word))) found.push(n);
    }
    return Uint32Array.from(found).buffer;
  }
  #columns_read = null;
  #records(query) {
    const kind = query.get('kind');
    const after = Number(query.get('after') ?? 0);
    const limit = Number(query.get('limit') ?? 500);
    const from = Number(query.get('from') ?? -Infinity);
    const to = Number(query.get('to') ?? Infinity);
    const records = [];
    for (let n = after; ; ++n) {
      const text = this.#answers.get(`record ${n}`);
      if (text === undefined) return {records, next: null};
      if (records.length === limit) return {records, next: n};
      const record = JSON.parse(text);
      if ((!kind || record.kind === kind) && record.t >= from && record.t <= to) records.push(record);
    }
  }
}
