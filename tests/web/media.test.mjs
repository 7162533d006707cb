// Recordings beside the trace, played in step with the cursor, in a real browser. Skipped without ffmpeg, which makes them.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';
import {filmed, makeFilms} from './media_support.mjs';
import {serve, temporaryFolder, Visitor} from './support.mjs';

const folder = temporaryFolder();
let server, visitor;
before(async () => {
  makeFilms(folder);
  filmed(folder, 'filmed', [
    {file: 'ramp.webm', label: 'table'},
    {file: 'bars.webm', label: 'face', offset: 1.5},
    {file: 'tone.wav', label: 'headset', offset: -2},
    {file: 'gone.mp4'},
    {file: '../gone.mp4'},
  ]);
  filmed(folder, 'plain', []);
  server = await serve(folder);
  visitor = await Visitor.start(server.address);
});
after(async () => {
  await visitor?.close();
  server?.stop();
});
const at = (id) => visitor.at(id);

/** Of each player: how far it is from its place, in seconds, and how it is. */
const players = () =>
  visitor.page.evaluate(() => {
    const {cursor, parts} = window.continua.page;
    return parts.media.views.map(({player}, i) => ({
      ahead: player.currentTime - (cursor.time + [0, 1.5, -2][i]),
      ...{paused: player.paused, rate: player.playbackRate, muted: player.muted, duration: player.duration},
    }));
  });
const go = (t) =>
  visitor.page.evaluate((wanted) => {
    const {cursor, data} = window.continua.page;
    cursor.jump(data.at(wanted));
  }, t);
const settled = () =>
  visitor.page.waitForFunction(() => {
    const {cursor, parts} = window.continua.page;
    return parts.media.views.every(({player}, i) => {
      const place = cursor.time + [0, 1.5, -2][i];
      return place < 0 || place > player.duration || (!player.seeking && Math.abs(player.currentTime - place) < 0.02);
    });
  });
/** The brightness in the middle of the first film: a ramp from black to white in twenty seconds. */
const brightness = () =>
  visitor.page.evaluate(() => {
    const canvas = document.createElement('canvas');
    const pen = canvas.getContext('2d');
    pen.drawImage(window.continua.page.parts.media.views[0].player, 0, 0, 16, 12);
    return pen.getImageData(8, 6, 1, 1).data[0];
  });
const open = async (path, options) => {
  await visitor.visit(path, options);
  await visitor.page.waitForFunction(() =>
    window.continua.page.parts.media.views.every(({player}) => player.readyState >= 2),
  );
};

test('the cursor leads: each recording is at its own place, whatever its offset', async () => {
  await open('/r/filmed?tab=media');
  assert.equal(await at('media-view').count(), 3);
  for (const t of [3, 8.2, 1]) {
    await go(t);
    await settled();
    const now = await visitor.page.evaluate(() => window.continua.page.cursor.time);
    const seen = await brightness();
    assert.ok(Math.abs(seen - (now / 20) * 255) < 8, `at ${now} s the picture has ${seen}`);
  }
  for (const one of await players()) assert.ok(one.paused);
  assert.deepEqual(visitor.complaints, []);
});

test('playing keeps all of them in step, at any speed, and stopping stops them', async () => {
  await open('/r/filmed?tab=media&n=0');
  await visitor.page.keyboard.press(' ');
  for (const [speed, near] of [
    [1, 0.25],
    [2, 0.5],
  ]) {
    await visitor.page.getByLabel('Speed').selectOption(String(speed));
    await visitor.page.waitForTimeout(1500);
    for (const {ahead, paused, rate} of (await players()).slice(0, 2)) {
      assert.equal(paused, false);
      assert.ok(Math.abs(ahead) < near && Math.abs(rate - speed) <= 0.15 * speed + 0.01, `${ahead} s at ${rate}`);
    }
  }
  await visitor.page.keyboard.press(' ');
  await settled();
  for (const {paused} of await players()) assert.ok(paused);
});

test('where nothing was recorded the player rests and says so', async () => {
  await open('/r/filmed?tab=media&n=0');
  assert.match(await at('media-view').nth(2).innerText(), /nothing recorded here/);
  await go(5);
  await settled();
  assert.doesNotMatch(await at('media-view').nth(2).innerText(), /nothing recorded here/);
});

test('each is heard or muted by itself, by keyboard too', async () => {
  await open('/r/filmed?tab=media');
  assert.deepEqual(
    (await players()).map(({muted}) => muted),
    [false, true, true],
  );
  await at('media-hear').nth(2).focus();
  await visitor.page.keyboard.press('Enter');
  await visitor.page.waitForFunction(() => !window.continua.page.parts.media.views[2].player.muted);
  assert.equal(await at('media-hear').nth(2).getAttribute('aria-pressed'), 'true');
});

test('recordings that cannot be had are told; a run without any has no panel', async () => {
  await visitor.visit('/r/filmed?tab=media');
  const missing = await at('media-missing').allInnerTexts();
  assert.match(missing[0], /gone\.mp4 is not there/);
  assert.match(missing[1], /\.\.\/gone\.mp4 lies outside of the folder/);
  await visitor.visit('/r/plain');
  assert.equal(await at('tab-media').count(), 0);
  assert.deepEqual(visitor.complaints, []);
});

for (const colorScheme of ['light', 'dark'])
  test(`nothing stands in the way of access, ${colorScheme}`, async () => {
    await open('/r/filmed?tab=media', {bypassCSP: true, colorScheme});
    assert.deepEqual(await visitor.violations(), []);
  });
