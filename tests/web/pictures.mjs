#!/usr/bin/env node
// Makes the pictures of the page that the documents show: CONTINUA=build/continua node tests/web/pictures.mjs web/pictures
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {logOf, program, root, serve, temporaryFolder, Visitor} from './support.mjs';

const out = process.argv[2] ?? join(root, 'web/pictures');
const runs = temporaryFolder();
mkdirSync(out, {recursive: true});
for (const name of ['correction.physics', 'disambiguation', 'disambiguation_exhausted', 'one_breath', 'special_npda'])
  writeFileSync(join(runs, `${name}.run.jsonl`), logOf(`paper/${name}`));
execFileSync(program, [
  'replay',
  join(root, 'traces/building_blocks.trace.jsonl'),
  '-o',
  join(runs, 'blocks.run.jsonl'),
]);
execFileSync(program, ['render', join(runs, 'correction.physics.run.jsonl'), '-o', join(out, 'contact_sheet.png')]);
const server = await serve(runs);
let visitor = await Visitor.start(server.address, {webgl: true});

async function picture(name, path, options = {}, prepare = async () => {}) {
  const page = await visitor.visit(path, options);
  await prepare(page);
  await page.waitForTimeout(9000); // pictures and the scene are drawn without a graphics card
  await page.screenshot({path: join(out, `${name}.png`)});
  console.log(join(out, `${name}.png`));
}
const large = {viewport: {width: 1440, height: 900}};
await picture('start', '/', {viewport: {width: 1280, height: 720}}, (page) => page.waitForTimeout(6000));
await picture('run', '/r/correction.physics', large);
await picture('graph', '/r/blocks', large, async (page) => {
  await page.locator('[data-testid=taken-only]').uncheck();
  await page.locator('.panel.graph .larger').click();
});
await picture('diff', '/diff/disambiguation/disambiguation_exhausted', {...large, colorScheme: 'dark'});
await picture('phone', '/r/blocks', {viewport: {width: 390, height: 844}, deviceScaleFactor: 2, isMobile: true});
await picture('live', '/live', large, async (page) => {
  const say = async (text) => {
    await page.fill('[data-testid=talk]', text);
    await page.press('[data-testid=talk]', 'Enter');
  };
  await page.click('[data-testid=live-start]');
  await page.waitForFunction(() => window.continua.page.shown.place?.view.stage?.drawing);
  await say('The knife.');
  await page.locator('text=Okay, go on.').waitFor();
  await page.fill('[data-testid=talk]', 'Put it there.');
  await page.mouse.click(560, 800);
  await page.press('[data-testid=talk]', 'Enter');
  await page.locator('text=✔ done').waitFor();
  await say('Put the plate in front of you.');
  await page.fill('[data-testid=talk]', 'And that');
  await page.mouse.click(700, 800);
});
await visitor.close();

// A hand that points, before a camera that is a clip.
const clip = join(runs, 'hand.mjpeg');
const still = readFileSync(join(root, 'tests/web/hand/point_left.jpg'));
writeFileSync(clip, Buffer.concat(Array(240).fill(still)));
const camera = ['--use-fake-device-for-media-stream', '--use-fake-ui-for-media-stream'];
visitor = await Visitor.start(server.address, {
  webgl: true,
  words: [...camera, `--use-file-for-fake-video-capture=${clip}`],
});
await picture('hand', '/live', {viewport: {width: 1100, height: 620}}, async (page) => {
  await page.click('[data-testid=live-start]');
  await page.click('[data-testid=live-hand]');
  await page.click('[data-testid=hand-agree]');
  await page.locator('text=Okay, go on.').waitFor({timeout: 240000});
});
await visitor.close();
server.stop();
