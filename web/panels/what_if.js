// What if: another choice at a step, or an input as it was not; the run that follows is compared with this one.
import {h, shown} from '../dom.js';
import {askWhatIf, served} from '../run/run_client.js';

export function whatIfDialog(app) {
  const body = h('div', {class: 'what-if-body'});
  const trouble = h('p', {class: 'trouble', role: 'alert', hidden: true});
  const run = h('button', {type: 'button', class: 'primary', 'data-testid': 'what-if-run', onclick: () => ask()}, 'Run it');
  const element = h('dialog', {class: 'dialog what-if', 'aria-label': 'What if', 'data-testid': 'what-if', onclick: (event) => { if (event.target === element) element.close(); }},
    h('h2', {}, 'What if …'), body, trouble, h('div', {class: 'dialog-buttons'}, h('button', {type: 'button', onclick: () => element.close()}, 'Close'), run));
  let question = () => null;

  const say = (problem) => { trouble.hidden = !problem; trouble.textContent = problem ?? ''; };
  const back = (n, kind) => {
    while (n >= 0 && app.data.kind(n) !== kind) n = app.data.cause(n);
    return n;
  };
  const choiceField = (step) => {
    const others = (step?.candidates ?? []).map((one) => one.id).filter((id, i, all) => id !== step.id && all.indexOf(id) === i);
    if (!others.length) return null;
    const radio = (id, text, checked) => h('label', {}, h('input', {type: 'radio', name: 'choice', value: id, checked}), ` ${text}`);
    return h('fieldset', {}, h('legend', {}, `at step ${step.step} another transition had been taken`),
      radio('', `${step.id}, as it was`, true), others.map((id) => radio(id, id, false)));
  };
  const inputField = (record) => {
    const text = h('textarea', {rows: 5, spellcheck: 'false', 'aria-label': 'The input as JSON', 'data-testid': 'what-if-event'});
    text.value = JSON.stringify(record.event, null, 1);
    const out = h('input', {type: 'checkbox', 'data-testid': 'what-if-out', onchange: () => { text.disabled = out.checked; }});
    return h('fieldset', {}, h('legend', {}, `the input at #${record.n} had been another`), text, h('label', {}, out, ' it had not come at all'));
  };

  /** The last of each of the kinds up to n, and by what it was brought about. */
  const records = async (n) => {
    const input = back(n, 'input');
    const place = app.data.step(n), step = place < 0 ? -1 : app.data.steps.n[place];
    return Promise.all([input, step].map((one) => (one < 0 ? null : app.client.record(one))));
  };
  const ask = async () => {
    const asked = question();
    if (!asked) return;
    run.disabled = true;
    run.textContent = 'Running…';
    try {
      const answer = await askWhatIf({run: app.id, ...asked});
      element.close();
      app.openRun(app.id, answer.run);
    } catch (problem) {
      say(problem.message);
    }
    run.disabled = false;
    run.textContent = 'Run it';
  };
  return {
    element,
    async open() {
      if (!served) return;
      say(null);
      const [input, step] = await records(app.model.selection.n);
      const of_trace = input && input.event?.kind !== 'act' ? input : null;
      const choice = choiceField(step), edit = of_trace && inputField(of_trace);
      body.replaceChildren(...[choice, edit].filter(Boolean));
      run.hidden = !choice && !edit;
      if (!choice && !edit) body.append(h('p', {}, 'Nothing was chosen or said up to here. Go to an input, or to a transition that had a choice.'));
      question = () => {
        const taken = choice?.querySelector('input:checked')?.value ?? '';
        const asked = {};
        if (taken) asked.force = {[step.step]: taken};
        if (edit?.querySelector('[type=checkbox]').checked) asked.edits = [{n: of_trace.n, event: null}];
        else if (edit) {
          let event;
          try { event = JSON.parse(edit.querySelector('textarea').value); } catch (problem) { say(`The input is no JSON: ${shown(problem.message)}`); return null; }
          if (JSON.stringify(event) !== JSON.stringify(of_trace.event)) asked.edits = [{n: of_trace.n, event}];
        }
        if (!asked.force && !asked.edits) { say('Change something first.'); return null; }
        return asked;
      };
      element.showModal();
    },
  };
}
