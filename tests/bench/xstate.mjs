// Transitions per second of XState, as JSON: {"finite": …, "stack": …, "guarded": …}. Arguments: the folder of
// make_machines.py, the folder with node_modules.
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';

const [folder, packages] = process.argv.slice(2);
const {assign, createActor, createMachine} = createRequire(`${packages}/package.json`)('xstate');
const read = (name) => JSON.parse(readFileSync(`${folder}/${name}.json`));

const push = assign({stack: ({context}) => ({mark: 'm', below: context.stack})});
const pop = assign({stack: ({context}) => context.stack.below ?? context.stack});
const unmarked = ({context}) => context.stack.mark === null;

const machineOf = ({start, transitions}) => {
  const states = {};
  for (const {from, on, to, when, push: pushes, pop: pops} of transitions) {
    const transition = {target: to};
    if (when) transition.guard = unmarked;
    if (pushes) transition.actions = push;
    if (pops) transition.actions = pop;
    (states[from] ??= {on: {}}).on[on] = transition;
  }
  return createMachine({initial: start, context: {stack: {mark: null, below: null}}, states});
};

const word = read('word').map((type) => ({type}));
const perSecond = (machine) => {
  const run = () => {
    const actor = createActor(machine).start();
    for (const event of word) actor.send(event);
  };
  const during = (milliseconds) => {
    const begin = performance.now();
    let runs = 0;
    for (; performance.now() - begin < milliseconds; ++runs) run();
    return ((runs * word.length) / (performance.now() - begin)) * 1000;
  };
  during(500); // until the compiler has seen it
  return during(500);
};
console.log(
  JSON.stringify(
    Object.fromEntries(['finite', 'stack', 'guarded'].map((name) => [name, perSecond(machineOf(read(name)))])),
  ),
);
