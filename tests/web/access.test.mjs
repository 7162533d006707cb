// Nothing stands in the way of access: axe, with targets of 24 px, on all pages and dialogs, on a desk (light and dark), on
// a phone and at 200 %.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {roundsLog} from './logs.mjs';
import {logOf, program, root, serve, temporaryFolder, Visitor} from './support.mjs';

const sizes = {
  'on a desk': {viewport: {width: 1280, height: 720}},
  'on a phone': {viewport: {width: 390, height: 844}, hasTouch: true},
  'at 200 %': {viewport: {width: 640, height: 360}, deviceScaleFactor: 2},
};
// Colours alone differ in the dark, and those of a page are the same at each size.
const rules = {'target-size': {enabled: true}};
const schemes = {
  'on a desk': {light: {rules}, dark: {runOnly: ['color-contrast']}},
  other: {light: {rules: {...rules, 'color-contrast': {enabled: false}}}},
};
const folder = temporaryFolder();
let server, visitor, disk;
before(async () => {
  for (const name of ['correction', 'one_breath', 'special_npda'])
    writeFileSync(join(folder, `${name}.run.jsonl`), logOf(`paper/${name}`));
  writeFileSync(join(folder, 'rounds.run.jsonl'), roundsLog());
  writeFileSync(join(folder, 'failing.run.jsonl'), roundsLog({fails: true}));
  const exporting = (...words) => execFileSync(program, ['export', ...words]);
  exporting(join(folder, 'correction.run.jsonl'), '--to', 'html', '-o', join(folder, 'correction.html'));
  const runs = ['correction', 'one_breath'].map((name) => join(folder, `${name}.run.jsonl`));
  exporting(...runs, '--to', 'site', '-o', join(folder, 'site'), '--compare', 'correction', 'one_breath');
  server = await serve(folder);
  visitor = await Visitor.start(server.address);
  disk = await Visitor.start(pathToFileURL(folder).href);
});
after(async () => {
  for (const one of [visitor, disk]) await one?.close();
  server?.stop();
});

const tabs = (run, names) => names.map((name) => `${run}?n=40&tab=${name}`);
const served = [
  '/',
  '/?q=nothing_like_it',
  '/nowhere',
  '/r/rounds',
  '/r/failing',
  ...tabs('/r/correction', ['why', 'account', 'records', 'notes']),
  ...['graph', 'stack', 'derivation', 'lanes', 'dialogue'].map((name) => `/r/correction?n=40&panel=${name}`),
  '/r/special_npda?n=5&tab=branches',
  '/diff/correction/one_breath',
  '/live',
];
const press = (key) => (page) => page.keyboard.press(key);
/** [what is looked at, the page, how to get there from it]. */
const further = [
  ['the keys', '/r/correction?n=40', press('?')],
  ['the keys of the start page', '/', press('?')],
  ['the palette', '/r/correction?n=40', press('#')],
  ['the choice of a run to compare', '/r/correction?n=40', press('c')],
  ['what if', '/r/correction?n=40', press('x')],
  ['a selected stretch', '/r/rounds', () => visitor.selectStretch()],
  ['a session', '/live', beginSession],
  [
    'an ended session',
    '/live',
    async (page) => {
      await beginSession(page);
      await visitor.at('live-end').click();
      await visitor.at('live-summary').waitFor();
    },
  ],
];
async function beginSession(page) {
  await visitor.at('live-start').click();
  await page.waitForFunction(() => document.querySelector('.stage.map'));
  await visitor.at('talk').fill('The plate.');
  await visitor.at('talk').press('Enter');
  await page.locator('[data-testid=conversation] li[data-who=avatar]').first().waitFor();
  await visitor.at('live-machine-button').click();
}
const exported = ['/correction.html', '/site/index.html', '/site/index.html#/diff/correction/one_breath'];

/** All details are opened: what they hide is looked at too. */
const openAll = (page) => page.evaluate(() => document.querySelectorAll('details').forEach((one) => (one.open = true)));

async function look(browser, page, looks) {
  await openAll(page);
  for (const [colorScheme, looked] of Object.entries(looks)) {
    await page.emulateMedia({colorScheme});
    await page.waitForFunction(() => document.getAnimations().every((one) => !(one instanceof CSSTransition)));
    assert.deepEqual(await browser.violations(looked), [], colorScheme);
  }
}

for (const [size, options] of Object.entries(sizes)) {
  for (const [browser, paths] of [
    [() => visitor, served],
    [() => disk, exported],
  ])
    for (const path of paths)
      test(`${path} ${size}`, async () => {
        const page = await browser().visit(path, {...options, bypassCSP: true});
        await look(browser(), page, schemes[size] ?? schemes.other);
      });
  for (const [name, path, reach] of further)
    test(`${name}, ${size}`, async () => {
      const page = await visitor.visit(path, {...options, bypassCSP: true});
      await reach(page);
      await look(visitor, page, schemes[size] ?? schemes.other);
    });
}
