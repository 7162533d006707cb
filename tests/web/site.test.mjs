// Many runs as a folder of files, opened from the disk.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdirSync, readdirSync, readFileSync, statSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {logOf, program, root, temporaryFolder, Visitor} from './support.mjs';

const folder = temporaryFolder();
const runs = ['disambiguation', 'correction', 'one_breath'].map((run) => join(root, `traces/paper/${run}.run.jsonl`));
const exportSite = (to, ...more) => execFileSync(program, ['export', ...more, '--to', 'site', '-o', join(folder, to)]);
const sizeOf = (path) =>
  readdirSync(path, {recursive: true, withFileTypes: true})
    .filter((entry) => entry.isFile())
    .reduce((sum, entry) => sum + statSync(join(entry.parentPath ?? entry.path, entry.name)).size, 0);
let visitor;
before(async () => {
  exportSite('site', ...runs, join(root, 'traces/paper/correction.physics.run.jsonl'));
  visitor = await Visitor.start(pathToFileURL(folder).href, {webgl: true});
});
after(() => visitor?.close());
const at = (id) => visitor.at(id);
const listed = () => visitor.page.locator('.start .name').allInnerTexts();
const page = '/site/index.html';

test('the start page lists the runs, and a run and its comparison are opened from it', async () => {
  await visitor.visit(page, {offline: true});
  assert.equal(await at('run').count(), 4);
  assert.match(await at('run').first().innerText(), /disambiguation[\s\S]*✔ as expected[\s\S]*interaction/);
  assert.equal(await at('comparison').count(), 1);
  assert.match(await at('comparison').innerText(), /correction and correction\.physics ≠ .*world/);
  await visitor.page.click('text="disambiguation"');
  await at('verdict').waitFor();
  assert.match(await at('panel-dialogue').innerText(), /Which block do you mean/);
  for (const name of ['graph', 'scene', 'lanes', 'stack', 'derivation', 'why'])
    assert.ok(await at(`panel-${name}`).isVisible(), name);
  await visitor.page.waitForFunction(() => window.continua.page.parts.scene.stage.drawing !== null);
  assert.equal(await at('what-if-open').count(), 0);
  await visitor.page.goBack();
  await at('comparison').locator('a').click();
  await at('panel-differences').waitFor();
  assert.match(await at('verdict').innerText(), /world/);
  await visitor.page.click('a.brand');
  await at('comparison').waitFor();
  assert.deepEqual(visitor.complaints, []);
});

test('a search looks through all that was said, and leads to it', async () => {
  await visitor.visit(page);
  await visitor.page.keyboard.press('/');
  await visitor.page.keyboard.type('white there');
  await visitor.page.waitForFunction(() => document.querySelectorAll('[data-testid=run]').length < 4);
  assert.deepEqual(await at('found').first().innerText(), '“Put the white cup there.”');
  await at('found').first().locator('a').click();
  await at('verdict').waitFor();
  const said = await visitor.page.evaluate(() => window.continua.page.data.kind(window.continua.model.selection.n));
  assert.equal(said, 'input');
  await visitor.visit(`${page}#/?q=physics`);
  assert.ok((await listed()).every((name) => /physics/.test(name)));
});

test('runs are compared in either order where their comparison is there, and only there', async () => {
  await visitor.visit(page);
  const choose = (run) => visitor.page.getByLabel(`Choose ${run} to compare`, {exact: true}).check();
  await choose('correction');
  await choose('one_breath');
  assert.equal(await at('compare-chosen').innerText(), 'Not compared here');
  await visitor.visit(page);
  await choose('correction.physics');
  await choose('correction');
  await at('compare-chosen').click();
  await at('panel-differences').waitFor();
  await visitor.visit(`${page}#/r/correction.physics`);
  await at('compare').click();
  await at('compare-with').first().waitFor();
  assert.deepEqual(
    (await at('compare-with').allInnerTexts()).map((text) => text.split(' ')[0]),
    ['correction'],
  );
});

test('an address of nothing says so', async () => {
  await visitor.visit(`${page}#/r/none`);
  assert.match(await at('problem').innerText(), /no runs\/none/);
  await visitor.page.click('text="All runs"');
  await at('runs').waitFor();
});

test('pairs given are those compared', async () => {
  exportSite('pairs', ...runs, '--compare', runs[0], 'one_breath');
  await visitor.visit('/pairs/index.html');
  assert.match(await at('comparison').allInnerTexts().then(String), /^disambiguation and one_breath ≠ /);
});

test('100 runs would take less than 50 MB: documents and page are there once', async () => {
  const many = join(folder, 'many');
  mkdirSync(many);
  const logs = runs.map((run) => logOf(run.slice(join(root, 'traces/').length, -'.run.jsonl'.length)));
  const count = 9;
  for (let i = 0; i < count; ++i) writeFileSync(join(many, `participant_${i}.run.jsonl`), logs[i % logs.length]);
  exportSite('nine', many);
  const of = (part) => sizeOf(join(folder, 'nine', part));
  const each = (of('runs') + of('diffs')) / count;
  assert.ok(of('') - of('runs') - of('diffs') + 100 * each < 50e6, `${each} bytes for each run`);
  assert.ok(of('documents') < 300e3, `${of('documents')} bytes of documents`);
  await visitor.visit('/nine/index.html');
  assert.equal(await at('run').count(), count);
  assert.equal(await at('comparison').count(), count - logs.length);
});

test('the same runs give the same bytes', () => {
  const again = join(folder, 'again');
  exportSite('again', ...runs, join(root, 'traces/paper/correction.physics.run.jsonl'));
  for (const entry of readdirSync(again, {recursive: true}))
    if (statSync(join(again, entry)).isFile())
      assert.ok(readFileSync(join(again, entry)).equals(readFileSync(join(folder, 'site', entry))), entry);
});

for (const colorScheme of ['light', 'dark'])
  test(`nothing stands in the way of access, ${colorScheme}`, async () => {
    for (const address of ['', '#/?q=cup', '#/r/correction', '#/diff/correction/correction.physics']) {
      await visitor.visit(page + address, {colorScheme, bypassCSP: true});
      assert.deepEqual(await visitor.violations(), [], address);
    }
  });
