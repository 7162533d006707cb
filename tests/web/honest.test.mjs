// The page tells how a run went, when, and how often, in one way everywhere; and nothing is cut, hidden or lost on the way.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import {roundsLog} from './logs.mjs';
import {at, folder, listed, serveFolder, server, visitor} from './served.mjs';
import {logOf, numberOf, program, recordsOf, root} from './support.mjs';

const long_name = 'a_run_with_a_long_name_that_nobody_broke_into_words_and_that_goes_on';
serveFolder(() => {
  mkdirSync(join(folder, 'older'));
  writeFileSync(join(folder, 'rounds.run.jsonl'), roundsLog());
  writeFileSync(join(folder, 'failing.run.jsonl'), roundsLog({fails: true}));
  writeFileSync(join(folder, 'worst.run.jsonl'), roundsLog({worst: true}));
  writeFileSync(join(folder, `older/${long_name}.run.jsonl`), roundsLog());
  for (const name of ['correction', 'dialogue_gesture', 'special_dpda', 'disambiguation', 'disambiguation_exhausted'])
    writeFileSync(join(folder, `${name}.run.jsonl`), logOf(`paper/${name}`));
  writeFileSync(join(folder, 'wizard.run.jsonl'), logOf('talk/wizard'));
});
const evaluate = (...given) => visitor.page.evaluate(...given);

test('a failed act is told in red on both pages, opened at, and stopped at', async () => {
  await visitor.visit('/');
  await listed();
  const row = visitor.page.locator('[data-testid=run]', {has: visitor.page.locator('text="failing"')});
  assert.match(await row.innerText(), /✘ 2 of 3 acts done/);
  assert.equal(await row.locator('.badge.bad').count(), 1);
  await visitor.visit('/r/failing');
  assert.match(await at('verdict').innerText(), /^✘ 2 of 3 acts done: block1 is in the way, 3 utterances/);
  assert.ok(await at('verdict').evaluate((one) => one.classList.contains('bad')));
  const failed = await visitor.n();
  assert.match(await at('panel-why').innerText(), /blocked/);
  await visitor.page.keyboard.press('Home');
  await visitor.page.keyboard.press('n');
  assert.equal(await visitor.n(), failed);
});

for (const colorScheme of ['light', 'dark'])
  for (const run of ['worst', 'failing', 'wizard'])
    test(`the verdict of ${run} is whole at 1280 × 720, ${colorScheme}`, async () => {
      await visitor.visit(`/r/${run}`, {colorScheme});
      const told = await at('verdict').evaluate((one) => {
        const range = document.createRange();
        range.selectNodeContents(one);
        const [text, top] = [range, one.closest('header')].map((each) => each.getBoundingClientRect());
        return {
          text: one.innerText,
          within: text.left >= top.left && text.right <= top.right && text.top >= top.top && text.bottom <= top.bottom,
          cut: one.scrollWidth > one.clientWidth || one.scrollHeight > one.clientHeight,
          fits: document.documentElement.scrollHeight <= innerHeight,
        };
      });
      assert.deepEqual({...told, text: ''}, {text: '', within: true, cut: false, fits: true}, told.text);
      if (run === 'worst')
        assert.match(
          told.text,
          /2 of 2 expectations not met: the avatar does “puts the green block on the red block”, found “takes the green block”; the avatar says “Which block\?”, found “Which block do you mean\?”, 0 of 3 acts done: /,
        );
    });

test('answers that were recorded otherwise are counted, marked and stopped at', async () => {
  const told = execFileSync(program, ['score', join(root, 'traces/talk/wizard.trace.jsonl'), '--json'], {
    encoding: 'utf8',
  });
  const {speaking, lax} = JSON.parse(told).traces[0];
  await visitor.visit('/r/wizard');
  assert.match(await at('verdict').innerText(), new RegExp(`as recorded: ${lax} of ${speaking} answers`));
  await visitor.page.keyboard.press('Home');
  await visitor.page.keyboard.press('n');
  const missed = recordsOf('talk/wizard')[await visitor.n()];
  assert.equal(missed.kind, 'observed');
  await visitor.page.waitForFunction(() =>
    /as recorded: “Which cup/.test(document.querySelector('[data-testid=panel-dialogue]').innerText),
  );
  await visitor.page.waitForFunction(() =>
    /the observed avatar says “Which cup/.test(document.querySelector('[data-testid=panel-why]').innerText),
  );
  const {misses} = (await (await visitor.page.request.get(`${visitor.address}/api/runs/wizard`)).json()).as_observed;
  assert.deepEqual(misses, await evaluate(() => Array.from(window.continua.page.data.lanes.flag.n)));
});

