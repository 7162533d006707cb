// What if: another choice or another input, and the run that follows compared with the first.
import assert from 'node:assert/strict';
import {writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import {at, folder, listed, serveFolder, visitor} from './served.mjs';
import {guestOf, logOf, numberOf, recordsOf, root} from './support.mjs';

serveFolder(
  () => {
    for (const name of ['correction', 'disambiguation'])
      writeFileSync(join(folder, `${name}.run.jsonl`), logOf(`paper/${name}`));
  },
  {webgl: true},
);
const shown = ({kind, event}) => kind === 'input' && event.kind === 'gesture' && event.target;

test('what if an input had not come: the new run is compared with this one', async () => {
  await visitor.visit('/r/disambiguation');
  const said = await visitor.page.evaluate(() => window.continua.page.data.lanes.speech.n[1]);
  await visitor.visit(`/r/disambiguation?n=${said}`);
  await visitor.page.keyboard.press('x');
  await at('what-if-out').check();
  await at('what-if-run').click();
  await visitor.page.waitForURL(/\/diff\/disambiguation\/what-if/);
  await at('verdict').waitFor();
  assert.match(await at('verdict').innerText(), /“No\.” .* is left out in B/);
  await visitor.visit('/');
  await listed();
  assert.match(await at('runs').innerText(), /what if of disambiguation/);
});

test('what if it had been said otherwise', async () => {
  await visitor.visit('/r/disambiguation');
  const said = await visitor.page.evaluate(() => window.continua.page.data.lanes.speech.n[0]);
  await visitor.visit(`/r/disambiguation?n=${said}`);
  await at('what-if-open').click();
  await at('what-if').locator('summary').click();
  await at('what-if-event').fill('{"kind": "speech"');
  await at('what-if-run').click();
  assert.match(await visitor.page.locator('.what-if .trouble').innerText(), /no JSON/);
  await at('what-if-words').fill('Take the knife.');
  assert.match(await at('what-if-event').inputValue(), /"text": "Take the knife\."/);
  await at('what-if-words').press('Enter');
  await visitor.page.waitForURL(/\/diff\//);
  await at('verdict').waitFor();
  assert.match(await at('verdict').innerText(), /Take the knife/);
});

test('what if it had been pointed elsewhere: sliders move the place', async () => {
  await visitor.visit(`/r/correction?n=${numberOf('paper/correction', shown)}`);
  await at('what-if-open').click();
  const place = await at('what-if-place').innerText();
  for (let i = 0; i < 20; ++i) await at('what-if-left-to-right').press('ArrowLeft');
  assert.notEqual(await at('what-if-place').innerText(), place);
  await at('what-if-run').click();
  await visitor.page.waitForURL(/\/diff\/correction\/what-if/);
  await at('verdict').waitFor();
  assert.match(await at('verdict').innerText(), /point/);
});

test('the target of a pointing is dragged in the scene to ask what if it had been there', async () => {
  const stroke = numberOf('paper/correction', shown);
  await visitor.visit(`/r/correction?n=${stroke}`, {ready: '[data-testid=scene-stage][data-shows=drawing]'});
  const {page} = visitor;
  const canvas = at('scene-canvas');
  await page.waitForFunction(() =>
    /The human points/.test(document.querySelector('[data-testid=scene-caption]').innerText),
  );
  const {target} = recordsOf('paper/correction')[stroke].event;
  const place = async ([x, y]) => {
    const [left, top] = await page.evaluate(
      (point) => window.continua.page.parts.scene.stage.drawing.project(point),
      [x, y, 0],
    );
    const box = await canvas.boundingBox();
    return [box.x + left, box.y + top];
  };
  const wanted = [target[0] + 0.1, target[1]];
  const view = await page.evaluate(() => window.continua.page.parts.scene.stage.view);
  await page.mouse.move(...(await place(target)));
  assert.equal(await canvas.evaluate((one) => one.style.cursor), 'grab');
  await page.mouse.down();
  await page.mouse.move(...(await place(wanted)), {steps: 4});
  await page.mouse.up();
  await at('what-if-event').waitFor({state: 'attached'});
  assert.deepEqual(await page.evaluate(() => window.continua.page.parts.scene.stage.view), view, 'the view stays');
  const asked = JSON.parse(await at('what-if-event').inputValue());
  asked.target.forEach((x, i) => assert.ok(Math.abs(x - wanted[i]) < 0.01, `${asked.target} is not ${wanted}`));
  await at('what-if-run').click();
  await page.waitForURL(/\/diff\/correction\/what-if/);
});

test('what if it had come earlier', async () => {
  await visitor.visit('/r/disambiguation');
  const said = await visitor.page.evaluate(() => window.continua.page.data.lanes.speech.n[1]);
  const t = await visitor.page.evaluate((n) => window.continua.page.data.t[n], said);
  await visitor.visit(`/r/disambiguation?n=${said}`);
  await at('what-if-open').click();
  for (let i = 0; i < 5; ++i) await at('what-if-time').press('ArrowLeft');
  assert.match(await at('what-if-when').innerText(), /0\.5 s earlier/);
  await at('what-if-run').click();
  await visitor.page.waitForURL(/\/diff\/disambiguation\/what-if/);
  await at('verdict').waitFor();
  const b = await visitor.page.evaluate(() => window.continua.page.comparison.side.data);
  assert.ok(Math.abs(b.t[b.lanes.speech.n[1]] - (t - 0.5)) < 1e-3);
});

test('what if another transition had been taken', async (t) => {
  const path = join(root, 'traces/talk/n_best.run.jsonl');
  const rivals = ({kind, candidates}) => kind === 'transition' && new Set(candidates.map(({id}) => id)).size > 1;
  const guest = await guestOf(t, path);
  await guest.visit(`/r/n_best?n=${numberOf('talk/n_best', rivals)}`);
  await guest.at('what-if-open').click();
  await guest.at('what-if-run').click();
  assert.match(await guest.page.locator('.what-if .trouble').innerText(), /Change something first/);
  const others = guest.at('what-if').locator('input[type=radio]:not([value=""])');
  assert.ok((await others.count()) > 0);
  for (const told of await guest.at('what-if').locator('fieldset').first().locator('label').allInnerTexts())
    assert.match(told, / → \w/);
  await others.first().check();
  await guest.at('what-if-run').click();
  await guest.page.waitForURL(/\/diff\/n_best\/what-if/);
  await guest.at('verdict').waitFor();
  assert.match(await guest.at('verdict').innerText(), /^≠ /);
});
