// Notes on instants and stretches of the run, kept in a file beside it.
import {h, panel, clock} from '../dom.js';
import {served} from '../run/run_client.js';

let fresh_number = 0;

export function mountNotes(app) {
  const {client} = app;
  const list = h('ol', {class: 'notes-list'});
  const words = h('textarea', {rows: 2, 'aria-label': 'The note', 'data-testid': 'note-text', placeholder: 'What you noticed here',
    onkeydown: (event) => { if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) { event.preventDefault(); add(); } }});
  const where = h('span', {class: 'muted', 'data-testid': 'note-where'});
  const trouble = h('p', {class: 'trouble', role: 'alert', hidden: true});
  const form = h('div', {class: 'note-form', hidden: !served}, words, h('div', {class: 'note-buttons'}, where,
    h('button', {type: 'button', 'data-testid': 'note-from', title: 'The note is of the stretch from here to the cursor (Shift+M)', onclick: () => mark()}, 'From here'),
    h('button', {type: 'button', 'data-testid': 'note-add', onclick: () => add()}, 'Add note')));
  const element = panel('notes', 'Notes', null, h('div', {class: 'body', tabindex: 0, role: 'region', 'aria-label': 'Notes on this run'}, trouble, list, form));
  let notes = [], version = '', from = null, at = 0;

  const say = (problem) => { trouble.hidden = !problem; trouble.textContent = problem ?? ''; };
  const at_time = (n) => clock(app.data.t[app.data.clamp(n)]);
  const span = (note) => (note.to === null ? `#${note.n}, ${at_time(note.n)}` : `#${note.n} – #${note.to}, ${at_time(note.n)} – ${at_time(note.to)}`);
  const draw = () => {
    list.replaceChildren(...notes.map((note) => h('li', {'data-testid': 'note'},
      h('button', {type: 'button', class: 'link', onclick: () => app.jump(note.n)}, span(note)), h('p', {}, note.text),
      served && h('button', {type: 'button', class: 'remove', 'aria-label': `Remove the note at #${note.n}`, title: 'Remove', onclick: () => save(notes.filter((one) => one !== note))}, '✕'))));
    if (!notes.length) list.append(h('li', {class: 'empty'}, 'No notes yet.'));
    const t = (n) => app.data.t[app.data.clamp(n)];
    app.lanes?.showNotes(notes.map(({n, to}) => ({from: t(n), to: t(to ?? n)})));
  };
  const read = async () => {
    try {
      ({notes, version} = await client.notes());
      draw();
    } catch (problem) {
      say(problem.message);
    }
  };
  const save = async (wanted) => {
    try {
      const saved = await client.saveNotes({notes: wanted.toSorted((a, b) => a.n - b.n), version});
      ({notes, version} = saved);
      say(null);
      draw();
      return true;
    } catch (problem) {
      say(problem.status === 409 ? 'Somebody else has changed the notes: here they are; please say yours again.' : problem.message);
      if (problem.status === 409) await read();
      return false;
    }
  };
  const place = () => { where.textContent = from === null ? `on #${at}` : `on #${Math.min(from, at)} – #${Math.max(from, at)}`; };
  const mark = () => { from = from === null ? at : null; place(); };
  const add = async () => {
    const text = words.value.trim();
    if (!text) { words.focus(); return; }
    const id = `${Date.now().toString(36)}-${++fresh_number}`;
    const [n, to] = from === null ? [at, null] : [Math.min(from, at), Math.max(from, at)];
    if (!await save([...notes, {id, n, to, text}])) return;
    words.value = '';
    from = null;
    place();
  };
  draw();
  read();
  return {
    element, mark,
    write() { words.focus(); },
    render({n}) { at = n; place(); },
  };
}
