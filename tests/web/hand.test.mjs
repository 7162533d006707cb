// A hand before the camera of a live session: the camera is a clip, the model is that which is installed.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {existsSync, readFileSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {after, before, test} from 'node:test';
import {fileURLToPath} from 'node:url';
import {
  at,
  begin,
  beginWith,
  close,
  eventsOf,
  folder,
  idOf,
  open,
  server,
  until,
  use,
  visitor,
} from './live_support.mjs';
import {program, skip, Visitor} from './support.mjs';

if (!existsSync(join(dirname(program), 'hands', 'hands.js')))
  skip('@mediapipe/hands is not installed beside the program');

const frames = 240; // of each picture, at 30 a second: without a graphics card one is looked at in a second or two
const speed = 0.25; // of the engine's time, for the same reason
const patience_ms = 240_000;
const pictures = ['point_left', 'point_right', 'thumb_up', 'empty'];
const words = ['--use-fake-device-for-media-stream', '--use-fake-ui-for-media-stream'];
const traceOf = async () => eventsOf(join(folder, `${await idOf()}.trace.jsonl`));
const stateIs = (pattern) =>
  visitor.page.waitForFunction(
    (wanted) => new RegExp(wanted).test(document.querySelector('[data-testid=hand-state]')?.textContent),
    pattern.source,
    {timeout: patience_ms},
  );

let tracking;
before(async () => {
  await open();
  const clip = join(folder, 'hand.mjpeg');
  const here = join(dirname(fileURLToPath(import.meta.url)), 'hand');
  const stills = pictures.map((name) => readFileSync(join(here, `${name}.jpg`)));
  writeFileSync(clip, Buffer.concat(stills.flatMap((still) => Array(frames).fill(still))));
  const camera = [...words, `--use-file-for-fake-video-capture=${clip}`];
  tracking = await Visitor.start(server.address, {webgl: true, words: camera});
});
after(async () => {
  await tracking?.close();
  await close();
});

test('nothing looks at the hand, nor loads the model, before the human has agreed', async () => {
  await beginWith(tracking, {});
  const asked = [];
  visitor.page.on('request', (request) => asked.push(new URL(request.url()).pathname));
  await visitor.page.evaluate(() => {
    navigator.mediaDevices.getUserMedia = () => {
      globalThis.asked = true;
      return Promise.reject(new DOMException('no', 'NotAllowedError'));
    };
  });
  assert.equal(await at('live-hand').getAttribute('aria-pressed'), 'false');
  await at('live-hand').press('Enter');
  assert.match(await at('hand-consent').innerText(), /stay in this browser[\s\S]*You can stop at any time/);
  await at('hand-not-now').click();
  assert.equal(await visitor.page.evaluate(() => globalThis.asked), undefined);
  // Nor where the browser refuses.
  await at('live-hand').click();
  await at('hand-agree').click();
  await visitor.page.waitForFunction(() =>
    /not allowed to use the camera/.test(document.querySelector('[data-testid=live-notice]').textContent),
  );
  assert.equal(await at('hand-view').count(), 0);
  assert.deepEqual(
    asked.filter((path) => path.startsWith('/hands/')),
    [],
  );
  await at('live-end').click();
});

test('a hand points and shows gestures, each of which is in the trace once, and the trace replays', async () => {
  await beginWith(tracking, {speed});
  const outside = [];
  visitor.page.on('request', (request) => {
    if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(server.address)) outside.push(request.url());
  });
  await at('live-hand').click();
  await at('hand-agree').click();
  await stateIs(/Seen/);
  const has = (wanted) => async () => (await traceOf()).some(wanted);
  const gesture = (name, phase) => (event) => event.name === name && event.phase === phase;
  // The left of the mirrored picture is the left of the table.
  const pointsAt = (side) => (event) =>
    event.kind === 'pointing' && side * event.target[0] > 0.1 && side * event.target[0] < 0.4;
  await until(has(pointsAt(-1)), 'the hand points to the left', patience_ms);
  await until(has(pointsAt(1)), 'the hand points to the right', patience_ms);
  await until(has(gesture('posack', 'stop')), 'the thumb was up', patience_ms);
  assert.match(await visitor.page.locator('[data-testid=conversation]').innerText(), /yes, (begins|ends)/);
  // What goes on stops when the human stops it.
  await stateIs(/Seen/);
  await until(has(gesture('point', 'start')), 'it points again', patience_ms);
  await at('live-hand').click();
  assert.equal(await at('hand-view').count(), 0);
  await visitor.page.waitForTimeout(2000);
  const told = await traceOf();
  await visitor.page.waitForTimeout(3000);
  assert.equal((await traceOf()).length, told.length, 'nothing is looked at any more');
  for (const name of ['point', 'posack']) {
    const phases = told.filter((event) => event.name === name).map(({phase}) => phase);
    phases.forEach((phase, i) => assert.equal(phase, i % 2 ? 'stop' : 'start', phases.join()));
    assert.equal(phases.length % 2, 0, phases.join());
  }
  const trace = join(folder, `${await idOf()}.trace.jsonl`);
  await at('live-end').click();
  await at('live-summary').waitFor();
  assert.match(execFileSync(program, ['check', trace], {encoding: 'utf8'}), /same decisions/);
  assert.deepEqual(outside, []);
  assert.deepEqual(visitor.complaints, []);
});

test('the worker alone may compile WebAssembly', async () => {
  const policyOf = async (path) => (await fetch(server.address + path)).headers.get('content-security-policy');
  assert.match(await policyOf('/hands/worker.js'), /script-src 'self' 'wasm-unsafe-eval'(;|$)/);
  assert.doesNotMatch(await policyOf('/live'), /unsafe/);
  for (const path of ['/hands/', '/hands/none.js', '/hands/%2e%2e/continua', '/hands/..%2fcontinua'])
    assert.equal((await fetch(server.address + path)).status, 404, path);
});

test('a page without what it needs says so, and has no such button', async () => {
  await beginWith(tracking, {});
  const {page} = visitor;
  const missing = async (pattern) => {
    await page.reload();
    await at('hand-missing').waitFor();
    assert.match(await at('hand-missing').innerText(), pattern);
    assert.equal(await at('live-hand').count(), 0);
  };
  await page.addInitScript(() => {
    OffscreenCanvas.prototype.getContext = () => null;
  });
  await missing(/no WebGL/);
  await page.route(/api\/sessions\/[^/]+$/, async (route) => {
    const response = await route.fetch();
    await route.fulfill({response, json: {...(await response.json()), hands: false}});
  });
  await missing(/not installed/);
  await at('live-end').click();
});

for (const colorScheme of ['light', 'dark'])
  test(`nothing stands in the way of access, ${colorScheme}`, async () => {
    await begin(tracking, {bypassCSP: true, colorScheme});
    await at('live-hand').click();
    assert.deepEqual(await visitor.violations(), []);
    await at('hand-agree').click();
    await at('hand-view').waitFor();
    assert.deepEqual(await visitor.violations(), []);
    await at('live-hand').click();
    await at('live-end').click();
  });
