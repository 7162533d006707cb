// The server's addresses. An answer is JSON or bytes; an error carries a sentence for the reader. An exported page, or a
// site of them, has no server: it brings the answers along.

import {Recorded} from './recorded.js';
import {Site} from './site.js';

const exported = globalThis.continua_recorded;
const recorded = !exported ? null : exported.answers ? new Recorded(exported) : new Site(exported);

// Requests made before this module was loaded; each answer is taken once.
const early = globalThis.continua_early ?? new Map();
function taken(path) {
  const answer = early.get(path);
  early.delete(path);
  return answer;
}

/** @returns {Promise<Response>} of the server, or what was recorded of it. */
async function ask(path, options = {}) {
  const response = await (recorded ? recorded.answer(path) : (taken(path) ?? fetch(path, options)));
  if (response.ok) return response;
  const body = await response.json().catch(() => null);
  throw Object.assign(new Error(body?.error?.message ?? `${path}: ${response.status}`), {status: response.status});
}
const get = (path) => ask(path, {headers: {Accept: 'application/json'}}).then((response) => response.json());
const bytes = (path) => ask(path).then((response) => response.arrayBuffer());
const send = (method, path, body) =>
  ask(path, {method, headers: {'Content-Type': 'application/json'}, body: JSON.stringify(body)}).then((response) =>
    response.json(),
  );

const run = (id) => `/api/runs/${encodeURIComponent(id)}`;

/** Whether there is a server that can replay, save notes, and tell of runs that grow. */
export const served = recorded === null;
/** Whether there may be more than one run. */
export const listed = !(recorded instanceof Recorded);

export const fetchRuns = () => get('/api/runs').then((answer) => answer.runs);
/** In a site: run -> [number of the record, what was said, shown or done][]; of a server null. */
export const fetchWords = async () => (served ? null : get('/api/words'));
export const fetchDiff = (a, b) => get(`/api/diff?a=${encodeURIComponent(a)}&b=${encodeURIComponent(b)}`);
export const askWhatIf = (question) => send('POST', '/api/what-if', question);

const part_bytes = 1 << 20; // the server takes so much at a time
const largest_bytes = 64 * part_bytes;
/**
 * Hands a run log or a trace to the server. `coming()` is called when it only remains to be opened, or replayed.
 * @returns {Promise<{run: string}>}
 */
export async function handOver(file, coming) {
  if (file.size > largest_bytes)
    throw new Error(`it has more than ${largest_bytes / part_bytes} MiB; begin “continua serve” with it instead`);
  const key = [...crypto.getRandomValues(new Uint32Array(3))].map((part) => part.toString(36)).join('');
  const parts = Math.max(1, Math.ceil(file.size / part_bytes));
  let answer = null;
  for (let part = 0; part < parts; ++part) {
    const last = part === parts - 1;
    if (last) coming();
    const query = new URLSearchParams({file: key, name: file.name, part, last: last ? 1 : 0});
    const response = await ask(`/api/dropped?${query}`, {
      method: 'POST',
      headers: {'Content-Type': 'application/octet-stream'},
      body: file.slice(part * part_bytes, (part + 1) * part_bytes),
    });
    answer = await response.json();
  }
  return answer;
}
export const pictureOf = (id, t, size) => `${run(id)}/frame?t=${t}&size=${size}`;

let schema = null;
// The same as long as the server lives.
const fetchSchema = () => (schema ??= get('/api/schema'));

// The recordings that the run's trace names, each with the address of its bytes in `src`.
const fetchMedia = (id) =>
  get(`${run(id)}/media`).then(
    ({media}) => media.map((one, i) => ({src: recorded?.media?.get(i) ?? `${run(id)}/media/${i}`, ...one})),
    () => [],
  );

/** All that the page of a run needs at once. */
export async function fetchRun(id) {
  const [summary, graph, columns, schema, media] = await Promise.all([
    get(run(id)),
    get(`${run(id)}/graph`),
    bytes(`${run(id)}/columns`),
    fetchSchema(),
    fetchMedia(id),
  ]);
  return {summary, graph, columns, schema, media};
}

/** Calls `grown({records, t, complete, live})` whenever the run's log has grown. @returns what to close when enough is heard. */
export function listenTo(id, grown) {
  const stream = new EventSource(`/api/live?run=${encodeURIComponent(id)}`);
  stream.addEventListener('grown', (event) => grown(JSON.parse(event.data)));
  return stream;
}

const most_kept = 400;
const at_once = 5000; // records of a stretch in one answer

/** Answers about a run, the latest few hundred kept: a log does not change under its index. */
export class RecordClient {
  #kept = new Map();

  constructor(id) {
    this.id = id;
  }

  record(n) {
    return this.#keep(`records?after=${n}&limit=1`).then((answer) => answer.records[0]);
  }
  /** Records of a kind from n on, up to `limit`. */
  records(kind, after, limit) {
    return this.#keep(`records?kind=${encodeURIComponent(kind)}&after=${after}&limit=${limit}`).then(
      (answer) => answer.records,
    );
  }
  /** The records of a stretch, in seconds, as lines of JSON. */
  async linesOf([from, to]) {
    const lines = [];
    for (let after = 0; after !== null; ) {
      const part = await get(`${run(this.id)}/records?from=${from}&to=${to}&after=${after}&limit=${at_once}`);
      for (const record of part.records) lines.push(`${JSON.stringify(record)}\n`);
      after = part.next;
    }
    return lines.join('');
  }
  /** `branch`: of that of several configurations; null: of the leading one. */
  stack(n, branch = null) {
    return this.#keep(`stack?n=${n}${branch === null ? '' : `&branch=${branch}`}`);
  }
  /** Why record n; given a cell of the stack, how the value that record n gave it came about. */
  explain(n, cell = '') {
    return this.#keep(`explain?n=${n}${cell ? `&cell=${encodeURIComponent(cell)}` : ''}`);
  }
  labels(numbers) {
    return get(`${run(this.id)}/labels?n=${numbers.join(',')}`).then((answer) => answer.labels);
  }
  /** Running numbers of the records that match, in order. */
  find(text, kind) {
    return bytes(`${run(this.id)}/find?text=${encodeURIComponent(text)}&kind=${encodeURIComponent(kind)}`).then(
      (answer) => new Uint32Array(answer),
    );
  }
  /** The run in words: {sentences, acts, minutes}. */
  account() {
    return this.#keep('account');
  }
  scene() {
    return this.#keep('scene');
  }
  /** Motion, pointing and acts in a window of seconds. Not kept here: Motion keeps the windows that it needs. */
  poses(from, to) {
    return get(`${run(this.id)}/poses?from=${from.toFixed(3)}&to=${to.toFixed(3)}`);
  }
  /** The loudness of the recording number i: {per_second, values}. */
  peaks(i) {
    return get(`${run(this.id)}/media/${i}/peaks`);
  }
  notes() {
    return get(`${run(this.id)}/notes`);
  }
  saveNotes(notes) {
    return send('PUT', `${run(this.id)}/notes`, notes);
  }

  #keep(path) {
    if (!this.#kept.has(path)) {
      if (this.#kept.size >= most_kept) this.#kept.delete(this.#kept.keys().next().value);
      this.#kept.set(
        path,
        get(`${run(this.id)}/${path}`).catch((problem) => {
          this.#kept.delete(path);
          throw problem;
        }),
      );
    }
    return this.#kept.get(path);
  }

  /** Drops all answers: the log has grown. */
  forget() {
    this.#kept.clear();
  }

  /** Resolves when all that was asked for has come. */
  idle() {
    return Promise.allSettled(this.#kept.values());
  }
}
