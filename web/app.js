// The application: one page at a time, the one that the address names.
import {h} from './dom.js';
import {Cursor} from './cursor.js';
import {onKey} from './keys.js';
import {linkTo, Model} from './model.js';
import {onTheme} from './theme.js';
import {RunPage} from './run_page.js';
import {StartPage} from './panels/start.js';
import {LivePage} from './talk/live_page.js';

/** What is shown at an address that no page has. */
class NoPage {
  refusal = 'There is no such page';
  constructor(path) {
    this.path = path;
  }
  load() {
    throw new Error(`There is nothing at ${this.path}.`);
  }
  render() {}
  onKey = () => false;
  close() {}
}

/** Whether two selections belong to different pages. */
const elsewhere = (a, b) => a.run !== b.run || a.other !== b.other || a.live !== b.live || a.nowhere !== b.nowhere;

/**
 * A page has `load()`, which throws a sentence if it cannot be shown, and `refusal`, the heading of that sentence;
 * `render()` after a change of the selection or the colours; `onKey(key, shift)`, true if the key meant something;
 * `settled()`, and `close()`.
 */
export class App {
  constructor(host) {
    this.host = host;
    this.page = null;
    this.model = new Model((before) => this.#changed(before));
    this.cursor = new Cursor(this.model, () => this.page.render());
    document.addEventListener('keydown', (event) => onKey(this.page, event));
    host.addEventListener('enlarge', (event) => this.model.enlarge(event.detail));
    onTheme(() => this.page.render());
    this.open();
  }

  /** Opens the page that the address names. The body has `data-ready` when all of it is there. */
  async open() {
    delete document.body.dataset.ready;
    this.page?.close();
    this.host.replaceChildren(h('p', {class: 'loading'}, 'Loading…'));
    const page = (this.page = this.#pageOf(this.model.selection));
    try {
      await page.load();
    } catch (problem) {
      if (this.page === page) this.#refuse(page.refusal, problem);
    }
    if (this.page !== page) return;
    await page.settled?.();
    performance.mark('settled');
    document.body.dataset.ready = '';
  }

  #pageOf({run, live, nowhere}) {
    if (nowhere) return new NoPage(nowhere);
    if (live !== undefined) return new LivePage(this.host, this.model);
    if (run === null) return new StartPage(this.host, this.model);
    return new RunPage(this.host, this.model, this.cursor);
  }

  #refuse(heading, problem) {
    this.host.replaceChildren(
      h(
        'main',
        {class: 'start'},
        h('h1', {}, heading),
        h('p', {class: 'trouble', 'data-testid': 'problem'}, problem.message),
        h('p', {}, h('a', {href: linkTo('/')}, 'All runs')),
      ),
    );
  }

  #changed(before) {
    if (elsewhere(before, this.model.selection)) this.open();
    else this.page.render();
  }
}
