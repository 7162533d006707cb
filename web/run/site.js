// Stands in for the server in a site of exported runs: its answers are files, loaded when they are first asked for. A
// page from a disk may load scripts alone, so each file is one that hands over its name and its packed text.
import {h} from '../dom.js';
import {Recorded} from './recorded.js';

const document_mark = /\x01(\d+)\x01/g; // stands for the document of this number

export class Site {
  #answersIn;
  #unpacked;
  #files = new Map(); // name -> a promise of its text
  #waiting = new Map(); // name of a file that is being loaded -> what its packed text goes to
  #runs = new Map(); // id -> a promise of what was recorded of it

  constructor({answersIn, unpacked}) {
    this.#answersIn = answersIn;
    this.#unpacked = unpacked;
    globalThis.continua_arrived = (name, packed) => this.#waiting.get(name)?.(packed);
  }

  /** As fetch() would answer a request for this path. */
  async answer(path) {
    const {pathname, searchParams: query} = new URL(path, 'http://localhost');
    const id = /^\/api\/runs\/([^/]+)/.exec(pathname)?.[1];
    try {
      if (id) return await (await this.#run(decodeURIComponent(id))).answer(path);
      const name = pathname === '/api/diff' ? `diffs/${query.get('a')}/${query.get('b')}` : pathname.slice(5);
      const text = await this.#file(name);
      return {ok: true, status: 200, json: async () => JSON.parse(text)};
    } catch (problem) {
      return {ok: false, status: 404, json: async () => ({error: {message: problem.message}})};
    }
  }

  #run(id) {
    return kept(this.#runs, id, async () => {
      const text = await this.#file(`runs/${id}`);
      const numbers = [...new Set([...text.matchAll(document_mark)].map(([, number]) => number))];
      const documents = new Map(
        await Promise.all(numbers.map(async (number) => [number, await this.#file(`documents/${number}`)])),
      );
      const whole = text.replace(document_mark, (_, number) => documents.get(number));
      return new Recorded({answers: this.#answersIn(whole)});
    });
  }

  #file(name) {
    return kept(this.#files, name, () =>
      new Promise((arrived, failed) => {
        this.#waiting.set(name, arrived);
        const src = `${name.split('/').map(encodeURIComponent).join('/')}.js`;
        const onerror = () => failed(new Error(`This site has no ${name}.`));
        document.head.append(h('script', {src, onerror}));
      }).then((packed) => this.#unpacked(packed)),
    );
  }
}

function kept(all, key, make) {
  if (!all.has(key)) all.set(key, make());
  return all.get(key);
}
