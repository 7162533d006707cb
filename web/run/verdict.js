// How a run went, as every page tells it.
import {counted, grouped} from '../dom.js';

/** The parts of a run's verdict that are bad, in words: unmet expectations, failed acts, problems. */
export function failuresOf(run) {
  const {
    expected = 0,
    met = 0,
    first_unmet,
    acts = 0,
    acts_done = 0,
    acts_failed = 0,
    first_failed,
    problems = 0,
  } = run;
  const parts = [];
  if (met < expected) {
    const difference = first_unmet?.text;
    parts.push(
      `${expected - met} of ${counted(expected, 'expectation')} not met${difference ? `: ${difference}` : ''}`,
    );
  }
  if (acts_failed) {
    const reason = first_failed?.reason || first_failed?.status;
    parts.push(`${acts_done} of ${counted(acts, 'act')} done${reason ? `: ${reason}` : ''}`);
  }
  if (problems) parts.push(counted(problems, 'problem'));
  return parts;
}

/** The verdict of a list: {kind, text}; `kind` is a class of the style, '' for a run that proves nothing. */
export function verdictOf(run) {
  if (run.error) return {kind: 'bad', text: 'unreadable'};
  if (run.pending) return {kind: '', text: 'being read'};
  if (run.live) return {kind: 'live', text: '● live'};
  const failures = failuresOf(run);
  if (failures.length) return {kind: 'bad', text: `✘ ${failures.map((part) => part.split(':')[0]).join(', ')}`};
  if (run.trouble || !run.complete) return {kind: 'warn', text: '! cut short'};
  if (run.expected) return {kind: 'good', text: '✔ as expected'};
  return {kind: '', text: 'complete'};
}

/** "97 utterances, 13 of 13 acts done, 943 inputs refused (799 of them pointing samples), 8:56", failures first. */
export function verdictLine(run) {
  const parts = failuresOf(run);
  const refused = counted(run.refusals, 'input');
  const samples = run.refused_samples ? ` (${grouped(run.refused_samples)} of them pointing samples)` : '';
  parts.push(counted(run.utterances, 'utterance'));
  const broken_off = (run.acts ?? 0) - (run.acts_done ?? 0) - (run.acts_failed ?? 0);
  if (!run.acts_failed && run.acts) parts.push(`${run.acts_done ?? 0} of ${counted(run.acts, 'act')} done`);
  if (broken_off > 0) parts.push(`${broken_off} broken off`);
  if (run.expected && run.met === run.expected) parts.push(`${counted(run.expected, 'expectation')} met`);
  if (run.as_observed)
    parts.push(`as recorded: ${run.as_observed.alike} of ${counted(run.as_observed.answers, 'answer')}`);
  parts.push(`${refused} refused${samples}`);
  return parts.join(', ');
}