test('counts are those of the command line', async () => {
  await visitor.visit('/r/rounds');
  assert.match(await at('verdict').innerText(), /^✔ 3 utterances, 3 of 3 acts done, 1 input refused/);
  const {size} = await evaluate(() => ({size: window.continua.page.data.size}));
  assert.ok((await at('position').innerText()).includes(`of ${size.toLocaleString('en')}`));
  // A transition that leaves several states is one, as `validate` counts.
  await visitor.visit('/r/dialogue_gesture');
  const ids = new Set(
    recordsOf('paper/dialogue_gesture')[0]
      .graph.edges.filter((one) => !one.diverted)
      .map(({id}) => id),
  );
  assert.match(await at('graph-count').innerText(), new RegExp(`of ${ids.size} transitions`));
});

test('a time is told in one form, rounded before it is cut', async () => {
  await visitor.visit('/r/rounds');
  const times = await evaluate(async () => {
    const {clock, instant} = await import('/dom.js');
    return [clock(32.99969), instant(32.99969), instant(185.0214), clock(59.9996), clock(61.25, 2)];
  });
  assert.deepEqual(times, ['0:33', '0:33.000', '3:05.021', '1:00', '1:01.25']);
});

test('an instant leads to the nearest record worth stopping at', async () => {
  await visitor.visit('/r/rounds');
  await at('position').click();
  await at('go-to').fill('0:07'); // in the middle of the poses
  await at('go-to').press('Enter');
  assert.ok(await evaluate(() => window.continua.page.data.stops.includes(window.continua.model.selection.n)));
  assert.match(await at('panel-why').innerText(), /Which block\?/);
});

test('the dialogue keeps its place while another panel fills the page', async () => {
  await visitor.visit('/r/dialogue_gesture', {viewport: {width: 1280, height: 640}});
  await visitor.page.keyboard.press('End');
  await visitor.page.keyboard.press('ArrowLeft');
  const inSight = () =>
    evaluate(() => {
      const list = document.querySelector('.moves').getBoundingClientRect();
      const row = document.querySelector('.moves li.current').getBoundingClientRect();
      return list.height > 0 && row.top >= list.top - 1 && row.bottom <= list.bottom + 1;
    });
  assert.ok(await inSight());
  for (const key of ['3', '3', 'Escape']) await visitor.page.keyboard.press(key);
  await visitor.page.waitForTimeout(100);
  assert.ok(await inSight());
});

test('refusals that follow one another are one line that opens', async () => {
  const moves = recordsOf('paper/dialogue_gesture').filter(({kind}) => kind === 'refusal');
  await visitor.visit(`/r/dialogue_gesture?n=${moves[0]?.n ?? 0}`);
  for (const line of await visitor.page.locator('.moves details.folded').all())
    assert.match(await line.innerText(), /^\d+ inputs refused/);
});

const overlaps = () =>
  evaluate(() => {
    const boxes = (selector) => [...document.querySelectorAll(selector)].map((one) => one.getBoundingClientRect());
    const meet = (a, b) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1;
    const counts = boxes('.graph .count');
    const struck = [...document.querySelectorAll('.graph .count[data-edge]')].filter((one) => {
      const {left, right, top, bottom} = one.getBoundingClientRect();
      const way = document.querySelector(`.edge[data-edge="${CSS.escape(one.dataset.edge)}"] .stroke`);
      const to_page = way.getScreenCTM();
      return Array.from({length: 200}, (_, i) =>
        way.getPointAtLength((way.getTotalLength() * i) / 199).matrixTransform(to_page),
      ).some(({x, y}) => x > left + 1 && x < right - 1 && y > top + 2 && y < bottom - 3);
    });
    const nodes = boxes('.graph .node .box');
    return (
      struck.length +
      counts.filter((one) => nodes.some((node) => meet(one, node))).length +
      counts.filter((one, i) => counts.some((other, k) => k < i && meet(one, other))).length
    );
  });
const meeting = (...selectors) =>
  evaluate(([one, other]) => {
    const boxes = (selector) => [...document.querySelectorAll(selector)].map((each) => each.getBoundingClientRect());
    const meet = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
    return boxes(one).filter((a) => boxes(other).some((b) => meet(a, b))).length;
  }, selectors);
