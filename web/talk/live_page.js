// The live page: a form that starts a conversation with the avatar, or the conversation itself.
import {h} from '../dom.js';
import {fetchSessions, SessionClient, startSession} from './session_client.js';
import {mountSession} from './session_page.js';
import {mountStart} from './start_form.js';

export class LivePage {
  shown = null;

  constructor(host, app) {
    this.host = host;
    this.app = app;
  }

  /** Shows what the address names; throws a sentence where there is no such thing. */
  async load() {
    const {live} = this.app.model.selection;
    document.title = 'Live – Continua';
    if (live) await this.#open(live);
    else this.#show(mountStart(await fetchSessions(), (options) => this.#start(options)));
  }

  async #start(options) {
    const {id} = await startSession(options);
    this.app.model.settle({live: id});
    await this.#open(id);
  }

  async #open(id) {
    const client = new SessionClient(id), state = await client.state();
    const page = mountSession(client, state, this.app);
    this.#show(page);
    await page.open();
  }

  #show(page) {
    this.shown?.close?.();
    this.shown = page;
    this.host.replaceChildren(...page.elements);
    page.shown?.();
  }

  /** Whether the key means something here; then it has been done. */
  onKey(key) {
    if (key === 't') this.app.toggleTheme(); else return this.shown?.onKey?.(key) ?? false;
    return true;
  }
  /** The colours may have changed. */
  render() { this.shown?.render?.(); }
  close() { this.shown?.close?.(); }
}
