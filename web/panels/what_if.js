// What if: another choice at a step, or another input; the run that follows is compared with this one.
import {dialog, h, instant, shown} from '../dom.js';
import {askWhatIf, served} from '../run/run_client.js';
import {placeText} from '../scene3d/scene_text.js';

const table_m = {x: 0.5, y: 0.3}; // from its middle to its edges
const about_s = 10; // earlier and later, that the slider of time reaches

// A question of the dialog: {field: its element, read()}, where read() gives the part of the request that the reader
// changed, {} if there is none, and throws a sentence about a part that cannot be used.

/** Another transition at a step, of a machine with this graph; null if the step had no choice. */
function choiceField(step, {edges}) {
  const outranked = (step?.refused ?? []).filter((one) => one.outranked_by);
  const others = [...(step?.candidates ?? []), ...outranked]
    .map((one) => one.id)
    .filter((id, i, all) => id !== step.id && all.indexOf(id) === i);
  if (!others.length) return null;
  const radio = (id, text, checked) =>
    h('label', {}, h('input', {type: 'radio', name: 'choice', value: id, checked}), ` ${text}`);
  const goesTo = (id) => {
    const to = new Set(
      edges.filter((edge) => edge.id === id && (edge.from === step.from || !edge.from)).map((edge) => edge.to),
    );
    return to.size === 1 ? ` → ${[...to][0]}` : '';
  };
  const field = h(
    'fieldset',
    {},
    h('legend', {}, `at step ${step.step} another transition had been taken`),
    radio('', `${step.id} → ${step.to}, as it was`, true),
    others.map((id) => radio(id, `${id}${goesTo(id)}`, false)),
  );
  const read = () => {
    const taken = field.querySelector('input:checked')?.value ?? '';
    return taken ? {force: {[step.step]: taken}} : {};
  };
  return {field, read};
}

/**
 * Another event in place of an input of a run that lasts `duration`, or at another time, or none; `target`: where the
 * human points instead, or null. Null for an input that is not the trace's.
 */
function inputField(record, duration, target_now) {
  if (!record || record.event?.kind === 'act') return null;
  const text = h('textarea', {
    rows: 5,
    spellcheck: 'false',
    'aria-label': 'The input as JSON',
    'data-testid': 'what-if-event',
  });
  text.value = JSON.stringify(record.event, null, 1);
  const words = wordsField(text);
  const target = targetField(text, target_now);
  const time = timeField(record.t, duration);
  const out = h('input', {type: 'checkbox', 'data-testid': 'what-if-out'});
  out.addEventListener('change', () => {
    text.disabled = out.checked;
    if (words) words.disabled = out.checked;
    if (target) target.disabled = out.checked;
    time.range.disabled = out.checked;
  });
  const field = h(
    'fieldset',
    {},
    h('legend', {}, `the input at #${record.n} had been another`),
    words && h('label', {class: 'words'}, 'the human says ', words),
    target,
    time.field,
    h('details', {open: !words && !target}, h('summary', {}, 'All of it, as JSON'), text),
    h('label', {}, out, ' it had not come at all'),
  );
  const read = () => {
    const event = out.checked ? null : parsed(text.value);
    const by = out.checked ? 0 : time.by();
    const changed = by !== 0 || JSON.stringify(event) !== JSON.stringify(record.event);
    if (!changed) return {};
    return {edits: [{n: record.n, event: event && shiftedBy(by, event), ...(by !== 0 && {t: record.t + by})}]};
  };
  return {field, read};
}

/** A field for the words alone, kept in step with the JSON of the event; null for an event without words. */
function wordsField(json) {
  const event = JSON.parse(json.value);
  if (typeof event.text !== 'string') return null;
  const words = h('input', {type: 'text', value: event.text, 'data-testid': 'what-if-words', autocomplete: 'off'});
  words.addEventListener('input', () => {
    json.value = JSON.stringify({...event, text: words.value}, null, 1);
  });
  return words;
}

/** A slider for the time of an input at `t` seconds: {field, range, by(): seconds later}. */
function timeField(t, duration) {
  const told = h('output', {'data-testid': 'what-if-when'}, instant(t));
  const reach = (seconds) => Math.floor(10 * Math.max(0, Math.min(seconds, about_s))) / 10;
  const range = h('input', {
    type: 'range',
    min: -reach(t),
    max: reach(duration - t),
    step: 0.1,
    value: 0,
    'aria-valuetext': instant(t),
    'data-testid': 'what-if-time',
  });
  const by = () => Math.round(10 * range.value) / 10;
  range.addEventListener('input', () => {
    const later = by();
    told.textContent =
      later === 0 ? instant(t) : `${instant(t + later)}, ${Math.abs(later)} s ${later < 0 ? 'earlier' : 'later'}`;
    range.setAttribute('aria-valuetext', told.textContent);
  });
  return {field: h('label', {class: 'time'}, 'it comes at ', range, ' ', told), range, by};
}

