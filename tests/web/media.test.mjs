// Recordings beside the trace, played in step with the cursor, in a real browser. Skipped without ffmpeg, which makes them.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdirSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {filmed, makeFilms} from './media_support.mjs';
import {at, folder, serveFolder, server, visitor} from './served.mjs';
import {program, serve, temporaryFolder, Visitor} from './support.mjs';

serveFolder(() => {
  makeFilms(folder);
  filmed(folder, 'filmed', [
    {file: 'ramp.webm', label: 'table'},
    {file: 'bars.webm', label: 'face', offset: 1.5},
    {file: 'tone.wav', label: 'headset', offset: -2},
    {file: 'gone.mp4'},
    {file: '../gone.mp4'},
  ]);
  filmed(folder, 'one', [{file: 'tone.wav'}]);
  filmed(folder, 'plain', []);
});

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

/** Columns of the lane with this name in which anything is drawn in the colour of the human, as instants of the run. */
const drawn = (name) =>
  visitor.page.evaluate((wanted) => {
    const {lanes} = window.continua.page.parts;
    const canvas = document.querySelector('.timeline canvas');
    const ratio = canvas.width / canvas.clientWidth;
    const top = 17 + lanes.rows.findIndex((row) => row.name === wanted) * 15;
    const human = getComputedStyle(canvas).getPropertyValue('--human').trim();
    const [r, g, b] = [1, 3, 5].map((at) => parseInt(human.slice(at, at + 2), 16));
    const pen = canvas.getContext('2d');
    const found = [];
    for (let t = 0.25; t < 6; t += 0.5) {
      const {data} = pen.getImageData(Math.round(lanes.placeOf(t) * ratio), Math.round((top + 5.5) * ratio), 1, 1);
      if (data[0] === r && data[1] === g && data[2] === b) found.push(t);
    }
    return found;
  }, name);

test('the waveform of a recording is a lane, at the times of its sound', async () => {
  await open('/r/filmed?tab=media&z=0..6&gaps=full');
  await visitor.page.waitForFunction(() =>
    window.continua.page.data.media.slice(0, 3).every(({sound}) => sound.peaks || sound.problem),
  );
  await visitor.page.waitForTimeout(600);
  // A second of tone, a second of silence.
  assert.deepEqual(await drawn('sound 1'), [0.25, 0.75, 2.25, 2.75, 4.25, 4.75]);
  const problems = await visitor.page.evaluate(() => window.continua.page.data.media.map(({sound}) => sound.problem));
  assert.match(problems[1], /no waveform: ffmpeg finds no sound/);
  // The third begins two seconds after the run.
  const third = await visitor.page.evaluate(() => window.continua.page.data.media[2].sound.peaks);
  assert.ok(third.offset === -2 && third.values.length >= 1000);
});

test('without ffmpeg the lane says so; with a file of peaks it needs none', async () => {
  const bare = await serve(folder, {env: {PATH: folder}});
  const other = await Visitor.start(bare.address);
  try {
    await other.visit('/r/filmed?tab=media');
    await other.page.waitForFunction(() => /ffmpeg/.test(window.continua.page.data.media[0].sound.problem));
    execFileSync(program, ['trace', 'peaks', join(folder, 'one.trace.jsonl')]);
    await other.visit('/r/one?tab=media');
    await other.page.waitForFunction(() => window.continua.page.data.media[0].sound.peaks?.values.length >= 1000);
  } finally {
    await other.close();
    bare.stop();
  }
});

for (const embed of [false, true])
  test(`an exported page ${embed ? 'holds' : 'links'} the recordings`, async () => {
    const file = join(folder, 'pages', `${embed}.html`);
    mkdirSync(join(folder, 'pages'), {recursive: true});
    const flag = embed ? ['--embed-media'] : [];
    execFileSync(program, ['export', join(folder, 'filmed.run.jsonl'), '--to', 'html', ...flag, '-o', file]);
    const reader = await Visitor.start(pathToFileURL(folder).href);
    try {
      const page = await reader.visit(`/pages/${embed}.html#/r/filmed?tab=media`);
      await page.waitForFunction(() =>
        window.continua.page.parts.media.views.every(({player}) => player.readyState >= 2),
      );
      await page.evaluate(() => window.continua.page.cursor.jump(window.continua.page.data.at(4)));
      await page.waitForFunction(() => {
        const {cursor, parts} = window.continua.page;
        const {player} = parts.media.views[0];
        return !player.seeking && Math.abs(player.currentTime - cursor.time) < 0.02;
      });
      await page.waitForFunction(() => window.continua.page.data.media[0].sound.peaks);
      const sources = await page.evaluate(() =>
        window.continua.page.parts.media.views.map(({player}) => player.getAttribute('src')),
      );
      if (embed) assert.ok(sources.every((src) => src.startsWith('blob:')));
      else assert.deepEqual(sources, ['../ramp.webm', '../bars.webm', '../tone.wav']);
      assert.deepEqual(reader.complaints, []);
    } finally {
      await reader.close();
    }
  });

for (const colorScheme of ['light', 'dark'])
  test(`nothing stands in the way of access, ${colorScheme}`, async () => {
    await open('/r/filmed?tab=media', {bypassCSP: true, colorScheme});
    assert.deepEqual(await visitor.violations(), []);
  });
