// The conversation as it goes on: the human's moves, the avatar's words, gestures and acts, the newest at the bottom.
import {h, brief, clock} from '../dom.js';
import {RecordClient} from '../run/run_client.js';
import {Labels} from '../run/labels.js';
import {placeText} from '../scene3d/scene_text.js';

const most_lines = 300;
const at_end_px = 40;
const phases = {start: ', begins', stop: ', ends'};
const act_words = {
  asked: 'asked',
  started: 'doing …',
  done: '✔ done',
  missed: '✘ missed',
  dropped: '✘ dropped',
  blocked: '✘ in the way',
  unreachable: '✘ out of reach',
  unstable: '✘ did not stay',
  stopped: '✘ given up',
};

const gestureName = ({name, alternatives, direction}) =>
  [name ?? alternatives?.[0]?.text ?? 'a gesture', direction].filter(Boolean).join(' ').replaceAll('_', ' ');
const gestureEnd = ({phase, target}) => (phases[phase] ?? '') + (target ? `, ${placeText(target)}` : '');

/**
 * The line of a record: {who, how, text, end: what follows the text, raw: the text is a term or an id, for which there
 * may be words}, or null for a record without a line. Pure. `sample`: it came of a pointing sample.
 */
export function lineOf(record, sample = false) {
  const {event} = record;
  switch (record.kind) {
    case 'input':
      if (event?.kind === 'speech' && event.final === false)
        return {who: 'human', how: 'is saying', text: `${event.text} …`, passing: true};
      if (event?.kind === 'speech')
        return {who: 'human', how: 'says', text: event.text ?? event.alternatives?.[0]?.text ?? ''};
      return event?.kind === 'gesture'
        ? {who: 'human', how: 'shows', text: gestureName(event), end: gestureEnd(event), raw: true}
        : null;
    case 'utterance':
      return {who: 'avatar', how: 'says', text: record.text};
    case 'gesture':
      return {who: 'avatar', how: 'shows', text: brief(record.gesture), raw: true};
    case 'act':
      return record.step === undefined && record.status === 'asked'
        ? {who: 'avatar', how: 'does', text: brief(record.program), raw: true}
        : null;
    case 'learned':
      return {
        who: 'log',
        how: 'learned',
        text: `learned: ${record.name.replaceAll('_', ' ')} means ${brief(record.value)}`,
      };
    case 'refusal':
      return sample
        ? null
        : {
            who: 'log',
            how: 'refused',
            text: `not understood: ${/^no transition from/.test(record.reason) ? `nothing in ${record.state} takes “${record.input}”` : brief(record.reason)}`,
          };
    case 'problem':
      return {who: 'log', how: 'refused', text: `a problem: ${brief(record.message)}`};
    default:
      return null;
  }
}

// Keeps the line of words that are not final until others come.
function onePassing() {
  let passing = null;
  return (line) => {
    passing?.remove();
    passing = line;
  };
}

// A link to record n in the inspector; `raw`: the term that its parts tell in words, or false.
const inspected = (run, n, raw, ...parts) =>
  h(
    'a',
    {
      href: `/r/${encodeURIComponent(run)}?n=${n}`,
      target: '_blank',
      title: `#${n}${raw ? `, ${raw}` : ''}: look at it in the inspector`,
    },
    parts,
  );

// {term(n, element), reason(n, element)}: tells the term of record n, or why its act went otherwise, in words in the
// element, as soon as they are known.
function wordsOf(run) {
  const untold = new Map(); // record -> {element, what: of its label}
  const labels = new Labels(new RecordClient(run), () => {
    for (const [n, {element, what}] of untold) {
      const words = labels[what](n);
      if (!words) continue;
      element.textContent = words;
      untold.delete(n);
    }
  });
  const teller = (what) => (n, element) => {
    untold.set(n, {element, what});
    labels.want([n]);
  };
  return {term: teller('text'), reason: teller('reason')};
}

// How an act goes, in the element, and why it went otherwise.
function tellEnd({n, status, result}, element, inWords) {
  element.className = `status ${status}`;
  element.replaceChildren(act_words[status] ?? status);
  if (!result?.reason) return;
  const reason = h('span', {title: result.reason}, brief(result.reason));
  element.append(': ', reason);
  inWords.reason(n, reason);
}

// Keeps the latest line in sight, also in larger type or a smaller list, while nobody looks further up.
function endInSight(list) {
  let at_end = true;
  const toEnd = () => {
    if (at_end) list.scrollTop = list.scrollHeight;
  };
  list.addEventListener('scroll', () => {
    at_end = list.scrollHeight - list.scrollTop - list.clientHeight < at_end_px;
  });
  const sizes = new ResizeObserver(toEnd);
  sizes.observe(list);
  return () => {
    sizes.observe(list.lastChild);
    toEnd();
  };
}

/** `run`: whose records the lines lead to. */
export function mountConversation(run) {
  const list = h('ol', {class: 'moves', tabindex: 0, 'aria-label': 'Conversation', 'data-testid': 'conversation'});
  const element = h(
    'div',
    {class: 'conversation', role: 'log', 'aria-live': 'polite', 'aria-label': 'What was said and done'},
    list,
  );
  const lineAdded = endInSight(list);
  const inputs = new Map();
  const acts = new Map(); // record -> its input's event; act -> the line with its status

  const inWords = wordsOf(run);
  const keepPassing = onePassing();

  function add(record, {who, how, text, end, raw, passing: passes}) {
    const status = how === 'does' && h('span', {class: 'status asked'}, act_words.asked);
    if (status) acts.set(record.act, status);
    const words = h('span', {class: 'words'}, how === 'says' ? `“${text}”` : text);
    if (raw) inWords.term(record.n, words);
    list.append(
      h(
        'li',
        {class: `${who} ${how}`, 'data-who': who, 'data-how': how},
        h(
          'div',
          {class: 'parts'},
          h('span', {class: 'unseen'}, who === 'log' ? '' : `${who} ${how} `),
          inspected(run, record.n, raw && text, words, end, status),
        ),
        h('time', {}, clock(record.t)),
      ),
    );
    if (who === 'human' && how !== 'shows') keepPassing(passes ? list.lastChild : null);
    if (list.childElementCount > most_lines) list.firstChild.remove();
    lineAdded();
  }

  return {
    element,
    list,
    take(record) {
      // A percept and a reading lead back to the input that they are of.
      const event = record.kind === 'input' ? record.event : inputs.get(record.cause);
      if (event && ['input', 'percept', 'reading'].includes(record.kind)) inputs.set(record.n, event);
      if (record.kind === 'act' && record.step === undefined) {
        const status = acts.get(record.act);
        if (status) tellEnd(record, status, inWords);
      }
      const line = lineOf(record, event?.kind === 'pointing');
      if (line) add(record, line);
      return line;
    },
  };
}
