// The parts of a page: their weight is bounded, and no address of elsewhere is in them.
import assert from 'node:assert/strict';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {root, serve, Visitor} from './support.mjs';

const most_compressed = 700e3;
const namespaces = /^http:\/\/(www\.w3\.org\/|localhost$)/; // names, and the base of addresses without one: never asked for

let server, visitor, loaded;
before(async () => {
  server = await serve(join(root, 'traces/paper/correction.physics.run.jsonl'));
  visitor = await Visitor.start(server.address, {webgl: true});
  await visitor.visit('/r/correction.physics');
  await visitor.page.waitForFunction(() => window.continua.page.parts.scene.stage.drawing);
  loaded = await visitor.page.evaluate(() =>
    performance
      .getEntriesByType('resource')
      .map(({name, encodedBodySize}) => ({path: new URL(name).pathname, size: encodedBodySize}))
      .filter(({path}) => !path.startsWith('/api/')),
  );
});
after(async () => {
  await visitor?.close();
  server?.stop();
});

test('all that a run and its scene load stays within the budget', () => {
  const sizes = new Map(loaded.map(({path, size}) => [path, size]));
  assert.ok(sizes.size > 40 && sizes.has('/vendor/three.core.js'), [...sizes.keys()].join());
  const sum = [...sizes.values()].reduce((a, b) => a + b, 0);
  assert.ok(sum > 100e3 && sum < most_compressed, `${sum} bytes`);
});

test('nothing in it names an address elsewhere', async () => {
  for (const path of new Set(['/', ...loaded.map((one) => one.path)])) {
    const text = await (await fetch(server.address + path)).text();
    const outside = (text.match(/https?:\/\/[\w.-]+[\w/.-]*/g) ?? []).filter((address) => !namespaces.test(address));
    assert.deepEqual(outside, [], path);
  }
});

test('the page may load, run and send nothing but what its server gives', async () => {
  const policy = (await fetch(server.address)).headers.get('content-security-policy');
  assert.match(policy, /default-src 'none'/);
  assert.match(policy, /script-src 'self'(;|$)/);
  assert.doesNotMatch(policy, /unsafe|https?:|\*/);
  assert.deepEqual(visitor.complaints, []);
});
