// One live session at the server: questions about it, and events sent to it, also across a lost connection.

const again_ms = 1000;

function requestOf(body) {
  if (body === undefined) return {};
  const is_bytes = body instanceof Blob;
  const headers = {'Content-Type': is_bytes ? 'application/octet-stream' : 'application/json'};
  return {method: 'POST', headers, body: is_bytes ? body : JSON.stringify(body)};
}
async function ask(path, body) {
  const response = await fetch(path, requestOf(body));
  const answer = await response.json().catch(() => null);
  if (response.ok) return answer;
  throw Object.assign(new Error(answer?.error?.message ?? `${path}: ${response.status}`), {status: response.status});
}

// A request made before this module was loaded.
let early = globalThis.continua_early?.get('/api/sessions');

/** The sessions there are, and what a new one can be made of. */
export async function fetchSessions() {
  const response = await (early ?? fetch('/api/sessions'));
  early = null;
  const answer = await response.json().catch(() => null);
  if (!response.ok) throw new Error(answer?.error?.message ?? 'This server has no live sessions.');
  return answer;
}

const keyOf = (id) => `recorder:${id}`;
const kept = {
  get(id) {
    try {
      return sessionStorage.getItem(keyOf(id));
    } catch {
      return null;
    }
  },
  set(id, secret) {
    try {
      sessionStorage.setItem(keyOf(id), secret);
    } catch {
      /* then a reloaded page only watches */
    }
  },
};

/** Begins a session that this page records into. @returns its state */
export async function startSession(options) {
  const secret = [...crypto.getRandomValues(new Uint32Array(4))].map((part) => part.toString(36)).join('');
  const state = await ask('/api/sessions', {clock: 'wall', recorder: secret, ...options});
  kept.set(state.id, secret);
  return state;
}

export class SessionClient {
  #waiting = []; // requests to be sent: {batch, make}: make() gives the events when they go
  #batch = 0;
  #names = Math.random().toString(36).slice(2); // of this page's batches: a page that was loaded again begins at 0 again
  #sending = null; // a sample on its way
  #flushing = false;
  #timer = 0;
  #told = () => {};

  constructor(id) {
    this.id = id;
    this.secret = kept.get(id);
  }
  /** `told({answered, lost, refused})`: an answer to events; the server cannot be reached; it refused them, and why. */
  listen(told) {
    this.#told = told;
  }
  get recording() {
    return this.secret !== null;
  }

  #path(view = '') {
    return `/api/sessions/${encodeURIComponent(this.id)}${view}`;
  }
  #own(view) {
    return `${this.#path(view)}?recorder=${encodeURIComponent(this.secret ?? '')}`;
  }

  state() {
    return ask(this.#path());
  }
  pause(paused) {
    return ask(this.#own('/pause'), {paused});
  }
  end() {
    return ask(this.#own('/end'), {});
  }
  /** A part of a recording of the human: {source, type, take, part, t}, and its bytes. */
  film(named, bytes) {
    return ask(`${this.#own('/media')}&${new URLSearchParams(named)}`, bytes);
  }
  save(name) {
    return ask(this.#path('/save'), {name});
  }
  /** For a page that is going away: nobody waits for the answer. The session waits a while for the page to come back. */
  leave() {
    navigator.sendBeacon(this.#own('/away'), JSON.stringify({gone: true}));
  }
  /** The page is back, if it had left. */
  comeBack() {
    return ask(this.#own('/away'), {gone: false});
  }
  /** The records after number `after`. */
  stream(after) {
    return new EventSource(
      `/api/live?session=${encodeURIComponent(this.id)}${after < 0 ? '' : `&after=${after}`}${this.recording ? `&recorder=${encodeURIComponent(this.secret)}` : ''}`,
    );
  }

  /**
   * Sends what `make()` gives, once what was sent before has arrived; made anew if it has to be sent again. The server takes
   * it once, though an answer be lost.
   */
  send(make) {
    this.#waiting.push({batch: ++this.#batch, make});
    this.flush();
  }
  /** The events that have yet to reach the server, as they would be sent now. */
  get unsent() {
    return this.#waiting.flatMap(({make}) => make());
  }
  /** One sample: worth sending only now. */
  sample(event) {
    if (this.#sending || this.#waiting.length) return;
    this.#sending = this.#post([event])
      .catch(() => {})
      .finally(() => {
        this.#sending = null;
      });
  }

  async flush() {
    clearTimeout(this.#timer);
    if (this.#flushing) return;
    this.#flushing = true;
    await this.#sending;
    while (this.#waiting.length) {
      try {
        const {batch, make} = this.#waiting[0];
        await this.#post(make(), `&batch=${this.#names}-${batch}`);
      } catch (problem) {
        // The server would refuse the same request again.
        if (problem.status === undefined) {
          this.#timer = setTimeout(() => this.flush(), again_ms);
          break;
        }
      }
      this.#waiting.shift();
    }
    this.#flushing = false;
  }

  async #post(events, named = '') {
    try {
      this.#told({answered: await ask(this.#own('/events') + named, events)});
    } catch (problem) {
      this.#told(problem.status === undefined ? {lost: true} : {refused: problem.message});
      throw problem;
    }
  }

  close() {
    clearTimeout(this.#timer);
    this.#waiting = [];
  }
}
