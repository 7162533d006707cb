// The live page in a real browser: a person types, shows gestures and points, and the avatar answers.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {dirname} from 'node:path';
import {after, before, test} from 'node:test';
import {
  answered,
  api,
  asked,
  done,
  at,
  begin,
  beginWith,
  click,
  close,
  drawing,
  eventsOf,
  flat,
  folder,
  idOf,
  lines,
  open,
  placeOf,
  ready,
  server,
  type,
  typeAndClick,
  until,
  use,
  visitor,
} from './live_support.mjs';
import {program, Visitor} from './support.mjs';

const moved = {objects: {cup: {position: [-0.02, 0.05, 0.05]}, knife: {position: [0.3, -0.1, 0.005]}}};
const kinematic = {physics: false};
const saved = [];
before(open);
after(close);

async function saveAsTest(name) {
  await at('live-save').click();
  await at('save-name').fill(name);
  const [response] = await Promise.all([visitor.page.waitForResponse(/\/save$/), at('save-do').click()]);
  const {trace, check} = await response.json();
  await at('saved').locator('code').waitFor();
  assert.equal(await at('saved').locator('code').innerText(), check);
  saved.push(trace);
  await visitor.page.keyboard.press('Escape');
}

test('a dialogue in words: the plate, put in front of the avatar', async () => {
  await begin(flat);
  assert.match(await at('talk').getAttribute('placeholder'), /“The plate\.”/);
  await answered(() => type('The plate.'), 'Okay, go on.');
  await answered(() => type('Put it in front of you.'), 'Okay.');
  await asked('put(plate, in_front(avatar))');
  await lines('avatar', 'does').filter({hasText: 'done'}).waitFor();
  await saveAsTest('dialogue_in_words');
  assert.deepEqual(visitor.complaints, []);
});

test('words and a click in 3D: put it there', async () => {
  await begin(drawing);
  await answered(() => type('The plate.'), 'Okay, go on.');
  await answered(() => typeAndClick('Put it there.', [-0.1, -0.15]), 'Okay.');
  const does = await lines('avatar', 'does').locator('a').getAttribute('title');
  const [, x, y] = /put\(plate, <(-?[\d.]+), (-?[\d.]+), 0>\)/.exec(does);
  assert.ok(Math.abs(Number(x) + 0.1) < 0.01 && Math.abs(Number(y) + 0.15) < 0.01, does);
  await saveAsTest('put_it_there');
  assert.deepEqual(visitor.complaints, []);
});

test('a click on a region with two objects: asked about, nearest first', async () => {
  await beginWith(drawing, {...moved, ...kinematic});
  await answered(() => click([0.29, -0.05]), 'The blue cup?');
  await answered(() => type('No.'), 'The knife?');
  await visitor.page.waitForTimeout(1000); // a thumb that comes with the word would contradict it
  await answered(() => visitor.page.locator('[data-gesture=posack]').first().click(), 'Okay, go on.');
  await saveAsTest('region_without_words');
});

test('a click while typing: that cup', async () => {
  await beginWith(flat, {...moved, ...kinematic});
  await answered(() => typeAndClick('That cup.', [0.29, -0.05]), 'Okay, go on.');
  await saveAsTest('that_cup');
});

test('a click while typing: in that blue cup', async () => {
  await beginWith(flat, {...moved, ...kinematic});
  await answered(() => type('The knife.'), 'Okay, go on.');
  await answered(() => typeAndClick('In that blue cup.', [0.29, -0.05]), 'Okay, the knife in the blue cup.');
  await asked('put(knife, in(cup_blue))');
  await saveAsTest('in_that_blue_cup');
});

test('a gesture that nobody knows is taught once', async () => {
  await beginWith(flat, {objects: {cup_blue: null}, ...kinematic});
  const twoFingers = async () => {
    await at('other-gesture').fill('two fingers');
    await at('other-gesture').press('Enter');
  };
  await answered(twoFingers, 'What does that gesture mean?');
  await answered(() => type('Grasp the cup.'), 'Okay, I will remember that.');
  await answered(twoFingers, 'Okay.');
  await asked('grasp(cup)');
  await type('Let go of it.');
  await done('ungrasp(cup)');
  await answered(() => type('Never mind.'), 'Okay, never mind.');
  await answered(() => type('Put on the plate.'), 'What should I put there?');
  await answered(twoFingers, 'Okay, the white cup on the white plate.');
  await asked('put(cup, on(plate))');
  await saveAsTest('one_shot_learning');
});

