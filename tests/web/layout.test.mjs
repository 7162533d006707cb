// The reader's own arrangement of a run's page: sizes of panels and choice of lanes, by mouse and keyboard, remembered.
import assert from 'node:assert/strict';
import {writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import {at, folder, serveFolder, visitor} from './served.mjs';
import {logOf} from './support.mjs';

serveFolder(() => {
  for (const name of ['correction', 'disambiguation'])
    writeFileSync(join(folder, `${name}.run.jsonl`), logOf(`paper/${name}`));
  writeFileSync(join(folder, 'building_blocks.run.jsonl'), logOf('building_blocks'));
});
const box = (selector) => visitor.page.locator(selector).boundingBox();

test('a bar between panels is dragged, or moved by keys, and stays where it was put', async () => {
  await visitor.visit('/r/correction');
  const bar = await box('[data-testid=splitter-dialogue-width]');
  const {width} = await box('.panel.dialogue');
  await visitor.page.mouse.move(bar.x + 4, bar.y + 60);
  await visitor.page.mouse.down();
  await visitor.page.mouse.move(bar.x + 124, bar.y + 60, {steps: 4});
  await visitor.page.mouse.up();
  const wider = (await box('.panel.dialogue')).width;
  assert.ok(Math.abs(wider - width - 120) < 8, `${width} → ${wider}`);
  const n = await visitor.n();
  await at('splitter-dialogue-width').press('ArrowLeft');
  const [narrower, now] = [
    (await box('.panel.dialogue')).width,
    await at('splitter-dialogue-width').getAttribute('aria-valuenow'),
  ];
  assert.ok(narrower < wider - 10);
  assert.equal(await visitor.n(), n, 'the cursor stays');
  await visitor.page.reload();
  await visitor.page.waitForSelector('[data-ready]', {state: 'attached'});
  assert.ok(Math.abs((await box('.panel.dialogue')).width - narrower) < 2);
  assert.equal(await at('splitter-dialogue-width').getAttribute('aria-valuenow'), now);
  await at('splitter-dialogue-width').press('Enter');
  assert.ok(Math.abs((await box('.panel.dialogue')).width - width) < 2, 'Enter: as it was');
  for (const name of ['scene-width', 'stack-width', 'tabs-width']) {
    await at(`splitter-${name}`).press('Shift+ArrowLeft');
    assert.ok(await visitor.page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), name);
  }
  assert.deepEqual(visitor.complaints, []);
});

test('lanes use the room that they are given, in the panel and enlarged', async () => {
  await visitor.visit('/r/correction');
  const heights = () => visitor.page.evaluate(() => document.querySelector('.timeline canvas').clientHeight);
  const usual = await heights();
  for (let i = 0; i < 3; ++i) await at('splitter-lanes-height').press('Shift+ArrowDown');
  const tall = await heights();
  assert.ok(tall > usual * 1.4, `${usual} → ${tall}`);
  await at('splitter-lanes-height').press('Enter');
  await visitor.page.waitForFunction((px) => document.querySelector('.timeline canvas').clientHeight === px, usual);
  await visitor.page.locator('.panel.lanes .larger').click();
  await visitor.page.waitForFunction((px) => document.querySelector('.timeline canvas').clientHeight > 2 * px, usual);
  await visitor.page.keyboard.press('Escape');
});

test('a lane is hidden, tall or first by choice, also at the next visit; what is pointed at is what is drawn', async () => {
  await visitor.visit('/r/correction');
  const rows = () =>
    visitor.page.evaluate(() => window.continua.page.parts.lanes.rows.map(({name, tall}) => [name, Boolean(tall)]));
  const before = await rows();
  await at('lane-choice').locator('summary').click();
  // None is behind another panel or cut off by its own.
  const hidden = await at('lane-choice').evaluate((list) => {
    const boxes = [...list.querySelectorAll('input')];
    const reached = (box) => {
      const {x, y, width, height} = box.getBoundingClientRect();
      return document.elementFromPoint(x + width / 2, y + height / 2) === box;
    };
    return boxes.filter((box) => !reached(box)).map((box) => box.getAttribute('aria-label'));
  });
  assert.deepEqual(hidden, []);
  const boxOf = (lane, way) => visitor.page.getByLabel(`${lane}: ${way}`).first();
  await boxOf('stack depth', 'shown').uncheck();
  await boxOf('acts', 'first').check();
  await boxOf('acts', 'tall').check();
  const expected = [['acts', true], ...before.filter(([name]) => !['acts', 'stack depth'].includes(name))];
  assert.deepEqual(await rows(), expected);
  await visitor.page.keyboard.press('Escape');
  assert.ok(!(await at('lane-choice').evaluate((list) => list.open)));
  await visitor.page.reload();
  await visitor.page.waitForSelector('[data-ready]', {state: 'attached'});
  assert.deepEqual(await rows(), expected);
  const timeline = await box('[data-testid=timeline]');
  const x = await visitor.page.evaluate(() => {
    const {lanes} = window.continua.page.parts;
    const {lane} = lanes.rows[0];
    return lanes.placeOf((lane.from[0] + lane.to[0]) / 2);
  });
  await visitor.page.mouse.move(timeline.x + x, timeline.y + 50); // within the tall lane
  assert.match(await visitor.page.locator('.timeline .tip').innerText(), /^acts: puts the white cup/);
});

test('all states of a large machine can be read at one step of zoom: the panel enlarged', async () => {
  await visitor.visit('/r/building_blocks', {viewport: {width: 1440, height: 900}});
  await at('taken-only').uncheck();
  await visitor.page.locator('.panel.graph .larger').click();
  const told = () =>
    visitor.page.evaluate(() => {
      const host = document.querySelector('.panel.graph .canvas').getBoundingClientRect();
      const letters = [...document.querySelectorAll('[data-testid=graph] text')];
      const within = (box) =>
        box.left >= host.left && box.right <= host.right && box.top >= host.top && box.bottom <= host.bottom;
      const states = [...document.querySelectorAll('[data-testid=graph] .node')];
      return {
        least_px: Math.min(...letters.map((one) => parseFloat(getComputedStyle(one).fontSize) * one.getScreenCTM().a)),
        states: states.length,
        in_sight: states.filter((one) => within(one.getBoundingClientRect())).length,
      };
    });
  await visitor.page.waitForFunction(() => document.querySelector('.panel.graph').classList.contains('enlarged'));
  await visitor.page.waitForTimeout(500); // until it is drawn for its new size
  const {least_px, states, in_sight} = await told();
  assert.deepEqual([states, in_sight], [29, 29]);
  assert.ok(least_px >= 11, `${least_px} px`);
});
