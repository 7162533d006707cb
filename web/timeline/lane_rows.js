// The lanes of a run: their items, and the search for those in sight.
import {brief} from '../dom.js';
import {lastAtMost} from '../search.js';

/**
 * The lanes of a run from top to bottom: {name, colour, kind, lane: {n, from, to}, text(i), reach}. `reach[i]` is the
 * latest end among the first items up to i, so that those in sight can be searched for.
 */
export function laneRows(data) {
  const {lanes} = data;
  const row = (name, colour, lane, text, more = {}) => ({
    name,
    colour,
    kind: 'bar',
    lane,
    text,
    reach: reachOf(lane),
    ...more,
  });
  const words = (lane) => (i) => brief(data.text(lane.n[i]));
  const all = [
    row('human says', 'human', lanes.speech, (i) => brief(data.said(lanes.speech.n[i]))),
    row('shows', 'human', lanes.gesture, words(lanes.gesture)),
    row('points', 'human', lanes.pointing, (i) => `${lanes.pointing.count?.[i] ?? ''} samples`, {plain: true}),
    row('looks', 'human', lanes.gaze, words(lanes.gaze), {optional: true}),
    row('confidence', 'human', lanes.confidence, (i) => lanes.confidence.value[i].toFixed(2), {
      kind: 'level',
      value: (i) => lanes.confidence.value[i],
      most: 1,
      optional: true,
    }),
    row('state', 'state', lanes.state, (i) => stateName(data, i), {kind: 'state'}),
    row('stack depth', 'depth', lanes.depth, (i) => `${lanes.depth.value[i]}`, {
      kind: 'level',
      value: (i) => lanes.depth.value[i],
      most: most(lanes.depth.value),
    }),
    row('branches', 'depth', lanes.branches, (i) => `${lanes.branches.count[i]} branches`, {
      kind: 'level',
      value: (i) => lanes.branches.count[i],
      most: most(lanes.branches.count),
      optional: true,
    }),
    row('avatar says', 'avatar', lanes.utterance, words(lanes.utterance)),
    row('shows', 'avatar', lanes.move, words(lanes.move)),
    row('acts', 'act', lanes.act, (i) => `${brief(data.text(lanes.act.n[i]))} ${statusOf(data, i)}`, {
      bad: (i) => statusOf(data, i) !== 'done',
    }),
    ...data.media.flatMap((one, i) => soundRow(one, i, data)),
    row('as recorded', 'depth', lanes.observed, words(lanes.observed), {
      optional: true,
      bad: (i) => data.misses.has(lanes.observed.n[i]),
    }),
  ];
  return all.filter((one) => !one.optional || one.lane.n.length);
}

// The waveform of a recording: what the page learns of it later is put into `sound`.
const nothing = {n: new Uint32Array(), from: new Float64Array(), to: new Float64Array()};
function soundRow({problem, sound, label, file}, i, {media}) {
  if (problem) return [];
  const name = media.length > 1 ? `sound ${i + 1}` : 'sound';
  return [{name, colour: 'human', kind: 'wave', lane: nothing, reach: nothing.to, text: () => label || file, sound}];
}

const stateName = (data, i) => (data.lanes.state.name[i] < 0 ? data.graph.start : data.names[data.lanes.state.name[i]]);
const statusOf = (data, i) => data.names[data.lanes.act.status?.[i]] ?? '';
const most = (values) => (values ? values.reduce((a, b) => Math.max(a, b), 1) : 1);

export function reachOf({to}) {
  const reach = Float64Array.from(to);
  for (let i = 1; i < reach.length; ++i) reach[i] = Math.max(reach[i], reach[i - 1]);
  return reach;
}

/** The first item that may end at t or later. */
export const firstReaching = (row, t) => lastAtMost(row.reach, t - 1e-9) + 1;
