// A run as notebooks show it: the page in a frame of another page.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {existsSync, readdirSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {after, before, test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {program, root, temporaryFolder, Visitor} from './support.mjs';

const packages = join(dirname(program), 'python');
const module_folder = join(packages, 'continua');
if (!existsSync(module_folder) || !readdirSync(module_folder).some((name) => /^_engine.*\.so$/.test(name))) {
  console.log('skipped: the module of Python is not built');
  process.exit(77);
}

const folder = temporaryFolder();
let visitor;
before(async () => {
  const shown = execFileSync(
    '/usr/bin/python3',
    [
      '-c',
      'import sys, continua; print(continua.read(sys.argv[1])._repr_html_())',
      join(root, 'traces/paper/correction.physics.run.jsonl'),
    ],
    {encoding: 'utf8', maxBuffer: 2 ** 30, env: {...process.env, PYTHONPATH: packages}},
  );
  writeFileSync(join(folder, 'notebook.html'), `<!doctype html><title>Notebook</title><p>Output:</p>${shown}`);
  visitor = await Visitor.start(pathToFileURL(folder).href);
});
after(() => visitor?.close());

test('it shows the run and takes keys, and complains of nothing', async () => {
  await visitor.visit('/notebook.html', {offline: true, ready: 'iframe'});
  const inside = visitor.page.frameLocator('iframe');
  await inside.locator('[data-ready]').waitFor({state: 'attached'});
  assert.match(await inside.locator('[data-testid=panel-dialogue]').innerText(), /Put the white cup there/);
  const frame = visitor.page.frames()[1];
  const n = () => frame.evaluate(() => window.continua.model.selection.n);
  const first = await n();
  await inside.locator('[data-testid=panel-dialogue]').click();
  await visitor.page.keyboard.press('ArrowRight');
  await frame.waitForFunction((before) => window.continua.model.selection.n !== before, first);
  // The frame may not take the focus from the notebook.
  assert.deepEqual(
    visitor.complaints.filter((one) => !one.startsWith('Blocked autofocusing')),
    [],
  );
});
