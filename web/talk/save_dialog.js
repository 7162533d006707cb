// Keeps a session as a test: asks for a name, and says how the test is run.
import {h} from '../dom.js';

/** `save(name)`: gives the server's answer; `copy(text)`. */
export function saveDialog(save, copy) {
  const name = h('input', {
    type: 'text',
    'aria-label': 'Name of the test',
    placeholder: 'a name, e.g. plate_to_the_left',
    pattern: '[A-Za-z0-9_\\-]+',
    required: true,
    autocomplete: 'off',
    'data-testid': 'save-name',
  });
  const result = h('div', {class: 'saved', role: 'status', 'data-testid': 'saved'});
  const button = h('button', {class: 'primary', 'data-testid': 'save-do'}, 'Save');
  const copied = h(
    'button',
    {
      type: 'button',
      onclick: async () => {
        copied.textContent = (await copy(result.querySelector('code').textContent)) ? 'Copied' : 'Select it, then copy';
      },
    },
    'Copy',
  );

  async function keep(event) {
    event.preventDefault();
    button.disabled = true;
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
