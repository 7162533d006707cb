// The form before a conversation: scene and machine, and the conversations of others.
import {h, clock, icon} from '../dom.js';

const speeds = [0.25, 0.5, 1, 2, 4];
const lead =
  'Type or say what the avatar should do, point with the mouse, and all of it is recorded as a trace that can be replayed, inspected and kept as a test.';

const labelled = (text, control) => h('label', {}, h('span', {}, text), control);
const choice = (name, values, chosen) =>
  h(
    'select',
    {name, 'data-testid': `live-${name}`},
    values.map((value) => h('option', {value, selected: value === chosen}, String(value).replaceAll('_', ' '))),
  );

/** A form that asks how the session is to be, and calls `start(options)`. */
function startForm({scenes, machines, scene, machine, after}, start) {
  const fields = {
    scene: choice('scene', scenes, scene),
    machine: choice('machine', machines, machine),
    physics: h('input', {type: 'checkbox', checked: true, 'data-testid': 'live-physics'}),
    speed: h(
      'select',
      {name: 'speed'},
      speeds.map((value) => h('option', {value, selected: value === 1}, `${value}×`)),
    ),
  };
  const button = h('button', {class: 'primary', 'data-testid': 'live-start'}, 'Start');
  const trouble = h('p', {class: 'trouble', role: 'alert', 'data-testid': 'live-trouble'});
  const form = h(
    'form',
    {class: 'live-form'},
    after && h('p', {'data-testid': 'live-after'}, `It goes on where ${after} ended.`),
    !after && [labelled('Scene', fields.scene), labelled('Machine', fields.machine)],
    labelled('Physics', fields.physics),
    h('details', {}, h('summary', {}, 'More'), labelled('Speed', fields.speed)),
    button,
    trouble,
  );
  form.addEventListener('submit', async (event) => {
    event.preventDefault();
    button.disabled = true;
    trouble.textContent = '';
    try {
      const [chosen_scene, chosen_machine] = [fields.scene.value, fields.machine.value];
      const [physics, speed] = [fields.physics.checked, Number(fields.speed.value)];
      await start(after ? {physics, speed} : {scene: chosen_scene, machine: chosen_machine, physics, speed});
    } catch (problem) {
      trouble.textContent = problem.message;
      button.disabled = false;
    }
  });
  return {form, button};
}

function sessionItem({id, run, live, paused, scene, machine, t}, start) {
  const href = live ? `/live/${encodeURIComponent(id)}` : `/r/${encodeURIComponent(run)}`;
  const facts = `${scene.replaceAll('_', ' ')}, ${machine}, ${clock(t)}${live && paused ? ', paused' : ''}`;
  const link = h('a', {href}, live ? 'Follow' : 'Inspect');
  const more = h('button', {type: 'button', class: 'link', 'aria-label': `Go on with ${id}`}, 'Go on');
  more.addEventListener('click', async () => {
    more.disabled = true;
    await start({after: id}).catch((problem) => more.replaceWith(h('span', {class: 'trouble'}, problem.message)));
  });
  return h('li', {}, link, ` ${id} `, h('span', {class: 'muted'}, facts), !live && [' ', more]);
}
const list = (title, sessions, start) =>
  sessions.length > 0 && [
    h('h2', {}, title),
    h(
      'ul',
      {class: 'sessions'},
      sessions.map((one) => sessionItem(one, start)),
    ),
  ];

/** `answer`: of fetchSessions(); `start(options)`: begins a session. */
export function mountStart(answer, start) {
  const {form, button} = startForm(answer, start);
  const logo = h('img', {src: icon(), alt: 'All runs', width: 28, height: 28});
  const live = answer.sessions.filter((one) => one.live);
  const ended = answer.sessions.filter((one) => !one.live);
  const main = h(
    'main',
    {class: 'start live-start'},
    h('h1', {}, h('a', {href: '/', title: 'All runs'}, logo), 'Talk to the avatar'),
    h('p', {class: 'lead'}, lead),
    form,
    list('Going on now', live, start),
    list('Ended', ended, start),
  );
  return {elements: [main], shown: () => button.focus()};
}
