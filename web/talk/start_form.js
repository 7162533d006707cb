// Before there is a conversation: what to talk about and to whom, and the conversations of others.
import {h, clock, icon} from '../dom.js';

const speeds = [0.25, 0.5, 1, 2, 4];

/** `answer`: of fetchSessions(); `start(options)`: begins a session. */
export function mountStart({sessions, scenes, machines, scene, machine}, start) {
  const choice = (name, values, chosen) => h('select', {name, 'data-testid': `live-${name}`}, values.map((value) => h('option', {value, selected: value === chosen}, String(value).replaceAll('_', ' '))));
  const scene_choice = choice('scene', scenes, scene), machine_choice = choice('machine', machines, machine);
  const physics = h('input', {type: 'checkbox', checked: true, 'data-testid': 'live-physics'});
  const speed = h('select', {name: 'speed'}, speeds.map((value) => h('option', {value, selected: value === 1}, `${value}×`)));
  const button = h('button', {class: 'primary', 'data-testid': 'live-start'}, 'Start');
  const trouble = h('p', {class: 'trouble', role: 'alert', 'data-testid': 'live-trouble'});
  const labelled = (text, control) => h('label', {}, h('span', {}, text), control);

  async function begin(event) {
    event.preventDefault();
    button.disabled = true;
    trouble.textContent = '';
    try {
      await start({scene: scene_choice.value, machine: machine_choice.value, physics: physics.checked, speed: Number(speed.value)});
    } catch (problem) {
      trouble.textContent = problem.message;
      button.disabled = false;
    }
  }

  const line = (one) => h('li', {},
    h('a', {href: one.live ? `/live/${encodeURIComponent(one.id)}` : `/r/${encodeURIComponent(one.run)}`}, one.live ? 'Follow' : 'Inspect'), ` ${one.id} `,
    h('span', {class: 'muted'}, `${one.scene.replaceAll('_', ' ')}, ${one.machine}, ${clock(one.t)}${one.live && one.paused ? ', paused' : ''}`));
  const list = (title, some) => (some.length ? [h('h2', {}, title), h('ul', {class: 'sessions'}, some.map(line))] : []);

  const main = h('main', {class: 'start live-start'},
    h('h1', {}, h('a', {href: '/', title: 'All runs'}, h('img', {src: icon(), alt: 'All runs', width: 28, height: 28})), 'Talk to the avatar'),
    h('p', {class: 'lead'}, 'Type or say what the avatar should do, point with the mouse, and all of it is recorded as a trace that can be replayed, inspected and kept as a test.'),
    h('form', {class: 'live-form', onsubmit: begin},
      labelled('Scene', scene_choice), labelled('Machine', machine_choice), labelled('Physics', physics),
      h('details', {}, h('summary', {}, 'More'), labelled('Speed', speed)),
      button, trouble),
    list('Going on now', sessions.filter(({live}) => live)), list('Ended', sessions.filter(({live}) => !live)));
  return {elements: [main], shown: () => button.focus()};
}
