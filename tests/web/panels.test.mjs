// Every panel, on a worked example and on a longer session, in a real browser.
import assert from 'node:assert/strict';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {numberOf, recordsOf, root, serve, Visitor} from './support.mjs';

let server, visitor;
before(async () => {
  server = await serve(
    join(root, 'traces/paper/correction.physics.run.jsonl'),
    join(root, 'traces/building_blocks.run.jsonl'),
    join(root, 'traces/paper/special_npda.run.jsonl'),
    ...['gaze', 'interim_speech', 'gesture_shapes'].map((name) => join(root, `traces/mechanisms/${name}.run.jsonl`)),
  );
  visitor = await Visitor.start(server.address);
});
after(async () => {
  await visitor?.close();
  server?.stop();
});
const at = (id) => visitor.at(id);
const says = async (id, wanted) => assert.match(await at(`panel-${id}`).innerText(), wanted, id);

const runs = [
  {
    id: 'correction.physics',
    verdict: /2 utterances, 3 of 4 acts done, 1 broken off, 2 expectations met/,
    dialogue: /Put the white cup there[\s\S]*Okay/,
    states: 4,
    stack: /symbol \d+/,
    derivation: /“that one”/,
    why: /because the human said “No, that one\.”/,
    at: `n=${numberOf('paper/correction.physics', ({kind, program, status}) => kind === 'act' && status === 'asked' && /^put.cup_blue/.test(program))}`,
  },
  {
    id: 'building_blocks',
    verdict: /22 utterances, 4 of 4 acts done, 23 expectations met, 5 inputs refused/,
    dialogue: /steps up[\s\S]*Hello/,
    states: 10,
    stack: /symbol \d+/,
    derivation: /./,
    why: /the avatar/,
    at: '',
  },
];
for (const run of runs)
  test(`all panels of ${run.id}`, async () => {
    await visitor.visit(`/r/${run.id}?${run.at}`);
    assert.match(await at('verdict').innerText(), run.verdict);
    await says('dialogue', run.dialogue);
    assert.ok((await at('graph').locator('.node').count()) >= run.states);
    assert.equal(await at('graph').locator('.node.current').count(), 1);
    assert.match(await at('span').innerText(), /of \d+:\d\d\.\d/);
    assert.ok(
      await visitor.page.evaluate(
        () => window.continua.page.parts.lanes.rows.filter(({lane}) => lane.n.length).length >= 5,
      ),
    );
    await says('stack', run.stack);
    await says('derivation', run.derivation);
    await says('why', run.why);
    // Without WebGL the scene is a picture of the server's, or a sentence where that has none.
    await visitor.page.waitForFunction(
      () => document.querySelector('.scene img') ?? /picture|draw/i.test(document.querySelector('.scene').innerText),
    );
    await at('tab-records').click();
    assert.ok((await visitor.page.locator('.row').count()) > 3);
    await at('tab-notes').click();
    await says('notes', /No notes yet/);
    assert.deepEqual(
      visitor.complaints.filter((one) => !/501/.test(one)),
      [],
    );
  });

test('words and gestures that were taken as one stand together', async () => {
  await visitor.visit('/r/correction.physics');
  const ensemble = visitor.page.locator('.moves li.ensemble').first();
  assert.match(await ensemble.innerText(), /Put the white cup there[\s\S]*point/);
  assert.equal(await visitor.page.locator('.moves li.ensemble').count(), 2);
});

test('what was refused is listed with the value that refused it, and drawn on demand', async () => {
  const n = numberOf('paper/correction.physics', ({kind, id}) => kind === 'transition' && id === 'other thing');
  await visitor.visit(`/r/correction.physics?n=${n}`);
  await at('graph-refused').locator('summary').click();
  await visitor.page.waitForSelector('.edge.refused', {state: 'attached'});
  assert.match(await at('graph-refused').innerText(), /\d+ candidates refused[\s\S]* is /);
});

test('several configurations: how they branched, and the stack of each', async () => {
  const branches = recordsOf('paper/special_npda').filter(({kind}) => kind === 'branches');
  await visitor.visit(`/r/special_npda?n=${branches[2].n}&tab=branches&b=4`);
  assert.equal(await at('branches').locator('tbody tr').count(), 2);
  assert.equal(await visitor.page.locator('.branch-table .chosen [data-testid=branch]').innerText(), '4');
  assert.match(await at('depth').innerText(), /^branch 4/);
  assert.equal(await visitor.page.locator('.node.branch').getAttribute('data-state'), 'first half');
  await visitor.page.keyboard.press('b');
  await visitor.addressSays('b', 3);
  await visitor.page.waitForFunction(() => document.querySelector('.node.branch')?.dataset.state === 'second half');
  await visitor.page.locator('.branch-tree .dot').first().click();
  await visitor.addressSays('n', branches[0].n);
  assert.deepEqual(
    visitor.complaints.filter((one) => !/501/.test(one)),
    [],
  );
});

const laneNamed = (name) =>
  visitor.page.evaluate(
    (wanted) =>
      window.continua.page.parts.lanes.rows
        .filter(({name}) => name === wanted)
        .flatMap(({lane, text}) => Array.from(lane.n, (_, i) => text(i))),
    name,
  );

test('what the eyes dwell on has a lane, and is why that thing is asked about first', async () => {
  const asked = numberOf('mechanisms/gaze', ({kind}) => kind === 'utterance');
  await visitor.visit(`/r/gaze?n=${asked}`);
  assert.equal((await laneNamed('looks')).length, 1);
  await says('dialogue', /Lift the cup[\s\S]*blue cup/);
  await says('why', /gaze/);
});

test('words that are not final are shown as such, and led to a look alone', async () => {
  const look = numberOf('mechanisms/interim_speech', ({kind}) => kind === 'gesture');
  await visitor.visit(`/r/interim_speech?n=${look}`);
  await says('dialogue', /“lift the plate …”[\s\S]*looks at the white plate[\s\S]*“Lift the knife\.”/);
  assert.deepEqual((await laneNamed('human says')).slice(-2), ['lift the plate …', 'Lift the knife.']);
  await says('why', /not final/);
});

test('a gesture that was recognised by its shape is explained by the exemplar', async () => {
  const runs = 'mechanisms/gesture_shapes';
  const near = recordsOf(runs).findLast(({kind, shape}) => kind === 'reading' && shape?.nearest);
  await visitor.visit(`/r/gesture_shapes?n=${near.n}`);
  await says('why', new RegExp(near.shape.nearest));
});
