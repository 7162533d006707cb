// The live page: a form that starts a conversation with the avatar, or the conversation itself.
import {fetchSessions, SessionClient, startSession} from './session_client.js';
import {mountSession} from './session_page.js';
import {mountStart} from './start_form.js';
import {toggleTheme} from '../theme.js';

export class LivePage {
  refusal = 'There is no conversation here';
  shown = null;
  #closed = false;

  constructor(host, model) {
    this.host = host;
    this.model = model;
  }

  /** Shows the page that the address names. Throws a sentence if there is no such session. */
  async load() {
    const {live} = this.model.selection;
    document.title = 'Live – Continua';
    if (live) await this.#open(live);
    else {
      const sessions = await fetchSessions();
      if (!this.#closed) this.#show(mountStart(sessions, (options) => this.#start(options)));
    }
  }

  async #start(options) {
    const {id} = await startSession(options);
    this.model.settle({live: id});
    await this.#open(id);
  }

  async #open(id) {
    const client = new SessionClient(id);
    const state = await client.state();
    if (this.#closed) return;
    const page = mountSession(client, state, () => this.#start({after: id, speed: state.speed}));
    this.#show(page);
    await page.open();
  }

  #show(page) {
    this.shown?.close?.();
    this.shown = page;
    this.host.replaceChildren(...page.elements);
    page.shown?.();
  }

  /** Does what the key means. @returns whether it means something here */
  onKey(key) {
    if (key === 't') toggleTheme();
    else return this.shown?.onKey?.(key) ?? false;
    return true;
  }
  /** The colours may have changed. */
  render() {
    this.shown?.render?.();
  }
  close() {
    this.#closed = true;
    this.shown?.close?.();
  }
}
