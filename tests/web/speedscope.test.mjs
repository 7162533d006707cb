// The time line of a run in speedscope, a viewer that knows slices alone: every lane is there.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {existsSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {packages, program, root, temporaryFolder, Visitor} from './support.mjs';

const release = join(packages, 'speedscope/dist/release');
if (!existsSync(release)) {
  console.log(`skipped: speedscope is not in ${packages}`);
  process.exit(77);
}

const folder = temporaryFolder();
let visitor;
before(async () => {
  visitor = await Visitor.start(pathToFileURL(release).href, {webgl: true});
});
after(() => visitor?.close());

// The lanes that speedscope offers for a run's time line.
async function lanesOf(run) {
  const file = join(folder, 'profile.js');
  const events = execFileSync(program, ['export', join(root, 'traces', `${run}.run.jsonl`), '--to', 'chrome'], {
    maxBuffer: 2 ** 30,
  });
  writeFileSync(file, `speedscope.loadFileFromBase64('run.json', '${events.toString('base64')}')`);
  await visitor.visit(`/index.html#localProfilePath=${file}`, {ready: null});
  await visitor.page.waitForFunction(() => /\(\d+\/\d+\)/.test(document.body.innerText));
  await visitor.page.keyboard.press('t');
  await visitor.page.waitForFunction(() => document.querySelector('input[type=text]'));
  return visitor.page.evaluate(() => document.body.innerText);
}

for (const run of ['building_blocks', 'talk/speech_only', 'paper/one_breath.physics'])
  test(`all five lanes of ${run} are shown`, async () => {
    const shown = await lanesOf(run);
    for (const lane of ['human', 'state', 'transitions', 'avatar', 'acts'])
      assert.match(shown, new RegExp(`\\b${lane}\\b`), shown);
  });
