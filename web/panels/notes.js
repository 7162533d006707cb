// Notes on instants and stretches of the run, kept in a file in the run's folder.
import {h, panel, clock} from '../dom.js';
import {served} from '../run/run_client.js';

const conflict = 409; // somebody else has saved notes since these were read
let fresh_number = 0;

class Notes {
  #client;
  #cursor;
  #marked;
  #list = h('ol', {class: 'notes-list'});
  #trouble = h('p', {class: 'trouble', role: 'alert', hidden: true});
  #where = h('span', {class: 'muted', 'data-testid': 'note-where'});
  #words = h('textarea', {
    rows: 2,
    'aria-label': 'The note',
    'data-testid': 'note-text',
    placeholder: 'What you noticed here',
  });
  #notes = []; // {id, n, to, text}; to null: on an instant
  #version = '';
  #from = null; // the record at which a stretch begins
  #at = 0;

  /** `marked(spans)`: takes the stretches with notes, {from, to} in seconds. */
  constructor({client, cursor, marked}) {
    this.#client = client;
    this.#cursor = cursor;
    this.#marked = marked;
    const body = h('div', {class: 'body', tabindex: 0, role: 'region', 'aria-label': 'Notes on this run'});
    body.append(this.#trouble, this.#list, this.#form());
    this.element = panel('notes', 'Notes', null, body);
    this.#draw();
    this.#read();
  }

  #form() {
    this.#words.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' || !(event.ctrlKey || event.metaKey)) return;
      event.preventDefault();
      this.#add();
    });
    const title = 'The note is of the stretch from here to the cursor (Shift+M)';
    const from = h('button', {type: 'button', 'data-testid': 'note-from', title}, 'From here');
    from.addEventListener('click', () => this.mark());
    const add = h('button', {type: 'button', 'data-testid': 'note-add', onclick: () => this.#add()}, 'Add note');
    const buttons = h('div', {class: 'note-buttons'}, this.#where, from, add);
    return h('div', {class: 'note-form', hidden: !served}, this.#words, buttons);
  }

  #say(problem) {
    this.#trouble.hidden = !problem;
    this.#trouble.textContent = problem ?? '';
  }
  #timeOf(n) {
    const {data} = this.#cursor;
    return data.t[data.clamp(n)];
  }

  #draw() {
    this.#list.replaceChildren(...this.#notes.map((note) => this.#item(note)));
    if (!this.#notes.length) this.#list.append(h('li', {class: 'empty'}, 'No notes yet.'));
    this.#marked(this.#notes.map(({n, to}) => ({from: this.#timeOf(n), to: this.#timeOf(to ?? n)})));
  }
  #item(note) {
    const {n, to, text} = note;
    const at = (record) => clock(this.#timeOf(record));
    const place = to === null ? `#${n}, ${at(n)}` : `#${n} – #${to}, ${at(n)} – ${at(to)}`;
    const label = `Remove the note at #${n}`;
    const remove = h('button', {type: 'button', class: 'remove', 'aria-label': label, title: 'Remove'}, '✕');
    remove.addEventListener('click', () => this.#save(this.#notes.filter((one) => one !== note)));
    return h(
      'li',
      {'data-testid': 'note'},
      h('button', {type: 'button', class: 'link', onclick: () => this.#cursor.jump(n)}, place),
      h('p', {}, text),
      served && remove,
    );
  }

  async #read() {
    try {
      ({notes: this.#notes, version: this.#version} = await this.#client.notes());
      this.#draw();
    } catch (problem) {
      this.#say(problem.message);
    }
  }
  /** @returns {Promise<boolean>} whether the notes were saved */
  async #save(wanted) {
    try {
      const notes = wanted.toSorted((a, b) => a.n - b.n);
      const saved = await this.#client.saveNotes({notes, version: this.#version});
      ({notes: this.#notes, version: this.#version} = saved);
      this.#say(null);
      this.#draw();
      return true;
    } catch (problem) {
      const clash = problem.status === conflict;
      this.#say(
        clash ? 'Somebody else has changed the notes: here they are; please say yours again.' : problem.message,
      );
      if (clash) await this.#read();
      return false;
    }
  }

  async #add() {
    const text = this.#words.value.trim();
    if (!text) {
      this.write();
      return;
    }
    const id = `${Date.now().toString(36)}-${++fresh_number}`;
    const [n, last] = this.#stretch();
    const to = this.#from === null ? null : last;
    if (!(await this.#save([...this.#notes, {id, n, to, text}]))) return;
    this.#words.value = '';
    this.#from = null;
    this.#showPlace();
  }
  // First and last record of the stretch that the next note is on.
  #stretch() {
    const from = this.#from ?? this.#at;
    return [Math.min(from, this.#at), Math.max(from, this.#at)];
  }
  #showPlace() {
    const [first, last] = this.#stretch();
    this.#where.textContent = this.#from === null ? `on #${first}` : `on #${first} – #${last}`;
  }

  /** The next note is on the stretch from here to the cursor; called again, on the cursor alone. */
  /** A stretch begins at this record; without one, where the cursor is, or no longer. */
  mark(from = null) {
    this.#from = from ?? (this.#from === null ? this.#at : null);
    this.#showPlace();
  }
  write() {
    this.#words.focus();
  }
  render({n}) {
    this.#at = n;
    this.#showPlace();
  }
}

export const mountNotes = (needs) => new Notes(needs);