const smallestLetter = () =>
  evaluate(() =>
    Math.min(
      ...[...document.querySelectorAll('.graph text')].map(
        (one) => parseFloat(getComputedStyle(one).fontSize) * one.getScreenCTM().a,
      ),
    ),
  );

test('the graph can be read: letters of 11 px, counts that cover nothing, the current state in sight', async () => {
  for (const viewport of [
    {width: 1440, height: 900},
    {width: 1280, height: 720},
  ]) {
    await visitor.visit('/r/correction', {viewport});
    for (let i = 0; i < 8; ++i) {
      await visitor.page.keyboard.press('.');
      await visitor.page.waitForTimeout(300);
      const seen = await evaluate(() => {
        const canvas = document.querySelector('.graph .canvas').getBoundingClientRect();
        const node = document.querySelector('.node.current .box').getBoundingClientRect();
        return (
          node.left >= canvas.left &&
          node.right <= canvas.right &&
          node.top >= canvas.top &&
          node.bottom <= canvas.bottom
        );
      });
      assert.ok(seen, 'the current state is in sight');
    }
    assert.ok((await smallestLetter()) >= 10.9, `${await smallestLetter()} px`);
    assert.equal(await overlaps(), 0);
  }
});

test('the counts of both runs stand beside their arrows in a comparison', async () => {
  for (const viewport of [
    {width: 1440, height: 900},
    {width: 1280, height: 720},
    {width: 390, height: 844},
  ]) {
    await visitor.visit('/diff/disambiguation/disambiguation_exhausted', {viewport});
    await visitor.page.waitForSelector('.graph .count', {state: 'attached'});
    assert.equal(await overlaps(), 0);
    await at('graph-refused').waitFor();
    assert.equal(await meeting('.refused-list', '.graph .node .box'), 0);
    const labels = await visitor.page.locator('.graph .count').allTextContents();
    assert.equal(labels.length, await visitor.page.locator('.graph .edge.taken[data-edge]').count(), `${labels}`);
  }
});

test('all states of a large machine can be read at once when the graph fills the page', async () => {
  await visitor.visit('/r/correction?panel=graph', {viewport: {width: 1440, height: 900}});
  await at('taken-only').uncheck();
  assert.ok((await smallestLetter()) >= 10.9);
  assert.equal(await overlaps(), 0);
});

test('what was refused is drawn on demand, by numbers that cover nothing', async () => {
  const n = numberOf('paper/correction', ({kind, refused}) => kind === 'transition' && refused.length > 1);
  await visitor.visit(`/r/correction?n=${n}&panel=graph`, {viewport: {width: 1440, height: 900}});
  await at('graph-refused').waitFor();
  assert.equal(await visitor.page.locator('.edge.refused').count(), 0);
  await at('graph-refused').locator('summary').click();
  await visitor.page.waitForSelector('.edge.refused', {state: 'attached'});
  assert.match(await visitor.page.locator('.edge.refused .count').first().textContent(), /^\d+(, \d+)*$/);
  assert.equal(await overlaps(), 0);
});

test('the card of an arrow is put away by Escape, a press beside it, and a step', async () => {
  const ways = {
    escape: () => visitor.page.keyboard.press('Escape'),
    beside: () => visitor.page.locator('.graph svg').click({position: {x: 3, y: 3}}),
    step: () => visitor.page.keyboard.press('.'),
  };
  for (const [name, way] of Object.entries(ways)) {
    await visitor.visit('/r/rounds');
    await at('graph').locator('.edge.taken').first().focus();
    await visitor.page.keyboard.press('Enter');
    assert.ok(await at('edge-card').isVisible());
    await way();
    assert.ok(await at('edge-card').isHidden(), name);
  }
});

test('a pointer over a state tells about it', async () => {
  await visitor.visit('/r/rounds');
  await at('graph').locator('[data-state=Act] .box').hover();
  assert.match(await at('edge-card').innerText(), /Act[\s\S]*entered 3 times, 0:12 in all[\s\S]*Wait, 3 times/);
});

test('the way taken lately is marked, the last step most', async () => {
  await visitor.visit('/r/rounds');
  await visitor.page.keyboard.press('.');
  assert.ok((await visitor.page.locator('.edge.trail').count()) > 0);
  assert.equal(await visitor.page.locator('.edge.last').count(), 1);
});

