// The calculations of the live page, without a page: times of words and clicks, the engine's time, lines of the
// conversation.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {lineOf} from '../../web/talk/conversation.js';
import {Draft} from '../../web/talk/draft.js';
import {formatAddress, parseAddress} from '../../web/model.js';
import {EngineClock} from '../../web/talk/engine_clock.js';
import {eventOf, interimOf} from '../../web/talk/microphone.js';

test('words are spread over the time before now, and each click goes with its word', () => {
  const draft = new Draft();
  draft.type('Put it there');
  draft.click([0.1, -0.05]);
  draft.type('Put it there and that');
  draft.click([0.2, 0]);
  assert.deepEqual(
    draft.clicks.map((click) => draft.wordOf(click)),
    ['there', 'that'],
  );
  const events = draft.take()(10);
  assert.deepEqual(events[0], {
    t: 8.8,
    kind: 'speech',
    text: 'Put it there and that',
    until: 10,
    words: [
      ['Put', 8.8],
      ['it', 9.04],
      ['there', 9.28],
      ['and', 9.52],
      ['that', 9.76],
    ].map(([text, t]) => ({text, t})),
  });
  assert.deepEqual(
    events.slice(1).map(({t, target}) => [t, target]),
    [
      [9.28, [0.1, -0.05]],
      [9.76, [0.2, 0]],
    ],
  );
  assert.equal(draft.take(), null);
});

test('words without a click have no times, a click goes with the text that is left', () => {
  const draft = new Draft();
  draft.type('one two three');
  draft.click([0, 0]);
  draft.type('one');
  assert.equal(draft.wordOf(draft.clicks[0]), 'one');
  assert.deepEqual(
    draft
      .take()(0.1)
      .map(({t}) => t),
    [0, 0],
  );
  draft.type('one two');
  draft.click([0, 0]);
  draft.type(' ');
  draft.type('Yes.');
  assert.deepEqual(draft.take()(5), [{kind: 'speech', text: 'Yes.'}]);
});

test('engine time runs with the wall’s, stands while paused, and is never behind what has happened', () => {
  let wall = 0;
  const clock = new EngineClock(() => wall);
  clock.told({t: 3, running: true, speed: 2});
  wall = 500;
  assert.equal(clock.now, 4);
  clock.atLeast(3.5);
  assert.equal(clock.now, 4);
  clock.atLeast(6);
  wall = 1000;
  assert.equal(clock.now, 7);
  clock.told({t: 7, running: false});
  wall = 9000;
  assert.equal(clock.now, 7);
});

test('what the recogniser heard becomes speech with its confidence and its other readings', () => {
  assert.deepEqual(
    eventOf([
      {transcript: ' the plate ', confidence: 0.912},
      {transcript: 'the play', confidence: 0},
    ]),
    {kind: 'speech', text: 'the plate', confidence: 0.91, alternatives: [{text: 'the play', confidence: 0.91}]},
  );
  assert.deepEqual(eventOf([{transcript: 'yes', confidence: 0}]), {kind: 'speech', text: 'yes'});
  assert.equal(eventOf([{transcript: ' ', confidence: 1}]), null);
});

test('words that are not final are told as such, and leave a passing line', () => {
  assert.deepEqual(interimOf([{transcript: ' put the', confidence: 0}]), {
    kind: 'speech',
    text: 'put the',
    final: false,
  });
  assert.equal(interimOf([{transcript: ' ', confidence: 0}]), null);
  assert.deepEqual(lineOf({kind: 'input', event: {kind: 'speech', text: 'put the', final: false}}), {
    who: 'human',
    how: 'is saying',
    text: 'put the …',
    passing: true,
  });
});

test('samples and what came of them are no lines of the conversation', () => {
  assert.equal(lineOf({kind: 'input', event: {kind: 'pointing', target: [0, 0]}}), null);
  assert.equal(lineOf({kind: 'refusal', reason: 'late'}, true), null);
  assert.equal(lineOf({kind: 'act', status: 'asked', step: 1, program: 'move(cup)'}), null);
  assert.equal(lineOf({kind: 'refusal', reason: 'it came too late'}).text, 'not understood: it came too late');
  const {text, end} = lineOf({
    kind: 'input',
    event: {kind: 'gesture', name: 'point', phase: 'start', target: [0.1, -0.05]},
  });
  assert.equal(text + end, 'point, begins, 10 cm right, 5 cm nearer');
});

test('the live page has an address of its own', () => {
  for (const [address, live] of [
    ['/live', ''],
    ['/live/', ''],
    ['/live/talk%202', 'talk 2'],
  ])
    assert.equal(parseAddress(address).live, live);
  for (const address of ['/', '/r/live', '/lively']) assert.equal(parseAddress(address).live, undefined);
  assert.equal(formatAddress(parseAddress('/live/talk%202')), '/live/talk%202');
  assert.equal(formatAddress(parseAddress('/live')), '/live');
});
