// The names of things in words that people use, with the log's own form on hover.
import {h, shown, text} from '../dom.js';

export class Words {
  #titles;

  /** `titles`: name of a thing -> its words, as the server tells them of a run. */
  constructor(titles) {
    this.#titles = titles ?? {};
  }

  /** The name in words; text where it has none. */
  thing(name) {
    const told = Object.hasOwn(this.#titles, name) ? this.#titles[name] : null;
    return told === null ? shown(text(name)) : h('span', {title: text(name)}, told);
  }
  /** The same of one or several, with commas. */
  things(names) {
    return [names].flat().map((name, i) => [i > 0 && ', ', this.thing(name)]);
  }
  /**
   * A thing that was ruled out, as an item of a list. `told`, `why`: the server's words for it and for the reason; where
   * there are none, the log's own stand.
   */
  ruledOut({object, reason, told, why}, between = ' ') {
    const thing = told === undefined ? this.thing(object) : h('span', {title: text(object)}, shown(told));
    const title = why === undefined || why === reason ? null : shown(reason);
    return h('li', {title}, h('b', {}, thing), between, shown(why ?? reason));
  }
}