/** The event with its other times later, too. */
function shiftedBy(seconds, event) {
  const times = ['happened', 'until'].filter((key) => Number.isFinite(event[key]));
  return {...event, ...Object.fromEntries(times.map((key) => [key, event[key] + seconds]))};
}

/**
 * Sliders for the place that is pointed at, at `now` where it is not null, kept in step with the JSON of the event; null
 * for an event without one.
 */
function targetField(json, now) {
  const event = JSON.parse(json.value);
  if (!Array.isArray(event.target) || !event.target.every(Number.isFinite)) return null;
  const place = [...event.target];
  if (now) {
    [table_m.x, table_m.y].forEach((reach, i) => {
      place[i] = Math.max(-reach, Math.min(reach, now[i]));
    });
    json.value = JSON.stringify({...event, target: place}, null, 1);
  }
  const told = h('output', {'data-testid': 'what-if-place'}, placeText([...place, 0]));
  const slider = (axis, label, reach_m) => {
    const range = h('input', {
      type: 'range',
      min: -reach_m,
      max: reach_m,
      step: 0.01,
      value: place[axis],
      'aria-label': label,
      'data-testid': `what-if-${label.replaceAll(' ', '-')}`,
    });
    range.addEventListener('input', () => {
      place[axis] = Number(range.value);
      json.value = JSON.stringify({...JSON.parse(json.value), target: place}, null, 1);
      told.textContent = placeText([...place, 0]);
      range.setAttribute('aria-valuetext', told.textContent);
    });
    return h('label', {}, `${label} `, range);
  };
  const sliders = [slider(0, 'left to right', table_m.x), slider(1, 'near to far', table_m.y)];
  return h('fieldset', {class: 'target'}, h('legend', {}, 'the human points'), sliders, told);
}

function parsed(text) {
  try {
    return JSON.parse(text);
  } catch (problem) {
    throw new Error(`The input is no JSON: ${shown(problem.message)}`);
  }
}

/** Records of the last input that led to record n, and of the last step up to it; null for those that are not there. */
function recordsBehind({client, data}, n) {
  let input = n;
  while (input >= 0 && data.kind(input) !== 'input') input = data.cause(input);
  const place = data.step(n);
  const step = place < 0 ? -1 : data.steps.n[place];
  return Promise.all([input, step].map((one) => (one < 0 ? null : client.record(one))));
}

/** `id`, `client`: of the run that is shown, `cursor`: in that run. */
export function whatIfDialog({id, client, cursor, model}) {
  const body = h('div', {class: 'what-if-body'});
  const trouble = h('p', {class: 'trouble', role: 'alert', hidden: true});
  const run = h('button', {type: 'button', class: 'primary', 'data-testid': 'what-if-run', onclick: ask}, 'Run it');
  const element = dialog(
    {class: 'dialog what-if', 'aria-label': 'What if', 'data-testid': 'what-if'},
    h('h2', {}, 'What if …'),
    body,
    trouble,
    h('div', {class: 'dialog-buttons'}, h('button', {type: 'button', onclick: () => element.close()}, 'Close'), run),
  );
  let questions = [];
  body.addEventListener('keydown', (event) => {
    if (event.key === 'Enter' && event.target.matches('input[type=text]')) ask();
  });

  function say(problem) {
    trouble.hidden = !problem;
    trouble.textContent = problem ?? '';
  }
  async function ask() {
    try {
      const asked = Object.assign({}, ...questions.map(({read}) => read()));
      if (!Object.keys(asked).length) throw new Error('Change something first.');
      run.disabled = true;
      run.textContent = 'Running…';
      const answer = await askWhatIf({run: id, ...asked});
      element.close();
      model.open(id, answer.run);
    } catch (problem) {
      say(problem.message);
    }
    run.disabled = false;
    run.textContent = 'Run it';
  }
  return {
    element,
    /** Asks about record `n`; `target`: where the human points instead, or null. */
    async open({n = cursor.n, target = null} = {}) {
      if (!served) return;
      say(null);
      const {data} = cursor;
      const [input, step] = await recordsBehind({client, data}, n);
      questions = [target ? null : choiceField(step, data.graph), inputField(input, data.duration, target)].filter(
        Boolean,
      );
      body.replaceChildren(...questions.map(({field}) => field));
      run.hidden = !questions.length;
      if (!questions.length)
        body.append(
          h('p', {}, 'Nothing was chosen or said up to here. Go to an input, or to a transition that had a choice.'),
        );
      element.showModal();
    },
  };
}
