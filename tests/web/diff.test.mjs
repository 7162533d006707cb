// From the start page to why two runs part, in a real browser.
import assert from 'node:assert/strict';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {numberOf, root, serve, Visitor} from './support.mjs';

const paper = join(root, 'traces/paper');
let server, visitor;
before(async () => {
  server = await serve(paper);
  visitor = await Visitor.start(server.address);
});
after(async () => {
  await visitor?.close();
  server?.stop();
});
const at = (id) => visitor.at(id);
const both = '/diff/disambiguation/disambiguation_exhausted';

test('three clicks from the start page to the cause', async () => {
  await visitor.visit('/');
  await visitor.page.getByLabel('Choose disambiguation to compare').check();
  assert.equal(await at('compare-chosen').innerText(), 'Choose one more');
  await visitor.page.getByLabel('Choose disambiguation_exhausted to compare').check();
  await at('compare-chosen').click();
  await visitor.page.waitForURL(/\/diff\//);
  await at('verdict').waitFor();
  assert.match(
    await at('verdict').innerText(),
    /^≠ They part at 0:05 \(B #\d+\): “No\.” \(speech at 0:05\) is only in B/,
  );
  assert.deepEqual(visitor.complaints, []);
});

test('a comparison opens at the first difference; n and p go on and back, and the address holds it', async () => {
  await visitor.visit(both);
  const told = await visitor.page.evaluate(() => ({
    first: window.continua.page.comparison.first,
    count: window.continua.page.comparison.hunks.length,
  }));
  assert.ok(told.count > 2);
  await visitor.addressSays('h', told.first);
  assert.equal(await visitor.page.locator('.hunk.current').count(), 1);
  await visitor.page.keyboard.press('n');
  await visitor.addressSays('h', told.first + 1);
  await visitor.page.keyboard.press('p');
  await visitor.addressSays('h', told.first);
  await visitor.page.goBack();
  await visitor.addressSays('h', told.first + 1);
  await visitor.visit(`${both}?h=1&n=22`);
  assert.equal(await visitor.page.locator('.hunk.current').count(), 1);
  assert.equal(await visitor.n(), 22);
});

test('things, gestures and programs are told in words, with the log’s own form on hover', async () => {
  await visitor.visit(both);
  const gesture = visitor.page.locator('.hunk .line', {hasText: 'gesture “no”'});
  assert.equal(await gesture.getAttribute('title'), 'negack stroke');
  for (const told of await visitor.page.locator('.hunk .line').allInnerTexts())
    if (/ (act|gesture|expect) /.test(told)) assert.doesNotMatch(told, /block\d/);
});

test('differences are told with what each run has, and why', async () => {
  await visitor.visit(both);
  const text = await at('panel-differences').innerText();
  assert.match(text, /\d+ differences/);
  assert.match(text, /another input/);
  assert.match(text, /−\s*in A\s*#\d+ input/);
  assert.match(text, /\+\s*in B\s*#\d+ input/);
});

test('lanes are doubled, and the graph tells whose way was whose', async () => {
  await visitor.visit(both);
  const rows = await visitor.page.evaluate(() =>
    window.continua.page.parts.lanes.rows.map(({name, side}) => `${side} ${name}`),
  );
  assert.equal(rows.filter((name) => name.startsWith('b ')).length, (rows.length - 1) / 2);
  assert.ok((await visitor.page.locator('.edge.only-a').count()) > 0);
  assert.ok((await visitor.page.locator('.edge.only-b').count()) > 0);
  assert.ok((await visitor.page.locator('.graph .count').allTextContents()).includes('A 0 B 1'));
});

test('both stacks are told in one form, their values with room for words', async () => {
  for (const width of [1280, 1440, 1920]) {
    await visitor.visit(`${both}?n=47`, {viewport: {width, height: 900}});
    await visitor.page.waitForSelector('[data-testid=panel-stack_b] .value', {state: 'attached'});
    const [a, b] = await visitor.page.evaluate(() =>
      ['stack', 'stack_b'].map((name) => {
        const panel = document.querySelector(`[data-testid=panel-${name}]`);
        const widths = [...panel.querySelectorAll('.value')].map((one) => one.clientWidth).filter((one) => one > 0);
        return {aside: getComputedStyle(panel.querySelector('.heads')).display, least: Math.min(...widths)};
      }),
    );
    assert.equal(a.aside, b.aside, `${width} px`);
    assert.ok(Math.min(a.least, b.least) >= 140, `${width} px: ${a.least}, ${b.least}`);
  }
});

test('B stands by meaning or by its own times, with a ruler, and the address holds which', async () => {
  const begins = () =>
    visitor.page.evaluate(() => {
      const {rows} = window.continua.page.parts.lanes;
      const {side} = window.continua.page.comparison;
      const speech = rows.find((row) => row.side === 'b' && row.colour === 'human');
      return {shown: [...speech.lane.from], own: [...side.data.lanes.speech.from], ruler: rows[0].time(8)};
    });
  await visitor.visit('/diff/correction/disambiguation');
  const by_meaning = await begins();
  await at('by-time').check();
  await visitor.addressSays('by', 'time');
  const by_time = await begins();
  assert.deepEqual(by_time.shown, by_time.own);
  assert.equal(by_time.ruler, 8);
  assert.equal(by_meaning.shown.length, by_time.shown.length);
  await visitor.page.reload();
  await at('by-time').waitFor();
  assert.ok(await at('by-time').isChecked());
});

test('the dialogues of both stand side by side, each with its times, and what one alone has is told', async () => {
  await visitor.visit(both);
  const rows = at('pair');
  await visitor.page.waitForFunction(() => /“No\./.test(document.querySelector('.pairs').textContent));
  const same = await rows
    .filter({hasNot: visitor.page.locator('.differs-here')})
    .first()
    .innerText();
  assert.match(same, /\d:\d\d\.\d[\s\S]*\d:\d\d\.\d/);
  const only_b = rows.filter({has: visitor.page.locator('.cell-a.none')}).first();
  assert.match(await only_b.innerText(), /“No\.”/);
  await only_b.locator('button').click();
  assert.equal(await visitor.page.locator('.pairs li.current').count(), 1);
});

test('changed words are marked inside the sentence', async () => {
  await visitor.visit('/r/disambiguation');
  const said = await visitor.page.evaluate(() => window.continua.page.data.lanes.speech.n[0]);
  await visitor.visit(`/r/disambiguation?n=${said}`);
  await at('what-if-open').click();
  await at('what-if').locator('summary').click();
  const text = await at('what-if-event').inputValue();
  const words = JSON.parse(text).text;
  await at('what-if-event').fill(text.replace(words, words.replace(/\w+(\W*)$/, 'plate$1')));
  await at('what-if-run').click();
  await visitor.page.waitForURL(/\/diff\//);
  await at('cause').waitFor();
  await visitor.page.waitForFunction(() => document.querySelectorAll('.pairs mark').length > 1);
  assert.match(await visitor.page.locator('.pairs .cell-b mark').first().innerText(), /plate/);
});

test('the whole cause is on top of the differences, and the end of both runs below it', async () => {
  for (const viewport of [
    {width: 1280, height: 720},
    {width: 1440, height: 900},
  ]) {
    await visitor.visit(both, {viewport});
    const {cut, top, scrolled} = await at('cause').evaluate((one) => ({
      cut: one.scrollHeight > one.clientHeight + 1 || one.scrollWidth > one.clientWidth + 1,
      top: one.getBoundingClientRect().top - one.parentElement.getBoundingClientRect().top,
      scrolled: one.parentElement.scrollTop,
    }));
    assert.deepEqual({cut, scrolled, near: top < 20}, {cut: false, scrolled: 0, near: true});
    assert.match(await at('ending').innerText(), /^In the end/);
  }
});

for (const colorScheme of ['light', 'dark'])
  test(`the cause and the end of both runs are in sight at 1280 × 720, ${colorScheme}`, async () => {
    for (const [a, b] of [
      ['disambiguation', 'disambiguation_exhausted'],
      ['correction', 'disambiguation'],
      ['correction', 'correction.physics'],
      ['dialogue_gesture', 'dialogue_language'],
    ]) {
      await visitor.visit(`/diff/${a}/${b}`, {viewport: {width: 1280, height: 720}, colorScheme});
      await visitor.page.evaluate(() => window.continua.page.settled());
      for (const part of ['cause', 'ending']) {
        const place = await at(part).evaluate((one) => {
          const [own, body] = [one, one.closest('.body')].map((each) => each.getBoundingClientRect());
          const whole = one.scrollHeight <= one.clientHeight + 1 && one.scrollWidth <= one.clientWidth + 1;
          const seen = own.height > 0 && own.top >= body.top && own.bottom <= Math.min(body.bottom, innerHeight);
          return {whole, seen, own: own.toJSON(), body: body.toJSON()};
        });
        assert.ok(place.whole && place.seen, `${part} of ${a} and ${b}: ${JSON.stringify(place)}`);
      }
    }
  });

test('the stacks of both stand side by side, and what differs is marked', async () => {
  const parted = numberOf('paper/disambiguation', ({kind, t}) => kind === 'memory' && t > 6);
  await visitor.visit(`${both}?n=${parted}`);
  assert.ok(await at('panel-stack').isVisible());
  assert.ok(await at('panel-stack_b').isVisible());
  for (const panel of ['stack', 'stack_b'])
    assert.ok((await at(`panel-${panel}`).locator('.cell.differs').count()) > 0, panel);
});

test('where the runs meet again is told with the time of each', async () => {
  await visitor.visit('/diff/correction/correction.physics');
  const {own, other, sentence} = await visitor.page.evaluate(() => {
    const {own: a, side, told} = window.continua.page.comparison;
    return {own: a.t[told.meet.a], other: side.data.t[told.meet.b], sentence: told.sentence};
  });
  const clock = (t) => visitor.page.evaluate(async (s) => (await import('/dom.js')).clock(s, 2), t);
  assert.notEqual(own, other);
  const told = await visitor.page.locator('.meet').innerText();
  assert.ok(told.endsWith(`at ${await clock(own)} in A and ${await clock(other)} in B`), told);
  for (const t of [own, other])
    assert.match(sentence, new RegExp(`meet again.*${String(+t.toFixed(2)).replace('.', '\\.')}`));
});

test('the comparison can be copied as Markdown', async () => {
  await visitor.visit(both);
  await visitor.context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await at('markdown').click();
  await visitor.page.waitForFunction(() => /Copied/.test(document.querySelector('[data-testid=markdown]').textContent));
  assert.match(await visitor.page.evaluate(() => navigator.clipboard.readText()), /^\*\*They part at 0:05/);
});

test('the same run twice is the same', async () => {
  await visitor.visit('/diff/correction/correction');
  assert.match(await at('verdict').innerText(), /^= /);
  assert.match(await at('panel-differences').innerText(), /Nothing that happened differs/);
  await visitor.page.keyboard.press('n');
  assert.deepEqual(visitor.complaints, []);
});

test('physics beside the kinematic world', async () => {
  await visitor.visit('/diff/correction/correction.physics');
  assert.match(await at('verdict').innerText(), /world/);
  await visitor.page.keyboard.press('n');
  await visitor.page.keyboard.press('n');
  assert.deepEqual(visitor.complaints, []);
});

test('a run is compared with another from its own page', async () => {
  await visitor.visit('/r/disambiguation');
  await visitor.page.keyboard.press('c');
  await at('compare-dialog').waitFor();
  await visitor.page.keyboard.type('exhausted');
  await visitor.page.locator('[data-testid=compare-with]', {hasText: 'disambiguation_exhausted'}).first().click();
  await visitor.page.waitForURL(/\/diff\/disambiguation\/disambiguation_exhausted/);
});

test('what cannot be compared says so', async () => {
  await visitor.visit('/diff/correction/none');
  assert.match(await at('problem').innerText(), /no run 'none'/);
});

for (const colorScheme of ['light', 'dark'])
  test(`nothing stands in the way of access to a comparison, ${colorScheme}`, async () => {
    await visitor.visit(both, {colorScheme, bypassCSP: true});
    assert.deepEqual(await visitor.violations(), []);
  });
