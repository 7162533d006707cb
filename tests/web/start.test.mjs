// The start page, notes, and a run that is still being written, in a real browser.
import assert from 'node:assert/strict';
import {appendFileSync, existsSync, mkdirSync, readFileSync, utimesSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import {at, folder, listed, serveFolder, server, visitor} from './served.mjs';
import {guestOf, logOf, root, temporaryFolder} from './support.mjs';

const lines = logOf('paper/disambiguation').split('\n').filter(Boolean);
serveFolder(() => {
  mkdirSync(join(folder, 'older'));
  for (const name of ['correction', 'disambiguation'])
    writeFileSync(join(folder, `${name}.run.jsonl`), logOf(`paper/${name}`));
  writeFileSync(join(folder, 'older/one_breath.run.jsonl'), logOf('paper/one_breath'));
  utimesSync(join(folder, 'older/one_breath.run.jsonl'), 1e9, 1e9);
  writeFileSync(join(folder, 'cut.run.jsonl'), `${lines.slice(0, 20).join('\n')}\n`);
  utimesSync(join(folder, 'cut.run.jsonl'), 1.1e9, 1.1e9);
  writeFileSync(join(folder, 'garbage.run.jsonl'), 'hello\n');
});
const names = () => visitor.page.locator('.start .name').allInnerTexts();

test('all runs, the newest first, with verdict, length, machine, scene and picture', async () => {
  await visitor.visit('/');
  await listed();
  const found = await names();
  assert.equal(found.length, 5);
  assert.ok(found.indexOf('older/one_breath') === 4 && found.indexOf('cut') === 3, found.join());
  const row = (name) => visitor.page.locator('[data-testid=run]', {has: visitor.page.locator(`text="${name}"`)});
  assert.match(await row('correction').innerText(), /✔ as expected[\s\S]*0:40[\s\S]*interaction[\s\S]*today/);
  assert.match(await row('cut').innerText(), /! cut short[\s\S]*2004/);
  assert.match(await row('garbage').innerText(), /not a run log/);
});

test('the small picture of a run shows all that was drawn', async (t) => {
  await visitor.visit('/');
  await listed();
  const picture = visitor.page.locator('.thumbnail').first();
  await visitor.page.waitForFunction(() => {
    const first = document.querySelector('.thumbnail');
    return !first || first.naturalWidth > 0;
  });
  if (!(await picture.count())) return t.skip('nothing can be drawn on this machine');
  const [drawn, shown, part] = await picture.evaluate((image) => [
    image.naturalWidth / image.naturalHeight,
    image.clientWidth / image.clientHeight,
    getComputedStyle(image).objectViewBox ?? 'none',
  ]);
  assert.ok(Math.abs(drawn - shown) < 0.02, `drawn ${drawn}, shown ${shown}`);
  assert.equal(part, 'none');
});

test('search narrows the list and is part of the address', async () => {
  await visitor.visit('/');
  await listed();
  await visitor.page.keyboard.press('/');
  await visitor.page.keyboard.type('one_breath');
  await visitor.page.waitForFunction(() => document.querySelectorAll('[data-testid=run]').length === 1);
  await visitor.addressSays('q', 'one_breath');
  await visitor.visit('/?q=cut');
  await listed();
  assert.deepEqual(await names(), ['cut']);
  await visitor.page.click('a.name >> text=cut');
  await at('trouble').waitFor();
  await visitor.page.goBack();
  await at('runs').waitFor();
  assert.equal(await at('search').inputValue(), 'cut');
});

test('no runs: it says how to make one', async (t) => {
  const empty = temporaryFolder();
  const guest = await guestOf(t, empty);
  await guest.visit('/');
  assert.match(
    await guest.at('no-runs').innerText(),
    /Talk to the avatar[\s\S]*Drop a run log[\s\S]*continua replay TRACE/,
  );
});

test('a note is kept beside the run, shown again, and taken away', async () => {
  await visitor.visit('/r/correction?n=45');
  await visitor.page.keyboard.press('m');
  await visitor.page.keyboard.type('Here <b>it</b> takes the blue cup.');
  await visitor.page.keyboard.press('Control+Enter');
  await at('note').waitFor();
  const kept = JSON.parse(readFileSync(join(folder, 'correction.notes.json'), 'utf8'));
  assert.deepEqual(
    kept.notes.map(({n, to, text}) => ({n, to, text})),
    [{n: 45, to: null, text: 'Here <b>it</b> takes the blue cup.'}],
  );
  await visitor.visit('/r/correction?n=0&tab=notes');
  assert.match(await at('note').innerText(), /#45[\s\S]*Here <b>it<\/b> takes/);
  await at('note').locator('button.link').click();
  assert.equal(await visitor.n(), 45);
  await at('note-from').click();
  await visitor.page.keyboard.press('End');
  await at('note-text').fill('all of the end');
  await at('note-add').click();
  await visitor.page.waitForFunction(() => document.querySelectorAll('[data-testid=note]').length === 2);
  assert.match(await at('note').nth(1).innerText(), /#45 – #\d+/);
  await at('note').first().locator('.remove').click();
  await visitor.page.waitForFunction(() => document.querySelectorAll('[data-testid=note]').length === 1);
  assert.deepEqual(visitor.complaints, []);
});

test('a run that is being written is live: it grows, and the cursor goes along at its end', async () => {
  const path = join(folder, 'growing.run.jsonl');
  writeFileSync(path, `${lines.slice(0, 20).join('\n')}\n`);
  await visitor.visit('/r/growing');
  await at('live').waitFor();
  await visitor.page.keyboard.press('End');
  await visitor.page.evaluate(() => window.continua.cursor.jump(window.continua.page.data.stops.at(-1)));
  const before_n = await visitor.n();
  await visitor.page.evaluate(() => {
    window.first_scene = window.continua.page.parts.scene;
  });
  appendFileSync(path, `${lines.slice(20, 40).join('\n')}\n`);
  await visitor.page.waitForFunction((n) => window.continua.model.selection.n > n, before_n);
  appendFileSync(path, `${lines.slice(40).join('\n')}\n`);
  await visitor.page.waitForFunction((size) => window.continua.page.data.size === size, lines.length);
  assert.ok(
    await visitor.page.evaluate(
      () => window.first_scene === window.continua.page.parts.scene && document.contains(window.first_scene.element),
    ),
    'the scene stays',
  );
  await visitor.page.waitForFunction(() => document.querySelector('[data-testid=live]').hidden);
  assert.deepEqual(visitor.complaints, []);
});

for (const colorScheme of ['light', 'dark'])
  test(`nothing stands in the way of access to the start page, ${colorScheme}`, async () => {
    await visitor.visit('/', {colorScheme, bypassCSP: true});
    await listed();
    assert.deepEqual(await visitor.violations(), []);
  });

test('on a phone the start page and a run can be read', async () => {
  for (const path of ['/', '/r/correction', '/diff/correction/disambiguation']) {
    await visitor.visit(path, {viewport: {width: 390, height: 780}});
    assert.ok(
      await visitor.page.evaluate(() => document.documentElement.scrollWidth <= innerWidth),
      `${path} is too wide`,
    );
    assert.equal(await visitor.page.evaluate(() => scrollY), 0, `${path} begins at its top`);
  }
});

test('a trace or a log that is dropped on the page, or chosen, is opened', async () => {
  const dropped = async (name, content) => {
    await visitor.visit('/');
    await listed();
    const data = await visitor.page.evaluateHandle(
      ([file, text]) => {
        const transfer = new DataTransfer();
        transfer.items.add(new File([text], file));
        return transfer;
      },
      [name, content],
    );
    await visitor.page.dispatchEvent('main.start', 'dragenter', {dataTransfer: data});
    assert.ok(await visitor.page.locator('main.start').evaluate((main) => main.classList.contains('dropping')));
    await visitor.page.dispatchEvent('main.start', 'drop', {dataTransfer: data});
  };
  const trace = readFileSync(join(root, 'traces/paper/one_breath.trace.jsonl'), 'utf8');
  await dropped('../my talk.trace.jsonl', trace);
  await visitor.page.waitForURL(/\/r\/my_talk$|\/r\/my_talk\?/);
  await at('verdict').waitFor();

  // More than the server takes at a time: blank lines count for nothing.
  const large = trace + '\n'.repeat(2 ** 20);
  await visitor.visit('/');
  await listed();
  await at('drop-file').setInputFiles({name: 'large.trace.jsonl', mimeType: '', buffer: Buffer.from(large)});
  await visitor.page.waitForURL(/\/r\/large/);
  await at('verdict').waitFor();

  await dropped('a_log.run.jsonl', logOf('paper/correction'));
  await visitor.page.waitForURL(/\/r\/a_log/);
  await at('verdict').waitFor();

  await dropped('notes.txt', 'hello');
  await visitor.page.waitForFunction(() =>
    document.querySelector('[data-testid=drop-said]').textContent.includes('cannot'),
  );
  assert.match(await at('drop-said').innerText(), /no run log and no trace/);

  // A trace may not make the server read a file.
  const outside = trace.replace(/"scene": ?"[^"]*"/, '"scene":"../../etc/passwd.xml"');
  assert.notEqual(outside, trace);
  await dropped('outside.trace.jsonl', outside);
  await visitor.page.waitForFunction(() => /own/.test(document.querySelector('[data-testid=drop-said]').textContent));
  assert.match(await at('drop-said').innerText(), /its scene is .*passwd.*one of the program's own/);
});

test('of very many runs those near the window are there, and the arrows reach all', async (t) => {
  const many = temporaryFolder();
  const one = logOf('paper/special_dpda');
  for (let i = 0; i < 300; ++i) writeFileSync(join(many, `run_${String(i).padStart(3, '0')}.run.jsonl`), one);
  const guest = await guestOf(t, many);
  await guest.visit('/');
  await guest.page.waitForFunction(() => !/being read/.test(document.body.innerText));
  await guest.page.waitForFunction(() => /300 recorded runs/.test(document.body.innerText));
  const there = () => guest.page.locator('[data-testid=run]').count();
  assert.ok((await there()) <= 80, `${await there()} rows`);
  const box = '.start';
  await guest.page.locator(box).evaluate((main) => {
    main.scrollTop = main.scrollHeight;
  });
  await guest.page.locator('[data-testid=run]').last().waitFor();
  await guest.page.waitForFunction(
    () =>
      document.querySelectorAll('a.name').length &&
      [...document.querySelectorAll('a.name')].at(-1).getBoundingClientRect().top < innerHeight,
  );
  assert.ok((await there()) <= 120, `${await there()} rows`);
  await guest.page.locator(box).evaluate((main) => {
    main.scrollTop = 0;
  });
  await guest.page.waitForFunction(() => {
    const {top} = document.querySelector('a.name').getBoundingClientRect();
    return top > 0 && top < innerHeight;
  });
  await guest.page.locator('a.name').first().focus();
  const reached = new Set();
  for (let i = 0; i < 100; ++i) {
    reached.add(await guest.page.evaluate(() => document.activeElement.textContent));
    await guest.page.keyboard.press('ArrowDown');
  }
  assert.equal(reached.size, 100);
});