test('the graph is saved as a picture that stands alone, its labels whole', async () => {
  await visitor.visit('/r/rounds');
  const [saved] = await Promise.all([
    visitor.page.waitForEvent('download'),
    visitor.page.locator('.graph button', {hasText: 'SVG'}).click(),
  ]);
  const text = (await (await saved.createReadStream()).toArray()).join('');
  assert.match(text, /^<svg [^>]*viewBox/);
  assert.match(text, /ask: P, size\(options\) &gt; 1 \/ push, 3 times/);
  assert.doesNotMatch(text, /var\(--|class=/);
});

test('nothing of the start page or the header is cut at 1280', async () => {
  for (const width of [1280, 1440]) {
    await visitor.visit('/', {viewport: {width, height: 720}});
    await listed();
    const beyond = await evaluate(() => {
      const table = document.querySelector('.start .table');
      return table.scrollWidth - table.clientWidth;
    });
    assert.ok(beyond <= 0, `${beyond} px beyond at ${width}`);
  }
  await visitor.visit('/r/rounds', {viewport: {width: 1280, height: 720}});
  const spilt = await evaluate(() =>
    [...document.querySelectorAll('header.top button')]
      .filter((one) => one.scrollHeight > one.clientHeight + 1 || one.scrollWidth > one.clientWidth + 1)
      .map((one) => one.textContent),
  );
  assert.deepEqual(spilt, []);
});

test('runs are sorted, filtered, grouped, and walked by keys', async () => {
  await visitor.visit('/');
  await listed();
  const names = () => visitor.page.locator('.start a.name').allInnerTexts();
  await visitor.page.locator('th button', {hasText: 'Run'}).click();
  const by_name = await names();
  assert.deepEqual(
    by_name,
    by_name.toSorted((a, b) => a.localeCompare(b, 'en', {numeric: true})),
  );
  await visitor.page.locator('th button', {hasText: 'Run'}).click();
  assert.deepEqual(await names(), by_name.toReversed());
  await at('filter-verdict').selectOption('failed');
  assert.deepEqual(await names(), ['worst', 'failing']);
  await at('search').fill('nothing like it');
  assert.match(await at('nothing-found').innerText(), /No run fits/);
  await at('nothing-found').locator('button').click();
  assert.equal((await names()).length, by_name.length);
  await at('by-folder').check();
  assert.deepEqual(await visitor.page.locator('tr.folder').allInnerTexts(), ['here', 'older']);
  await visitor.page.keyboard.press('Escape');
  await at('search').fill('failing');
  await at('search').press('ArrowDown');
  assert.equal(await evaluate(() => document.activeElement.textContent), 'failing');
  await at('search').press('Enter');
  await at('panel-graph').waitFor();
});

test('a third choice takes none of the others away: each is compared with the first', async () => {
  await visitor.visit('/');
  await listed();
  for (const name of ['rounds', 'failing', 'correction'])
    await visitor.page.getByLabel(`Choose ${name} to compare`, {exact: true}).check();
  assert.equal(await visitor.page.locator('[data-testid=choose]:checked').count(), 3);
  await at('compare-chosen').click();
  await visitor.page.waitForFunction(
    () => !/being compared/.test(document.querySelector('[data-testid=many]').innerText),
  );
  const rows = await at('many-row').allInnerTexts();
  assert.equal(rows.length, 3);
  assert.match(rows[1], /failing[\s\S]*1 difference|failing[\s\S]*differences/);
  assert.match(rows[1], /2 of 3 acts done/);
});

test('who contributed is told once', async () => {
  const n = numberOf('paper/dialogue_gesture', ({kind, status}) => kind === 'act' && status === 'asked');
  await visitor.visit(`/r/dialogue_gesture?n=${n}`);
  await at('inputs').waitFor();
  assert.doesNotMatch(await at('inputs').innerText(), /(\b\w+\b) \1/);
});

test('an address with nothing at it says so, to a reader and to a program', async () => {
  const answer = await fetch(`${server.address}/nothere`, {headers: {Accept: 'text/html'}});
  assert.equal(answer.status, 404);
  assert.match(await answer.text(), /<!doctype html>/);
  assert.equal((await (await fetch(`${server.address}/nothere`)).json()).error.message, 'there is nothing at /nothere');
  await visitor.visit('/nothere', {ready: '[data-testid=problem]'});
  assert.match(await at('problem').innerText(), /nothing at \/nothere/);
});

test('anything is gone to by its name: a state, an object, a panel, a run, a command', async () => {
  await visitor.visit('/r/rounds');
  const go = async (text) => {
    await visitor.page.keyboard.press('Control+k');
    await at('go-to').waitFor();
    await visitor.page.waitForTimeout(200); // until the runs are known
    await visitor.page.keyboard.type(text);
    await visitor.page.keyboard.press('Enter');
  };
  await go('act');
  assert.equal(await evaluate(() => window.continua.page.data.state(window.continua.page.cursor.n)), 'Act');
  await go('summary');
  assert.ok(await at('panel-account').isVisible());
  await go('#5');
  assert.equal(await visitor.n(), 5);
  await go('the whole run');
  assert.match(await at('span').innerText(), /^0:00\.0 – 1:01\.0 of 1:01\.0/);
  await go('failing');
  await visitor.page.waitForURL(/\/r\/failing/);
  await visitor.visit('/r/wizard?n=45');
  await visitor.page.waitForFunction(() => window.continua.page.parts.scene.things.length);
  await go('white cup');
  await visitor.page.waitForFunction(() =>
    /^the white cup: /.test(document.querySelector('[data-testid=scene-caption]').innerText),
  );
  assert.deepEqual(visitor.complaints, []);
});

test('the pointer over the timeline tells the instant, and a stretch is selected with Shift', async () => {
  await visitor.visit('/r/rounds');
  await visitor.page.keyboard.press('0');
  const box = await at('timeline').boundingBox();
  await visitor.page.mouse.move(box.x + 300, box.y + 6);
  assert.match(await visitor.page.locator('.tip').innerText(), /^0:\d\d\.\d\d, /);
  await visitor.selectStretch();
  assert.match(await at('stretch').innerText(), /0:\d\d.* s: [23] sentences of the human.*act/);
  const [from, to] = (await at('stretch').innerText()).match(/\d+:\d\d\.\d\d/g);
  const [file] = await Promise.all([
    visitor.page.waitForEvent('download'),
    at('stretch').locator('button', {hasText: 'Export this stretch'}).click(),
  ]);
  const name = (t) => t.replace(':', 'm');
  assert.equal(file.suggestedFilename(), `three rounds_${name(from)}s-${name(to)}s.jsonl`);
  const linesOf = (text) =>
    text
      .trimEnd()
      .split('\n')
      .map((line) => JSON.parse(line));
  const told = linesOf(readFileSync(await file.path(), 'utf8'));
  const [begin, end] = [from, to].map((t) => t.split(':').reduce((sum, part) => 60 * sum + Number(part), 0));
  const expected = linesOf(roundsLog()).filter(({t}) => t > begin - 0.005 && t < end + 0.005);
  assert.ok(told.length > 300);
  assert.deepEqual(told, expected);
  await visitor.selectStretch();
  await visitor.page.route('**/records?from=*', (route) => route.abort());
  await at('stretch').locator('button', {hasText: 'Export this stretch'}).click();
  await at('stretch').locator('text=Export this stretch did not work: ').waitFor();
  await visitor.page.unroute('**/records?from=*');
  await visitor.selectStretch();
  const before_zoom = await at('span').innerText();
  await at('stretch').locator('button', {hasText: 'Zoom'}).click();
  assert.notEqual(await at('span').innerText(), before_zoom);
  assert.ok(await at('stretch').isHidden());
});

test('a run is told in a few sentences, act by act and minute by minute', async () => {
  await visitor.visit('/r/failing?tab=account');
  await at('account').waitFor();
  assert.match(
    await at('account').innerText(),
    /3 sentences[\s\S]*3 acts: 2 done, 1 failed[\s\S]*block1 is in the way/,
  );
  const told = await at('panel-account').innerText();
  assert.match(told, /Act by act[\s\S]*puts block2 on block1[\s\S]*✘ failed/);
  assert.match(told, /Minute by minute[\s\S]*0:00 – 1:00[\s\S]*“Put it there, 0\.”, yes[\s\S]*“Which block\?”/);
  await at('panel-account').locator('li button').nth(2).click();
  assert.equal(await evaluate(() => window.continua.page.data.kind(window.continua.page.cursor.n)), 'act');
});
