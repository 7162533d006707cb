// Run logs made for the tests of the page.

/** A run of three rounds of asking and agreeing, with more records than a table can hold. */
export function roundsLog() {
  const lines = [];
  const add = (kind, t, fields, cause) => {
    lines.push(JSON.stringify({kind, n: lines.length, t, ...(cause === undefined ? {} : {cause}), ...fields}));
    return lines.length - 1;
  };
  const edge = (id, from, to, input, condition, operation) => ({id, from, to, input, condition, operation});
  add('run', 0, {version: 1, continua: 'test', trace: {name: 'three rounds'}, seed: 0, choice: 'likeliest', machine: {name: 'asking', document: {}},
    graph: {states: ['Wait', 'AskWhichObject', 'Act', 'NeverSeen'].map((id) => ({id, accepting: id === 'Wait'})), start: 'Wait', edges: [
      edge('ask', 'Wait', 'AskWhichObject', 'P', 'size(options) > 1', 'push'), edge('next', 'AskWhichObject', 'AskWhichObject', 'n', null, 'pop'),
      edge('agree', 'AskWhichObject', 'Act', 'y', null, 'rewrite'), edge('done', 'Act', 'Wait', 'ε', null, 'flush'), edge('lost', 'Wait', 'NeverSeen', 'x', null, 'none')]},
    scene: {name: 'table', mjcf: '<mujoco/>'}});
  let id = 1;
  add('symbol', 0, {id, below: null, slots: {}}, 0);
  const step = (t, cause, name, from, to, input, stack, depth) => add('transition', t, {id: name, from, to, input, operation: {none: null}, weight: 1,
    probability: 1, draw: null, candidates: [{id: name, weight: 1}], refused: [{id: 'lost', reason: 'the input is not x'}], gates: [], stack, depth, margin: null}, cause);
  for (let round = 0; round < 3; ++round) {
    const t = 5 + round * 20;
    const said = add('input', t, {line: 2, event: {kind: 'speech', text: `Put it there, ${round}.`, until: t + 1.5}, symbol: 'P'});
    add('application', t, {function: '\\v. \\b. put(b, v)', argument: 'on(block1)', result: '\\b. put(b, on(block1))',
      types: {function: 'loc -> e -> t', argument: 'loc', result: 'e -> t'}, rule: null, because: [said]}, said);
    add('symbol', t, {id: id + 1, below: 1, slots: {action: '\\b. put(b, on(block1))', options: '[block2, block3]'}}, said);
    const asked = step(t, said, 'ask', 'Wait', 'AskWhichObject', 'P', id + 1, 2);
    add('utterance', t, {text: 'Which block?'}, asked);
    for (let i = 0; i < 300; ++i) add('pose', t + 1 + i / 100, {bodies: {hand: [0, 0, 0, 1, 0, 0, 0]}});
    const yes = add('input', t + 5, {line: 3, event: {kind: 'gesture', name: 'yes', phase: 'stroke'}, symbol: 'y'});
    add('symbol', t + 5, {id: id + 2, below: 1, slots: {action: 'put(block2, on(block1))'}}, yes);
    const agreed = step(t + 5, yes, 'agree', 'AskWhichObject', 'Act', 'y', id + 2, 2);
    const act = add('act', t + 5, {act: round + 1, program: 'put(block2, on(block1))', status: 'asked'}, agreed);
    add('act', t + 9, {act: round + 1, program: 'put(block2, on(block1))', status: 'done', result: {position_error_m: 0.001}}, act);
    step(t + 9, agreed, 'done', 'Act', 'Wait', null, 1, 1);
    id += 2;
  }
  add('refusal', 60, {state: 'Wait', input: 'z', reason: 'no transition takes z', refused: [{id: 'ask', reason: 'the input is not P'}]});
  add('end', 61, {counts: {}, decisions: '', physics: '', digest: ''});
  return `${lines.join('\n')}\n`;
}
