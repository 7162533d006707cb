// The scene in 3D: its pure parts, and the panel in a browser that draws it, and in one that cannot.
import assert from 'node:assert/strict';
import {writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {eyeOf, fit, flight, sides, viewFrom} from '../../web/scene3d/framing.js';
import {buildBodies, shapeOf} from '../../web/scene3d/geometry.js';
import {apart} from '../../web/scene3d/ghost.js';
import {between, Motion, Window} from '../../web/scene3d/motion.js';
import {approached, shifted, turned} from '../../web/scene3d/orbit.js';
import {objectNear, placeText, sceneSentence} from '../../web/scene3d/scene_text.js';
import {logOf, packages, recordsOf, serve, temporaryFolder, Visitor} from './support.mjs';

const close = (a, b, by = 1e-9) => assert.ok(Math.abs(a - b) <= by, `${a} is not ${b}`);
const at = (x, turn = 0) => [x, 0, 0, Math.cos(turn / 2), 0, 0, Math.sin(turn / 2)];

test('between two poses the way is straight and the turn even, the shorter way', () => {
  const half = between(at(0), at(1, Math.PI / 2), 0.5);
  close(half[0], 0.5);
  close(half[6], Math.sin(Math.PI / 8));
  const other_sign = at(1, Math.PI / 2).map((v, i) => (i < 3 ? v : -v));
  close(Math.abs(between(at(0), other_sign, 0.5)[6]), Math.sin(Math.PI / 8));
  assert.deepEqual(between(at(0), at(1), 0), at(0));
  assert.deepEqual(between(at(0), at(1), 1), at(1));
});

test('bodies are exact at samples, on the way between near ones, at rest across gaps', () => {
  const window = new Window(
    {
      start: {a: at(0), b: at(5)},
      changes: [
        [1, {a: at(1)}],
        [1.03, {a: at(2)}],
        [3, {a: at(7)}],
      ],
    },
    0,
    8,
  );
  const x = (t) => window.poses(t).get('a')[0];
  assert.equal(x(0), 0);
  assert.equal(x(0.9), 0, 'it stood still until just before');
  close(x(0.975), 0.5);
  assert.equal(x(1), 1);
  close(x(1.015), 1.5);
  assert.equal(x(1.03), 2);
  assert.equal(x(2.5), 2);
  assert.equal(x(3), 7);
  assert.equal(x(8), 7);
  assert.equal(window.poses(4).get('b')[0], 5);
});

test('what is no pose, sample or act is passed over', () => {
  const window = new Window(
    {
      start: {a: at(0), bad: 'x', worse: [1, 2]},
      changes: [null, ['x', {}], [1, null], [2, {a: [1, 2, 3, 0, 0, 0, 0]}], [3, {a: at(1)}], [1, {a: at(9)}]],
      pointing: [null, {from: 0, to: 9, samples: [['x']]}, {from: 0, to: 9, origin: 7, samples: [[1, 0, 0, 0], null]}],
      acts: ['x', {from: 0, to: 1, target: 'there'}],
    },
    0,
    8,
  );
  assert.deepEqual([...window.poses(9).keys()], ['a']);
  assert.equal(window.poses(9).get('a')[0], 1);
  assert.equal(window.pointing.length, 1);
  assert.equal(window.pointing[0].origin, null);
  assert.equal(window.acts[0].target, null);
  for (const answer of [null, [], 'x', {start: 3, changes: 4, pointing: {}, acts: 7}])
    assert.equal(new Window(answer, 0, 1).poses(0.5).size, 0);
});

test('pointing shows its last sample and the trail before it', () => {
  const window = new Window(
    {
      pointing: [
        {
          who: 'human',
          from: 1,
          to: 3,
          samples: [
            [1, 0, 0, 0],
            [1.8, 1, 0, 0],
            [2, 2, 0, 0],
            [2.5, 3, 0, 0],
          ],
        },
      ],
    },
    0,
    8,
  );
  assert.deepEqual(window.pointingAt(0.5), []);
  assert.deepEqual(window.pointingAt(2.1)[0].target, [2, 0, 0]);
  assert.deepEqual(window.pointingAt(2.1)[0].trail, [
    [1, 0, 0],
    [2, 0, 0],
  ]);
});

const settled = () => new Promise((done) => setTimeout(done, 5));
function motionOf(answer, options = {}) {
  const asked = [];
  const motion = new Motion({
    fetch: async (from, to) => {
      asked.push([from, to]);
      return answer(from, to);
    },
    duration: () => 1000,
    arrived: () => {},
    ...options,
  });
  return {motion, asked};
}

test('windows are fetched once, the next one ahead, and kept within bounds', async () => {
  const {motion, asked} = motionOf(() => ({start: {a: at(1)}, changes: []}));
  assert.equal(motion.at(1), null);
  motion.at(2);
  await settled();
  assert.equal(motion.at(2).poses(2).get('a')[0], 1);
  assert.equal(asked.length, 1);
  motion.at(7);
  await settled();
  assert.equal(asked.length, 2, 'the next was fetched ahead');
  assert.ok(motion.at(9));
  const full = motionOf(() => ({
    start: Object.fromEntries(Array.from({length: 3e4}, (_, i) => [`b${i}`, at(0)])),
    changes: [],
  }));
  for (let i = 0; i < 30; ++i) {
    full.motion.at(100 * i);
    await settled();
  }
  assert.ok(full.motion.numbers < 2.3e6, `${full.motion.numbers}`);
});

test('what a run that grows has more of is fetched', async () => {
  let end = 5;
  const {motion, asked} = motionOf(() => ({}), {duration: () => end});
  motion.at(9);
  await settled();
  assert.ok(motion.at(5));
  await settled();
  assert.equal(asked.length, 1);
  end = 7;
  assert.equal(motion.at(7), null);
  await settled();
  assert.ok(motion.at(7));
  assert.equal(asked.length, 2);
});

test('of many instants asked for while one is on its way only the last is fetched', async () => {
  const {motion, asked} = motionOf(() => ({}));
  for (let t = 0; t < 500; t += 10) motion.at(t);
  await settled();
  assert.deepEqual(
    asked.map(([from]) => Math.round(from)),
    [0, 488],
  );
});

test('an answer that was cut short is gone on with, and never asked for without end', async () => {
  const {motion, asked} = motionOf((from, to) =>
    to - from > 1 ? {start: {a: at(from)}, changes: [], next: from + 0.15} : {},
  );
  for (let i = 0; i < 20; ++i) {
    motion.at(5);
    await settled();
  }
  assert.ok(motion.at(5));
  assert.ok(asked.length < 5, `${asked.length}`);
});

test('after an error the server is left in peace for a while', async () => {
  let now = 0;
  const {motion, asked} = motionOf(
    () => {
      throw new Error('gone');
    },
    {now: () => now},
  );
  for (let i = 0; i < 10; ++i) {
    motion.at(5);
    await settled();
  }
  assert.equal(asked.length, 1);
  assert.equal(motion.problem, 'gone');
  now = 2500;
  motion.at(5);
  await settled();
  assert.equal(asked.length, 2);
});

test('a camera fitted to points has all of them in the picture, and just', () => {
  const points = [
    [-0.5, -0.3, 0],
    [0.5, 0.3, 0],
    [0, 0.4, 0.8],
    [0.5, -0.3, 0],
  ];
  for (const side of Object.values(sides))
    for (const aspect of [0.5, 1, 2.4]) {
      const view = fit(side, points, aspect);
      const eye = eyeOf(view);
      const forward = view.target.map((x, i) => (x - eye[i]) / view.distance);
      const seen = points.map((point) => {
        const d = point.map((x, i) => x - eye[i]);
        const depth = d[0] * forward[0] + d[1] * forward[1] + d[2] * forward[2];
        const right = [Math.sin(view.azimuth), -Math.cos(view.azimuth), 0];
        const across = (d[0] * right[0] + d[1] * right[1]) / depth / Math.tan(view.fovy / 2) / aspect;
        const up =
          Math.sqrt(
            Math.max(0, d[0] ** 2 + d[1] ** 2 + d[2] ** 2 - depth ** 2 - (d[0] * right[0] + d[1] * right[1]) ** 2),
          ) /
          depth /
          Math.tan(view.fovy / 2);
        return Math.max(Math.abs(across), up);
      });
      assert.ok(Math.max(...seen) <= 1 && Math.max(...seen) > 0.8, `${seen}`);
    }
  const view = viewFrom([0, -1, 1], [0, 0, 0]);
  eyeOf(view).forEach((x, i) => close(x, [0, -1, 1][i]));
  close(flight({...view, azimuth: 3}, {...view, azimuth: -3}, 0.5).azimuth, Math.PI, 1e-6);
});

test('turning stops above and below, approaching near and far', () => {
  const view = viewFrom([0, -1, 1], [0, 0, 0]);
  assert.ok(turned(view, 0, 9).elevation < Math.PI / 2);
  assert.ok(turned(view, 0, -9).elevation > -Math.PI / 2);
  assert.ok(approached(view, 1e-9).distance > 0);
  assert.ok(approached(view, 1e9).distance < 100);
  close(shifted(view, 0.5, 0).target[1], 0);
  assert.ok(shifted(view, 0.5, 0).target[0] > 0);
});

test('places and what goes on are told in words', () => {
  assert.equal(placeText([0.12, -0.03, 0.001]), '12 cm right, 3 cm nearer');
  assert.equal(placeText([0, 0, 0]), 'in the middle');
  const poses = new Map([
    ['thing', at(0.2)],
    ['other', at(-0.2)],
  ]);
  assert.equal(objectNear([0.22, 0, 0], ['thing', 'other'], poses), 'thing');
  assert.equal(objectNear([0, 0, 0], ['thing', 'other'], poses), null);
  assert.equal(
    sceneSentence({
      objects: ['thing'],
      poses,
      pointing: [{who: 'human', target: [0.2, 0.01, 0]}],
      acts: [{program: 'lift(thing)', target: null}],
    }),
    'The human points at thing. The avatar carries out lift(thing). thing: 20 cm right.',
  );
});

test('geoms of MuJoCo become shapes of the same size, z up, those that look alike as one; what is none is left out', async () => {
  const THREE = await import(join(packages, 'three/build/three.module.js'));
  const extent = (shape) => {
    shape.computeBoundingBox();
    return [...shape.boundingBox.max].map((x) => +x.toFixed(3));
  };
  const of = (type, ...size) => extent(shapeOf(THREE, {type, size}));
  assert.deepEqual(of('capsule', 0.1, 0.5, 0), [0.1, 0.1, 0.6]);
  assert.deepEqual(of('cylinder', 0.1, 0.5, 0), [0.1, 0.1, 0.5]);
  assert.deepEqual(of('ellipsoid', 1, 2, 3), [1, 2, 3]);
  assert.deepEqual(of('box', 1, 2, 3), [1, 2, 3]);
  assert.deepEqual(of('plane', 3, 2, 0.1), [3, 2, 0]);
  assert.deepEqual(of('sphere', 2), [2, 2, 2]);
  assert.deepEqual(
    extent(shapeOf(THREE, {type: 'mesh', mesh: {vertices: [0, 0, 0, 1, 0, 0, 0, 2, 0], faces: [0, 1, 2, 0, 1, 9]}})),
    [1, 2, 0],
  );
  for (const bad of [
    null,
    {},
    {type: 'hfield'},
    {type: 'box', size: [1, -1, 1]},
    {type: 'box', size: 'x'},
    {type: 'mesh'},
    {type: 'mesh', mesh: {vertices: [1], faces: [0, 0, 0]}},
    {type: 'toString', size: [1, 1, 1]},
  ])
    assert.equal(shapeOf(THREE, bad), null);
  const half = Math.SQRT1_2;
  const red = [1, 0, 0, 1];
  const {bodies} = buildBodies(
    THREE,
    [
      {body: 'a', type: 'box', size: [1, 2, 3], rgba: red, pos: [0, 0, 1], quat: [half, 0, 0, half]},
      {body: 'a', type: 'sphere', size: [1], rgba: red, pos: [9, 0, 0]},
      {body: 'a', type: 'sphere', size: [1], rgba: [0, 0, 0, 0]},
      {body: 'b', type: 'sphere', size: [1]},
      null,
      {body: 7},
    ],
    () => new THREE.MeshBasicMaterial(),
  );
  assert.deepEqual(
    [...bodies].map(([name, body]) => [name, body.children.length]),
    [
      ['a', 1],
      ['b', 1],
    ],
  );
  assert.deepEqual(extent(bodies.get('a').children[0].geometry), [10, 1, 4]);
});

test('a ghost is seen from a millimetre on', () => {
  assert.equal(apart(at(0), at(0.0009)), false);
  assert.equal(apart(at(0), at(0.0011)), true);
  assert.equal(apart(at(0), at(0, 0.1)), true);
  assert.equal(
    apart(
      at(0),
      at(0).map((v) => -v),
    ),
    false,
  );
  const rounded = [0, 0, 0, 0.56398, -0.42652, -0.42652, -0.56398];
  assert.equal(apart(rounded, rounded), false);
});

/** The log of a run with physics, as recorded, and one of a log without a scene. */
const approved = logOf('paper/correction.physics');
const folder = temporaryFolder();
let server, drawing, blind;

before(async () => {
  writeFileSync(join(folder, 'cups.run.jsonl'), approved);
  const lines = approved.trimEnd().split('\n');
  const header = JSON.parse(lines[0]);
  writeFileSync(
    join(folder, 'sceneless.run.jsonl'),
    [JSON.stringify({...header, scene: null}), ...lines.slice(1)].join('\n') + '\n',
  );
  writeFileSync(join(folder, 'pointing.run.jsonl'), logOf('paper/correction'));
  server = await serve(folder);
  drawing = await Visitor.start(server.address, {webgl: true});
  blind = await Visitor.start(server.address);
});
after(async () => {
  await drawing?.close();
  await blind?.close();
  server?.stop();
});

const ready = '[data-testid=scene-stage][data-shows=drawing]';
/** How many of the canvas's pixels are not the background, right after a drawing. */
const pixels = (page) =>
  page.evaluate(() => {
    const {stage} = window.continua.page.panels.find((one) => one.stage);
    stage.drawing.draw();
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [stage.canvas.width, stage.canvas.height];
    const brush = copy.getContext('2d');
    brush.drawImage(stage.canvas, 0, 0);
    const {data} = brush.getImageData(0, 0, copy.width, copy.height);
    const colours = new Set();
    for (let i = 0; i < data.length; i += 4)
      if (data[i + 3]) colours.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
    return {colours: colours.size, seen: colours.size > 0};
  });
const stage = (page, what) =>
  page.evaluate((of) => {
    const {stage: one} = window.continua.page.panels.find((panel) => panel.stage);
    return of === 'draws' ? one.draws : of === 'view' ? one.view : [...one.drawing.poses.get(of)];
  }, what);

test('the scene is drawn where the log has it, and only when something changes', async () => {
  const page = await drawing.visit('/r/cups?n=9', {ready});
  await page.waitForFunction(() =>
    /cup/.test(document.querySelector('[data-testid=scene-canvas]').getAttribute('aria-label')),
  );
  assert.ok((await pixels(page)).colours > 50);
  assert.match(await drawing.at('scene-caption').innerText(), /The human points/);
  await page.waitForTimeout(400);
  const draws = await stage(page, 'draws');
  await page.waitForTimeout(400);
  assert.equal(await stage(page, 'draws'), draws);
  const records = approved
    .trimEnd()
    .split('\n')
    .map((line) => JSON.parse(line));
  const moved = records.filter(({kind, bodies}) => kind === 'pose' && bodies.cup);
  const last = moved.at(-1);
  await page.evaluate((n) => window.continua.cursor.jump(n), last.n);
  await page.waitForFunction(
    (x) => Math.abs(window.continua.page.panels.find((one) => one.stage).stage.drawing.poses.get('cup')[0] - x) < 1e-9,
    last.bodies.cup[0],
  );
  assert.deepEqual(await stage(page, 'cup'), last.bodies.cup);
  assert.deepEqual(drawing.complaints, []);
});

test('cameras, turning and objects are reached by keyboard', async () => {
  const page = await drawing.visit('/r/cups?n=9', {ready, reducedMotion: 'reduce'});
  const first = await stage(page, 'view');
  await page.locator('[data-camera=above]').focus();
  await page.keyboard.press('Enter');
  await page.waitForFunction(
    () => document.querySelector('[data-camera=above]').getAttribute('aria-pressed') === 'true',
  );
  const above = await stage(page, 'view');
  assert.ok(above.elevation < first.elevation);
  const n = await drawing.n();
  await drawing.at('scene-canvas').focus();
  await page.keyboard.press('ArrowLeft');
  assert.ok((await stage(page, 'view')).azimuth < above.azimuth);
  assert.equal(await drawing.n(), n, 'arrows turn the scene while it has the focus');
  assert.equal(await page.locator('[data-camera=above]').getAttribute('aria-pressed'), 'false');
  await drawing.at('panel-scene').locator('summary').click();
  await drawing.at('scene-places').getByText('knife').click();
  assert.match(await drawing.at('scene-caption').innerText(), /^the knife: 12 cm right, 9 cm nearer/);
  assert.equal(await page.locator('.tag').innerText(), 'knife');
  await page.locator('[data-toggle=labels]').click();
  await page.waitForFunction(() => document.querySelectorAll('.tag').length === 4);
});

test('a click on an object selects it', async () => {
  const page = await drawing.visit('/r/cups?n=9', {ready, viewport: {width: 1600, height: 1000}});
  await page.locator('[data-toggle=labels]').click();
  await page.locator('.tag', {hasText: /^white plate$/}).waitFor();
  const [x, y] = await page.evaluate(() => {
    const {drawing: one} = window.continua.page.panels.find((panel) => panel.stage).stage;
    return one.project(one.poses.get('plate').slice(0, 3));
  });
  await drawing.at('scene-canvas').click({position: {x, y}});
  await page.waitForFunction(() =>
    /^the white plate: /.test(document.querySelector('[data-testid=scene-caption]').textContent),
  );
});

test('another run appears as a ghost where it is elsewhere', async () => {
  const page = await drawing.visit('/r/cups?n=9', {ready});
  const shown = await page.evaluate(async () => {
    const {client, panels} = window.continua.page;
    const scene = panels.find((one) => one.stage);
    const moved = {
      scene: () => client.scene(),
      poses: async (from, to) => {
        const answer = await client.poses(from, to);
        answer.start.plate = answer.start.plate.map((value, i) => (i === 0 ? value + 0.1 : value));
        return answer;
      },
    };
    await scene.ghost({client: moved, timeOf: (n) => window.continua.page.data.t[n]});
    const {drawing: one} = scene.stage;
    for (let i = 0; i < 100 && !one.ghost.built.bodies.get('plate').visible; ++i)
      await new Promise((done) => setTimeout(done, 30));
    const names = [...one.ghost.built.bodies].filter(([, body]) => body.visible).map(([name]) => name);
    await scene.ghost(null);
    return [names, one.ghost];
  });
  assert.deepEqual(shown, [['plate'], null]);
  assert.deepEqual(drawing.complaints, []);
});

test('when the context is lost pictures take over; what was opened is closed', async () => {
  const page = await drawing.visit('/r/cups?n=9', {ready});
  await page.evaluate(() =>
    document
      .querySelector('[data-testid=scene-canvas]')
      .getContext('webgl2')
      .getExtension('WEBGL_lose_context')
      .loseContext(),
  );
  await page.waitForSelector('[data-testid=scene-picture], [data-testid=scene-no-picture]');
  await page.evaluate(() => window.continua.model.open('sceneless'));
  await page.waitForSelector('[data-testid=scene-missing]');
  assert.match(await drawing.at('scene-missing').innerText(), /no scene/);
});

test('three is not loaded before the page was painted, and not at all without WebGL', async () => {
  const asked = [];
  const page = await blind.visit('/', {ready: null});
  page.on('request', (request) => asked.push(new URL(request.url()).pathname));
  await page.goto(`${server.address}/r/cups?n=9`);
  await page.waitForSelector('[data-testid=scene-stage][data-shows=pictures]');
  await page.waitForSelector('[data-testid=scene-picture], [data-testid=scene-no-picture]');
  assert.deepEqual(
    asked.filter((path) => /three/.test(path)),
    [],
  );
  assert.match(
    asked.find((path) => path.endsWith('/frame')),
    /cups/,
  );
  if (await blind.at('scene-picture').count())
    await page.waitForFunction(() => /cup/.test(document.querySelector('[data-testid=scene-picture]').alt));
});

test('where the server cannot draw either, a sentence says so', async () => {
  const page = await blind.visit('/', {ready: null});
  await page.route('**/frame?*', (route) =>
    route.fulfill({
      status: 501,
      contentType: 'application/json',
      body: '{"error":{"message":"pictures cannot be drawn on this machine"}}',
    }),
  );
  await page.goto(`${server.address}/r/cups?n=9`);
  await page.waitForSelector('[data-testid=scene-no-picture]');
  assert.match(
    await blind.at('scene-no-picture').innerText(),
    /cannot be drawn here\. pictures cannot be drawn on this machine/,
  );
});

test('in the server’s pictures the human points in blue, as on the page', async () => {
  const {t} = recordsOf('paper/correction').find(({kind, event}) => kind === 'input' && event.target);
  const page = await blind.visit('/r/pointing');
  const counts = (at) =>
    page.evaluate(async (instant) => {
      const answer = await fetch(`/api/runs/pointing/frame?t=${instant}&size=640x360`);
      if (!answer.ok) return null;
      const picture = await createImageBitmap(await answer.blob());
      const pen = Object.assign(document.createElement('canvas'), {width: 640, height: 360}).getContext('2d');
      pen.drawImage(picture, 0, 0);
      const {data} = pen.getImageData(0, 0, 640, 360);
      const sum = {human: 0, avatar: 0};
      for (let i = 0; i < data.length; i += 4) {
        if (data[i + 2] > data[i] + 60 && data[i + 2] > 180) ++sum.human;
        if (data[i] > data[i + 2] + 90 && data[i + 1] > data[i + 2] + 60 && data[i] > 180) ++sum.avatar;
      }
      return sum;
    }, at);
  const [before_it, pointing] = [await counts(0), await counts(t + 0.1)];
  if (!pointing) return; // this machine draws none
  assert.ok(pointing.human > before_it.human + 20, JSON.stringify({before_it, pointing}));
  assert.ok(pointing.avatar <= before_it.avatar + 5, JSON.stringify({before_it, pointing}));
});

for (const colorScheme of ['light', 'dark'])
  test(`nothing stands in the way of access to the scene, ${colorScheme}`, async () => {
    const page = await drawing.visit('/r/cups?n=9', {ready, colorScheme, bypassCSP: true});
    await drawing.at('panel-scene').locator('summary').click();
    await page.locator('[data-toggle=labels]').click();
    await page.waitForTimeout(400);
    assert.deepEqual(
      (await drawing.violations()).filter((one) => /scene|stage|places|caption|tag/.test(one)),
      [],
    );
  });
