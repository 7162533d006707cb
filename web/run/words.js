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
  /** A thing that was ruled out, as an item of a list: “not white(cup)” is told of the cup as “not white”. */
  ruledOut({object, reason}, between = ' ') {
    const told = shown(reason);
    const of_it = `(${text(object)})`;
    const alone = told.endsWith(of_it) && told.indexOf('(') === told.length - of_it.length;
    const words = alone ? told.slice(0, -of_it.length).replaceAll('_', ' ') : told;
    return h('li', {title: words === told ? null : told}, h('b', {}, this.thing(object)), between, words);
  }
}