test('why an act went otherwise is told by people’s names, the logged reason on hover', async () => {
  await beginWith(flat, {objects: {cup_blue: {position: [-0.36, 0.01, 0.05]}}});
  await type('Push the plate to the left.');
  const told = lines('avatar', 'does').last().locator('.status');
  await told.filter({hasText: 'the blue cup is in the way of the white plate'}).waitFor();
  assert.equal(await told.locator('[title]').getAttribute('title'), 'cup_blue is in the way of plate');
});

test('what was saved holds as tests', () => {
  assert.equal(saved.length, 6);
  const told = execFileSync(program, ['check', ...new Set(saved.map(dirname))], {encoding: 'utf8', cwd: folder});
  assert.match(told, /6 traces/);
});

test('pause stops the engine’s time, and going on lets it run', async () => {
  await begin(flat);
  const id = await idOf();
  await at('talk').press('Escape');
  await visitor.page.keyboard.press(' ');
  await visitor.page.waitForFunction(() =>
    /paused/.test(document.querySelector('[data-testid=live-mode]').textContent),
  );
  // Many machines have no emoji: such a sign would be an empty box.
  assert.doesNotMatch(await at('live-mode').innerText(), /\p{Extended_Pictographic}/u);
  const {t, paused} = await api(`/${id}`);
  assert.ok(paused);
  for (let i = 0; i < 20; ++i) assert.equal((await api(`/${id}`)).t, t);
  await at('live-pause').click();
  await visitor.page.waitForFunction(() =>
    /recording/.test(document.querySelector('[data-testid=live-mode]').textContent),
  );
  await until(async () => (await api(`/${id}`)).t > t, 'time goes on');
});

test('a held button is a hold, a moving mouse samples', async () => {
  await begin(flat);
  const [x, y] = await placeOf([0.1, 0.05]);
  await visitor.page.mouse.move(x, y);
  await visitor.page.mouse.down();
  await lines('human', 'shows').filter({hasText: 'points, begins'}).waitFor();
  await visitor.page.mouse.move(x + 30, y, {steps: 4});
  await visitor.page.mouse.up();
  await lines('human', 'shows').filter({hasText: 'points, ends'}).waitFor();
  const {trace} = await api(`/${await idOf()}`);
  const samples = eventsOf(trace).filter(({kind}) => kind === 'pointing');
  assert.ok(
    samples.length &&
      samples.every(({hand, target: [a, b]}) => hand === 'right' && a > 0.09 && Math.abs(b - 0.05) < 0.002),
    JSON.stringify(samples),
  );
});

test('by keyboard alone: the cross points, and the avatar answers', async () => {
  await begin(flat);
  await at('talk').press('Escape');
  await at('table-map').focus();
  for (const key of ['Shift+ArrowLeft', 'Shift+ArrowLeft', 'Shift+ArrowLeft', 'Shift+ArrowLeft', 'ArrowUp'])
    await visitor.page.keyboard.press(key);
  assert.match(await at('live-caption').innerText(), /plate/);
  await answered(() => visitor.page.keyboard.press('Enter'), 'Okay, go on.');
  assert.match(await lines('human', 'shows').innerText(), /points?, 20 cm left, 1 cm farther/);
  await at('table-map').press('/');
  assert.ok(await at('talk').evaluate((box) => box === document.activeElement));
});

test('who comes later watches, and cannot send', async (t) => {
  await begin(flat);
  const id = await idOf();
  await answered(() => type('The plate.'), 'Okay, go on.');
  const guest = await Visitor.start(server.address);
  t.after(() => guest.close());
  await guest.visit(`/live/${id}`);
  await guest.at('live-watching').waitFor();
  assert.equal(await guest.at('talk').count(), 0);
  await guest.page.locator('[data-testid=conversation] >> text=“Okay, go on.”').waitFor();
  await visitor.page.waitForFunction(() =>
    /1 watching/.test(document.querySelector('[data-testid=live-viewers]').textContent),
  );
  for (const key of ['y', '1']) await guest.page.keyboard.press(key);
  await guest.page.mouse.click(300, 300);
  await type('The knife.');
  await guest.page.locator('[data-testid=conversation] >> text=“The knife.”').waitFor();
  assert.equal(await guest.page.locator('[data-who=human]').count(), 2);
  assert.deepEqual(guest.complaints, []);
});

