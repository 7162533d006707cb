// Keeps a session as a test: asks for a name, and says how the test is run.
import {h} from '../dom.js';

const most_letters = 64;
/** Why a test cannot have this name, in a sentence with a name that it could have; '' if it can. */
export function faultOf(name) {
  if (/^[A-Za-z0-9_-]{1,64}$/.test(name)) return '';
  if (!name) return 'A test needs a name.';
  const better = name
    .replace(/[^A-Za-z0-9_-]+/g, '_')
    .replace(/^_+|_+$/g, '')
    .slice(0, most_letters);
  const found = [...new Set(name.match(/[^A-Za-z0-9_-]/gu) ?? [])].map((one) => (one === ' ' ? 'a space' : one));
  const sentence = found.length
    ? `The name becomes a file's: found ${found.join(' ')}; expected letters, digits, _ and - alone.`
    : `The name has ${name.length} letters; expected at most ${most_letters}.`;
  return better ? `${sentence} How about ${better}?` : sentence;
}

/** `copy()` tells whether it could. */
function copyButton(copy) {
  const onclick = async () => {
    button.textContent = (await copy()) ? 'Copied' : 'Select it, then copy';
  };
  const button = h('button', {type: 'button', onclick}, 'Copy');
  return button;
}

/** `save(name)`: gives the server's answer; `copy(text)`. */
export function saveDialog(save, copy) {
  const name = h('input', {
    type: 'text',
    'aria-label': 'Name of the test',
    placeholder: 'a name, e.g. plate_to_the_left',
    autocomplete: 'off',
    'data-testid': 'save-name',
  });
  const result = h('div', {class: 'saved', role: 'status', 'data-testid': 'saved'});
  const button = h('button', {class: 'primary', 'data-testid': 'save-do'}, 'Save');
  const copied = copyButton(() => copy(result.querySelector('code').textContent));

  async function keep(event) {
    event.preventDefault();
    const fault = faultOf(name.value.trim());
    if (fault) {
      result.replaceChildren(h('p', {class: 'trouble'}, fault));
      name.focus();
      return;
    }
    button.disabled = true;
    result.replaceChildren(
      h('p', {class: 'muted'}, 'The conversation is replayed, to see whether it holds as a test …'),
    );
    try {
      const {check, trace} = await save(name.value.trim());
      copied.textContent = 'Copy';
      result.replaceChildren(
        h('p', {}, `Saved as ${trace}. From now on the avatar is to decide as it did here; check that with`),
        h('p', {}, h('code', {}, check), ' ', copied),
      );
    } catch (problem) {
      result.replaceChildren(h('p', {class: 'trouble'}, problem.message));
    }
    button.disabled = false;
  }

  const element = h(
    'dialog',
    {class: 'dialog save', 'aria-label': 'Save as test', 'data-testid': 'save'},
    h('h2', {}, 'Save as test'),
    h('form', {class: 'save-form', onsubmit: keep}, name, button),
    result,
    h('form', {method: 'dialog'}, h('button', {}, 'Close')),
  );
  return {
    element,
    open() {
      result.replaceChildren();
      element.showModal();
      name.focus();
    },
  };
}
