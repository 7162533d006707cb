// The record, instant or state that is typed in: 137 or #137, 12.48s or 1:02, the name of a state.
import {lastAtMost} from '../search.js';

// The last record up to time t that is worth stopping at; before the first of them the first.
function stopBefore(data, t) {
  const {stops} = data;
  if (!stops.length) return data.at(t);
  return stops[Math.max(0, lastAtMost(stops, data.at(t)))];
}

/** The record that the text means, seen from record n, or null. */
export function placeOf(data, text, n) {
  const stopAt = (t) => stopBefore(data, t);
  const record = /^#?(\d+)$/.exec(text);
  if (record) return Number(record[1]) < data.size ? Number(record[1]) : null;
  const clock = /^(\d+):(\d{1,2}(?:\.\d+)?)$/.exec(text);
  const seconds = /^(\d+(?:\.\d+)?)\s*s?$/.exec(text);
  if (clock) return stopAt(Number(clock[1]) * 60 + Number(clock[2]));
  if (seconds) return stopAt(Number(seconds[1]));
  const state = data.graph.states.find(({id}) => id.toLowerCase().startsWith(text.toLowerCase()));
  if (!state || !text) return null;
  const wanted = data.names.indexOf(state.id);
  const {to, n: numbers} = data.steps;
  const from = data.step(n) + 1;
  for (let i = 0; i < numbers.length; ++i) {
    const place = (from + i) % numbers.length;
    if (to[place] === wanted) return numbers[place];
  }
  return null;
}
