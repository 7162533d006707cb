// Files that are dropped on the start page, or chosen: handed to the server, which opens a run log and replays a trace.
import {h} from '../dom.js';
import {handOver} from '../run/run_client.js';

const hint = 'Open a run log or a trace: choose it, or drop it anywhere on this page. A trace is replayed.';

/**
 * {button, said, listen(host)}: `button` chooses a file, `said` tells how it goes; what is dropped on the host of
 * `listen` is opened. `open(run)` gets the id of the run.
 */
export function mountDrop(open) {
  const said = h('p', {class: 'drop-said', role: 'status', 'data-testid': 'drop-said', hidden: true});
  const field = h('input', {
    type: 'file',
    accept: '.jsonl,.gz',
    class: 'unseen',
    tabindex: -1,
    'aria-hidden': 'true',
    'data-testid': 'drop-file',
  });
  const button = h(
    'button',
    {type: 'button', title: hint, 'data-testid': 'open-file', onclick: () => field.click()},
    'Open a file',
  );
  const say = (sentence, is_bad = false) => {
    said.textContent = sentence;
    said.hidden = !sentence;
    said.classList.toggle('trouble', is_bad);
  };
  async function take(files) {
    if (files.length !== 1) return say('One file at a time, please.', true);
    const [file] = files;
    say(`${file.name} is handed over …`);
    try {
      const {run} = await handOver(file, () => say(`${file.name} is being opened; a trace is replayed …`));
      say('');
      open(run);
    } catch (problem) {
      say(`${file.name} cannot be opened: ${problem.message}`, true);
    }
  }
  field.addEventListener('change', () => {
    if (field.files.length) take(field.files);
    field.value = '';
  });

  const hasFiles = (event) => event.dataTransfer?.types.includes('Files');
  function listen(host) {
    host.append(field);
    let depth = 0; // of the elements that the pointer has entered and not left
    const show = (by) => {
      depth = by === 0 ? 0 : depth + by;
      host.classList.toggle('dropping', depth > 0);
    };
    host.addEventListener('dragenter', (event) => hasFiles(event) && show(1));
    host.addEventListener('dragleave', (event) => hasFiles(event) && show(-1));
    host.addEventListener('dragover', (event) => hasFiles(event) && event.preventDefault());
    host.addEventListener('drop', (event) => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      show(0);
      take([...event.dataTransfer.files]);
    });
  }
  return {button, said, listen};
}