test('while the server is gone the page says so at once, its clock stands, and words wait to be sent', async () => {
  await begin(flat);
  await visitor.context.setOffline(true);
  await type('The plate.');
  await visitor.page.waitForFunction(() =>
    /Connection lost/.test(document.querySelector('[data-testid=live-notice]').textContent),
  );
  assert.match(await at('live-mode').innerText(), /not connected since 0:/);
  assert.match(await at('live-unsent').innerText(), /“The plate\.” waits/);
  const t = await at('live-time').innerText();
  await visitor.page.waitForTimeout(1500);
  assert.equal(await at('live-time').innerText(), t);
  await answered(() => visitor.context.setOffline(false), 'Okay, go on.');
  await visitor.page.waitForFunction(() => document.querySelector('[data-testid=live-notice]').textContent === '');
  assert.match(await at('live-mode').innerText(), /recording/);
  assert.ok(await at('live-unsent').isHidden());
  await visitor.page.waitForFunction((was) => document.querySelector('[data-testid=live-time]').textContent !== was, t);
});

test('a page that is loaded again goes on with its session, after asking', async () => {
  await begin(flat);
  const id = await idOf();
  await answered(() => type('The plate.'), 'Okay, go on.');
  const asked = [];
  visitor.page.once('dialog', (dialog) => {
    asked.push(dialog.type());
    dialog.accept();
  });
  await visitor.page.reload();
  await ready();
  assert.deepEqual(asked, ['beforeunload']);
  assert.ok((await api(`/${id}`)).live);
  await at('conversation').getByText('Okay, go on.').waitFor(); // the last of the earlier lines
  await answered(() => type('Put it there.'), 'Where should I put it?');
  assert.match(await at('conversation').innerText(), /The plate[\s\S]*Put it there/);
  await at('live-end').click();
  await at('live-summary').waitFor();
});

test('examples are said at one press, gestures made while typing, and the way of an act is shown', async () => {
  await begin(drawing);
  await answered(() => at('examples').locator('button').first().click(), 'Okay, go on.');
  assert.ok(await at('examples').isHidden());
  await at('talk').fill('half a sent');
  await at('talk').press('Alt+1');
  await lines('human', 'shows').first().waitFor();
  assert.equal(await at('talk').inputValue(), 'half a sent');
  const heading = await visitor.page.evaluate(async () => {
    const {LiveWorld} = await import('/talk/live_world.js');
    const world = new LiveWorld(() => {});
    world.poses.set('cup', [0.1, 0, 0, 1, 0, 0, 0]).set('plate', [0.3, 0, 0, 1, 0, 0, 0]);
    const way = (program) => {
      world.act({program, status: 'started'});
      return world.heading;
    };
    const ways = [way('put(cup, on(plate))'), way('put(cup, <-0.1, 0.2, 0>)'), way('lift(cup)')];
    way('put(cup, on(plate))');
    world.act({program: 'put(cup, on(plate))', status: 'done'});
    return [...ways, world.heading];
  });
  assert.deepEqual(heading, [
    {target: [0.3, 0, 0], from: [0.1, 0, 0]},
    {target: [-0.1, 0.2, 0], from: [0.1, 0, 0]},
    null,
    null,
  ]);
});

test('gestures, acts and what the avatar shows are told by people’s names, their ids on hover', async () => {
  await begin(flat);
  assert.match(await visitor.page.locator('[data-gesture=posack]').first().innerText(), /^yes/);
  assert.match(await visitor.page.locator('[data-gesture=posack]').first().getAttribute('title'), /^posack: /);
  await answered(() => type('Lift the knife.'), 'Okay.');
  await lines('avatar', 'does').filter({hasText: 'lifts the knife'}).waitFor();
  await asked('lift(knife)');
  await answered(() => type('Take the cup.'), 'Which cup do you mean? Should I take the white cup?');
  await lines('avatar', 'shows').filter({hasText: 'points at the white cup'}).waitFor();
  await at('live-end').click();
});

test('on a phone the machine’s panels are whole, and the dialogue has room beside them', async () => {
  await begin(flat, {viewport: {width: 390, height: 844}});
  await at('live-machine-button').click();
  await at('live-machine').locator('.node.current').waitFor();
  await answered(() => type('Take the cup.'), 'Which cup do you mean? Should I take the white cup?');
  const boxOf = (one) => visitor.page.locator(one).boundingBox();
  const drawer = await boxOf('[data-testid=live-machine]');
  for (const part of ['.graph', '.stack']) {
    const panel = await boxOf(`.machine-drawer > ${part}`);
    assert.ok(panel.y + panel.height <= drawer.y + drawer.height + 1, `${part} leaves the drawer`);
  }
  const moves = await boxOf('.conversation');
  assert.ok(moves.height >= 120 && moves.y >= drawer.y + drawer.height, `the dialogue is ${moves.height} px high`);
  await at('live-end').click();
});

