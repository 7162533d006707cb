// Run logs made for the tests of the page.

const edge = (id, from, to, input, condition, operation) => ({id, from, to, input, condition, operation});
const header = {
  version: 1,
  continua: 'test',
  trace: {name: 'three rounds'},
  seed: 0,
  choice: 'likeliest',
  machine: {name: 'asking', document: {}},
  graph: {
    states: ['Wait', 'AskWhichObject', 'Act', 'NeverSeen'].map((id) => ({id, accepting: id === 'Wait'})),
    start: 'Wait',
    edges: [
      edge('ask', 'Wait', 'AskWhichObject', 'P', 'size(options) > 1', 'push'),
      edge('next', 'AskWhichObject', 'AskWhichObject', 'n', null, 'pop'),
      edge('agree', 'AskWhichObject', 'Act', 'y', null, 'rewrite'),
      edge('done', 'Act', 'Wait', 'ε', null, 'flush'),
      edge('lost', 'Wait', 'NeverSeen', 'x', null, 'none'),
    ],
  },
  scene: {name: 'table', mjcf: '<mujoco/>'},
};
const step_fields = {
  operation: {none: null},
  weight: 1,
  probability: 1,
  draw: null,
  refused: [{id: 'lost', reason: 'the input is not x'}],
  gates: [],
  margin: null,
};
const on_block = '\\b. put(b, on(block1))';
const application = {
  function: '\\v. \\b. put(b, v)',
  argument: 'on(block1)',
  result: on_block,
  types: {function: 'loc -> e -> t', argument: 'loc', result: 'e -> t'},
  rule: null,
};
const program = 'put(block2, on(block1))';
const pose = {bodies: {hand: [0, 0, 0, 1, 0, 0, 0]}};

class Log {
  lines = [];

  /** @returns the record's number */
  add(kind, t, fields, cause) {
    const n = this.lines.length;
    this.lines.push(JSON.stringify({kind, n, t, ...(cause !== undefined && {cause}), ...fields}));
    return n;
  }
  step(t, cause, id, [from, to], fields) {
    return this.add('transition', t, {id, from, to, candidates: [{id, weight: 1}], ...step_fields, ...fields}, cause);
  }
}

// One round from t on; `id`: of the last symbol made before.
function addRound(log, round, t, id, outcome) {
  const speech = {kind: 'speech', text: `Put it there, ${round}.`, until: t + 1.5};
  const said = log.add('input', t, {line: 2, event: speech, symbol: 'P'});
  log.add('application', t, {...application, because: [said]}, said);
  log.add('symbol', t, {id: id + 1, below: 1, slots: {action: on_block, options: '[block2, block3]'}}, said);
  const asked = log.step(t, said, 'ask', ['Wait', 'AskWhichObject'], {input: 'P', stack: id + 1, depth: 2});
  log.add('utterance', t, {text: 'Which block?'}, asked);
  for (let i = 0; i < 300; ++i) log.add('pose', t + 1 + i / 100, pose);
  const gesture = {kind: 'gesture', name: 'yes', phase: 'stroke'};
  const yes = log.add('input', t + 5, {line: 3, event: gesture, symbol: 'y'});
  log.add('symbol', t + 5, {id: id + 2, below: 1, slots: {action: program}}, yes);
  const agreed = log.step(t + 5, yes, 'agree', ['AskWhichObject', 'Act'], {input: 'y', stack: id + 2, depth: 2});
  const act = log.add('act', t + 5, {act: round + 1, program, status: 'asked'}, agreed);
  log.add('act', t + 9, {act: round + 1, program, ...outcome}, act);
  log.step(t + 9, agreed, 'done', ['Act', 'Wait'], {input: null, stack: 1, depth: 1});
}

const done = {status: 'done', result: {position_error_m: 0.001}};
const blocked = {status: 'blocked', result: {reason: 'block1 is in the way'}};

const block = (name, color) => `<text name="${name}" data="type=block color=${color}"/>`;
const named = `<mujoco><custom>${block('block1', 'red')}${block('block2', 'green')}</custom></mujoco>`;
const unmet = [
  {expected: {act: program, says: 'Which block?'}, found: {act: 'grasp(block2)', says: 'Which block do you mean?'}},
  {expected: {state: 'Wait'}, found: {state: 'Act'}},
];

/**
 * A run of three rounds of asking and agreeing, with more records than a table can hold. `fails`: its last act does;
 * `worst`: all do, expectations are not met, and its blocks have colours.
 */
export function roundsLog({fails = false, worst = false} = {}) {
  const log = new Log();
  log.add('run', 0, worst ? {...header, scene: {name: 'table', mjcf: named}} : header);
  log.add('symbol', 0, {id: 1, below: null, slots: {}}, 0);
  for (let round = 0; round < 3; ++round)
    addRound(log, round, 5 + round * 20, 1 + 2 * round, worst || (fails && round === 2) ? blocked : done);
  if (worst) for (const one of unmet) log.add('expect', 60, {line: 9, met: false, ...one});
  const refused = [{id: 'ask', reason: 'the input is not P'}];
  log.add('refusal', 60, {state: 'Wait', input: 'z', reason: 'no transition takes z', refused});
  log.add('end', 61, {counts: {}, decisions: '', physics: '', digest: ''});
  return `${log.lines.join('\n')}\n`;
}
