// A live session that records the human, in a browser whose camera and microphone are made up.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {existsSync, statSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {at, begin, close, eventsOf, folder, idOf, open, server, type, until, use, visitor} from './live_support.mjs';
import {program, Visitor} from './support.mjs';

let filming;
before(async () => {
  await open();
  filming = await Visitor.start(server.address, {
    words: ['--use-fake-device-for-media-stream', '--use-fake-ui-for-media-stream'],
  });
});
after(async () => {
  await filming?.close();
  await close();
});
const file = (id, name) => join(folder, `${id}.${name}`);
const agree = async (...sources) => {
  await at('live-film').click();
  for (const source of sources) await at(`film-${source}`).check();
  await at('film-agree').click();
  await visitor.page.waitForFunction(() => /Stop/.test(document.querySelector('[data-testid=live-film]').textContent));
};

test('nothing is recorded before the human has agreed', async () => {
  await begin(filming);
  const asked = await visitor.page.evaluate(() => {
    globalThis.asked = 0;
    const {mediaDevices} = navigator;
    const own = mediaDevices.getUserMedia.bind(mediaDevices);
    mediaDevices.getUserMedia = (wanted) => {
      globalThis.asked += 1;
      return own(wanted);
    };
    return globalThis.asked;
  });
  assert.equal(asked, 0);
  await at('live-film').click();
  assert.match(await at('film').innerText(), /beside its trace[\s\S]*1 GiB[\s\S]*stop at any time/);
  assert.equal(await at('film-agree').isDisabled(), true);
  assert.equal(await at('film-microphone').isChecked(), false);
  assert.equal(await at('film-camera').isChecked(), false);
  await at('film-not-now').click();
  assert.equal(await visitor.page.evaluate(() => globalThis.asked), 0);
  const id = await idOf();
  await at('live-end').click();
  await at('live-summary').waitFor();
  assert.ok(!existsSync(file(id, 'camera.webm')));
  assert.equal(eventsOf(file(id, 'trace.jsonl'))[0].media, undefined);
});

test('camera and microphone go beside the trace, which names them, and play in step with the run', async () => {
  await begin(filming);
  const id = await idOf();
  await visitor.page.waitForTimeout(1000);
  await agree('microphone', 'camera');
  await type('The plate.');
  await visitor.page.waitForTimeout(3000);
  await at('live-pause').click();
  await visitor.page.waitForTimeout(1500); // of which nothing is recorded
  await at('live-pause').click();
  await visitor.page.waitForTimeout(1000);
  await at('live-end').click();
  await at('live-summary').waitFor();
  assert.match(await at('live-summary').innerText(), /names the recordings of you/);
  const [header] = eventsOf(file(id, 'trace.jsonl'));
  assert.equal(header.media.length, 1);
  const [{offset, ...named}] = header.media;
  assert.deepEqual(named, {file: `${id}.camera.webm`, kind: 'video', label: 'camera'});
  assert.ok(offset < -0.9 && offset > -10, String(offset));
  assert.ok(statSync(file(id, 'camera.webm')).size > 10000);
  assert.match(execFileSync(program, ['validate', file(id, 'trace.jsonl')], {encoding: 'utf8'}), /trace, /);
  assert.match(execFileSync(program, ['check', file(id, 'trace.jsonl')], {encoding: 'utf8'}), /same decisions/);

  const end = eventsOf(file(id, 'trace.jsonl')).at(-1).t;
  await visitor.visit(`/r/${id}?tab=media`);
  await visitor.page.waitForFunction(() => window.continua.page.parts.media.views[0].player.readyState >= 2);
  const {duration} = await visitor.page.evaluate(() => ({
    duration: window.continua.page.parts.media.views[0].player.duration,
  }));
  assert.ok(Math.abs(duration - (end + offset)) < 0.7, `${duration} s of film for ${end + offset} s of the session`);
  await visitor.page.waitForFunction(() => window.continua.page.data.media[0].sound.peaks?.values.length > 100);
  assert.deepEqual(visitor.complaints, []);
});

test('the human stops it at any time; a microphone alone gives sound alone', async () => {
  await begin(filming);
  const id = await idOf();
  await agree('microphone');
  await visitor.page.waitForTimeout(1500);
  await at('live-film').click();
  await visitor.page.waitForFunction(() =>
    /Record me/.test(document.querySelector('[data-testid=live-film]').textContent),
  );
  const sound = file(id, 'microphone.webm');
  await until(() => existsSync(sound), 'the sound is written');
  // The last part may still be on its way; a part lasts one second.
  await until(async () => {
    const {size} = statSync(sound);
    await visitor.page.waitForTimeout(2000);
    return statSync(sound).size === size;
  }, 'nothing more is written');
  await at('live-end').click();
  await at('live-summary').waitFor();
  assert.equal(eventsOf(file(id, 'trace.jsonl'))[0].media[0].kind, 'audio');
});

test('a browser that is not allowed to is told so, and the session goes on', async () => {
  const forbidden = await Visitor.start(server.address, {words: ['--use-fake-device-for-media-stream']});
  try {
    await begin(forbidden);
    await visitor.page.evaluate(() => {
      navigator.mediaDevices.getUserMedia = () => Promise.reject(new DOMException('no', 'NotAllowedError'));
    });
    await at('live-film').click();
    await at('film-camera').check();
    await at('film-agree').click();
    await visitor.page.waitForFunction(() =>
      /not allowed to record you/.test(document.querySelector('[data-testid=live-notice]').textContent),
    );
    await at('live-end').click();
    await at('live-summary').waitFor();
  } finally {
    use(filming);
    await forbidden.close();
  }
});

for (const colorScheme of ['light', 'dark'])
  test(`nothing stands in the way of access, ${colorScheme}`, async () => {
    await begin(filming, {bypassCSP: true, colorScheme});
    await at('live-film').click();
    assert.deepEqual(await visitor.violations(), []);
    await at('film-not-now').click();
    await at('live-end').click();
  });
