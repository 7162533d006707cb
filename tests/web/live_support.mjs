// A person at the live page: the actions and looks that its tests share.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {setTimeout} from 'node:timers/promises';
import {serve, temporaryFolder, Visitor} from './support.mjs';

/** The server, a browser that draws in 3D and one that cannot, and that of them which is looked at. */
export let server, drawing, flat, visitor;
export const folder = temporaryFolder();
let serial = 0;

export async function open() {
  server = await serve(folder);
  drawing = await Visitor.start(server.address, {webgl: true});
  flat = await Visitor.start(server.address);
  visitor = flat;
}
export async function close() {
  for (const one of [drawing, flat]) await one?.close();
  server?.stop();
}
export const use = (one) => {
  visitor = one;
};

export const at = (id) => visitor.at(id);
export const api = async (path, body) =>
  (
    await fetch(
      `${server.address}/api/sessions${path}`,
      body && {method: 'POST', headers: {'Content-Type': 'application/json'}, body: JSON.stringify(body)},
    )
  ).json();
export const eventsOf = (path) =>
  readFileSync(path, 'utf8')
    .trimEnd()
    .split('\n')
    .map((line) => JSON.parse(line));
const try_again_ms = 20;
/** Waits until it holds. */
export async function until(holds, what, patience_ms = 30000) {
  for (const end = performance.now() + patience_ms; !(await holds()); await setTimeout(try_again_ms))
    assert.ok(performance.now() < end, what);
}
export const idOf = (page = visitor.page) => page.evaluate(() => window.continua.model.selection.live);
export const ready = () =>
  visitor.page.waitForFunction(
    () =>
      'ready' in document.body.dataset &&
      (document.querySelector('.stage.map') || window.continua.page.shown.place?.view.stage?.drawing),
  );

/** A session begun by the form. */
export async function begin(with_visitor, options = {}) {
  visitor = with_visitor;
  await visitor.visit('/live', options);
  await at('live-start').click();
  await ready();
}
/** A session begun with options that the form does not have. */
export async function beginWith(with_visitor, options) {
  visitor = with_visitor;
  const recorder = `secret ${++serial}`;
  const {id} = await api('', {clock: 'wall', scene: 'place_setting', machine: 'interaction', recorder, ...options});
  await visitor.visit('/live');
  await visitor.page.evaluate(([key, secret]) => sessionStorage.setItem(key, secret), [`recorder:${id}`, recorder]);
  await visitor.page.goto(`${server.address}/live/${id}`);
  await ready();
}

export const lines = (who, how) =>
  visitor.page
    .locator(`[data-testid=conversation] li[data-who=${who}][data-how=${how}]`)
    .filter({has: visitor.page.locator('a')});
/** Does this, and waits until the avatar has said that: `text` is its next utterance. */
export async function answered(act, text) {
  const said = lines('avatar', 'says');
  const before_n = await said.count();
  await act();
  await visitor.page.waitForFunction(
    ([n]) => document.querySelectorAll('[data-testid=conversation] li[data-who=avatar][data-how=says]').length > n,
    [before_n],
  );
  assert.equal(await said.nth(before_n).locator('.words').innerText(), `“${text}”`);
}
export const type = async (text) => {
  await at('talk').fill(text);
  await at('talk').press('Enter');
};
/** Where a point of the table is in the window. */
export const placeOf = (target) =>
  visitor.page.evaluate(([x, y]) => {
    const {view} = window.continua.page.shown.place;
    if (view.picture) {
      const {x: left, y: top} = new DOMPoint(x, -y).matrixTransform(view.picture.getScreenCTM());
      return [left, top];
    }
    const box = view.stage.canvas.getBoundingClientRect();
    const [left, top] = view.stage.drawing.project([x, y, 0]);
    return [box.left + left, box.top + top];
  }, target);
export const click = async (target) => visitor.page.mouse.click(...(await placeOf(target)));
/** Types, and clicks after the last of these words. */
export const typeAndClick = async (text, target) => {
  await at('talk').fill(text);
  await click(target);
  await at('click-chip').waitFor();
  await at('talk').press('Enter');
};
const acts = (program_text) =>
  lines('avatar', 'does').filter({has: visitor.page.locator(`a[title*=${JSON.stringify(program_text)}]`)});
export const asked = (program_text) => acts(program_text).waitFor();
export const done = (program_text) =>
  acts(program_text)
    .filter({has: visitor.page.locator('.status.done')})
    .waitFor();