test('the machine’s graph and stack follow in a corner that covers nothing, and type is big for a projector', async () => {
  await begin(flat);
  await at('talk').press('Escape');
  await visitor.page.keyboard.press('g');
  const state = () => at('live-machine').locator('.node.current').getAttribute('data-state');
  await visitor.page.waitForFunction(() => document.querySelector('[data-testid=live-machine] .node.current'));
  assert.equal(await state(), 'Ready');
  await answered(() => type('Take the cup.'), 'Which cup do you mean? Should I take the white cup?');
  await visitor.page.waitForFunction(
    () => document.querySelector('[data-testid=live-machine] .node.current')?.dataset.state === 'Choose',
  );
  await at('live-machine').locator('[data-testid=symbol]', {hasText: 'options'}).first().waitFor();
  const [drawer, scene] = await Promise.all(
    ['[data-testid=live-machine]', '.live-scene'].map((one) => visitor.page.locator(one).boundingBox()),
  );
  assert.ok(drawer.y >= scene.y + scene.height, 'the scene can be pointed at');
  const size = () =>
    lines('avatar', 'says')
      .first()
      .evaluate((line) => parseFloat(getComputedStyle(line).fontSize));
  const before = await size();
  for (let i = 0; i < 6; ++i) await type('Take the cup.');
  await until(async () => (await lines('human', 'says').count()) === 7, 'all is said');
  await at('talk').press('Escape');
  await visitor.page.keyboard.press('b');
  assert.ok((await size()) >= 20 && before < 20);
  const unseen = () => at('conversation').evaluate((list) => list.scrollHeight - list.scrollTop - list.clientHeight);
  await until(async () => (await unseen()) < 5, 'the latest line stays in sight in big type');
  assert.ok(await visitor.page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  await at('live-machine-button').click();
  assert.ok(await at('live-machine').isHidden());
  await at('live-end').click();
  await at('live-summary').waitFor();
  assert.deepEqual(visitor.complaints, []);
});

test('an ended session can be gone on with, from its page and from the list', async () => {
  await begin(flat);
  const first = await idOf();
  await answered(() => type('The plate.'), 'Okay, go on.');
  await at('live-end').click();
  await at('live-go-on').click();
  await at('live-summary').waitFor({state: 'detached'});
  assert.notEqual(await idOf(), first);
  await ready();
  await lines('avatar', 'says').filter({hasText: 'Okay, go on.'}).waitFor();
  await answered(() => type('Lift it.'), 'Okay.');
  await asked('lift(plate)');
  const second = await idOf();
  await at('live-end').click();
  await at('live-summary').waitFor();
  await visitor.visit('/live');
  await visitor.page.getByRole('button', {name: `Go on with ${second}`, exact: true}).click();
  await ready();
  await lines('human', 'says').filter({hasText: 'Lift it.'}).waitFor();
  await at('live-end').click();
  await at('live-summary').waitFor();
});

test('a name that cannot be is refused with the reason and one that can', async () => {
  await begin(flat);
  await answered(() => type('The plate.'), 'Okay, go on.');
  await at('live-save').click();
  await at('save-name').fill('my first test!');
  await at('save-do').click();
  assert.match(await at('saved').innerText(), /found a space !; expected letters.* How about my_first_test\?/);
});

test('the browser’s recogniser talks to the avatar', async () => {
  use(flat);
  await visitor.visit('/live');
  await visitor.page.addInitScript(() => {
    window.SpeechRecognition = class {
      start() {
        window.recogniser = this;
      }
      stop() {}
    };
  });
  await visitor.page.reload();
  await at('live-start').click();
  await ready();
  await at('microphone').click();
  await answered(
    () =>
      visitor.page.evaluate(() =>
        window.recogniser.onresult({
          resultIndex: 0,
          results: [
            Object.assign(
              [
                {transcript: 'the plate', confidence: 0.9},
                {transcript: 'the play', confidence: 0.4},
              ],
              {isFinal: true},
            ),
          ],
        }),
      ),
    'Okay, go on.',
  );
  const {trace} = await api(`/${await idOf()}`);
  const {text, confidence, alternatives} = eventsOf(trace).find(({kind}) => kind === 'speech');
  assert.deepEqual(
    {text, confidence, alternatives},
    {text: 'the plate', confidence: 0.9, alternatives: [{text: 'the play', confidence: 0.4}]},
  );
  await visitor.page.evaluate(() => window.recogniser.onerror({error: 'not-allowed'}));
  assert.match(await at('live-notice').innerText(), /microphone may not be used/);
});

test('closing the page ends the session after a while; what was recorded is whole', async () => {
  await begin(flat);
  const id = await idOf();
  await answered(() => type('The plate.'), 'Okay, go on.');
  await visitor.page.goto('about:blank');
  let state;
  await visitor.page.waitForTimeout(1000);
  assert.ok((await api(`/${id}`)).live, 'the page may come back');
  await until(async () => !(state = await api(`/${id}`)).live, 'the session ends', 60000);
  const lastOf = (path) => eventsOf(path).at(-1);
  assert.equal(lastOf(state.trace).kind, 'end');
  assert.equal(lastOf(state.trace.replace(/\.trace\.jsonl$/, '.run.jsonl')).kind, 'end');
  await visitor.page.goto(`${server.address}/live/${id}`);
  await at('live-summary').waitFor();
  assert.match(await at('conversation').innerText(), /“The plate\.”/);
});

test('light or dark: the scene goes along', async () => {
  await begin(drawing);
  const background = () =>
    visitor.page.evaluate(() => window.continua.page.shown.place.view.stage.drawing.colours.background);
  await visitor.page.waitForFunction(() => window.continua.page.shown.place.view.stage.draws > 0);
  const light = await background();
  await at('talk').press('Escape');
  await visitor.page.keyboard.press('t');
  await visitor.page.waitForFunction(
    (was) => window.continua.page.shown.place.view.stage.drawing.colours.background !== was,
    light,
  );
});

test('a session that goes on can be followed from both start pages', async () => {
  use(flat);
  const {id} = await api('', {recorder: 'somebody else'});
  const link = () => visitor.page.locator(`a[href="/live/${id}"]`, {hasText: 'Follow'});
  for (const path of ['/', '/live']) {
    await visitor.visit(path);
    await link().waitFor();
  }
  await link().click();
  await at('live-watching').waitFor();
  await api(`/${id}/end?recorder=somebody%20else`, {});
  await at('live-summary').waitFor();
});

test('the start page leads here, and a session that is not there says so', async () => {
  use(flat);
  await visitor.visit('/');
  await at('record-session').click();
  await at('live-start').waitFor();
  assert.ok(await at('live-start').evaluate((button) => button === document.activeElement));
  await visitor.visit('/live/nothing_like_it');
  assert.match(await visitor.page.locator('h1').innerText(), /no conversation/);
});

for (const colorScheme of ['light', 'dark'])
  for (const [how, start] of [
    ['in 3D', () => begin(drawing, {colorScheme, bypassCSP: true})],
    ['as a map', () => begin(flat, {colorScheme, bypassCSP: true})],
  ])
    test(`nothing stands in the way of access, ${how}, ${colorScheme}`, async () => {
      await start();
      await answered(() => type('The plate.'), 'Okay, go on.');
      await at('talk').fill('Put it there');
      await click([0.3, 0.15]);
      await at('click-chip').waitFor();
      assert.deepEqual(await visitor.violations(), []);
      await at('talk').press('Enter');
      await at('live-end').click();
      await at('live-summary').waitFor();
      assert.deepEqual(await visitor.violations(), []);
    });

test('on a phone nothing is too wide, the text box is in sight, and a finger points', async () => {
  await begin(flat, {viewport: {width: 360, height: 740}, hasTouch: true});
  assert.ok(await visitor.page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  const {y, height} = await at('talk').boundingBox();
  assert.ok(y > 0 && y + height <= 740);
  const example = await at('examples').locator('button').first().boundingBox();
  assert.ok(example && example.y > 0 && example.y + example.height <= y, 'an example is in sight above the text box');
  await answered(async () => visitor.page.touchscreen.tap(...(await placeOf([-0.2, 0.01]))), 'Okay, go on.');
});

for (const width of [1010, 1100, 1280])
  test(`all buttons of the head are in sight, ${width} px wide, with the longest words on them`, async () => {
    await begin(flat, {viewport: {width, height: 640}});
    const cut = await visitor.page.evaluate(() => {
      document.querySelector('[data-testid=live-hand]').textContent = '● Stop tracking my hand';
      const boxes = [...document.querySelectorAll('.live-top button, .live-top a.button, .live-top .badge')];
      return boxes
        .filter((one) => one.getClientRects().length > 1 || one.getBoundingClientRect().right > innerWidth)
        .map((one) => one.textContent);
    });
    assert.deepEqual(cut, []);
    const {height} = await at('live-mode').boundingBox();
    assert.ok(height < 28, 'the badge has one line');
  });
