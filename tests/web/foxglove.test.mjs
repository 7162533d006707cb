// A run's MCAP file in Foxglove Studio, the last version that npm has: its 3D, Log and State Transitions panels show the
// run. The package is large, so that nobody gets it unasked:
//   npm install --prefix DIR --ignore-scripts @foxglove/studio-base@1.48.0 react@17 react-dom@17
//   CONTINUA_FOXGLOVE=DIR/node_modules ctest --preset release -R foxglove
// With CONTINUA_PICTURE=FILE.png the test keeps a picture of it.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {existsSync, readFileSync} from 'node:fs';
import {createServer} from 'node:http';
import {extname, join} from 'node:path';
import {after, before, test} from 'node:test';
import {program, recordsOf, root, temporaryFolder, Visitor} from './support.mjs';

const modules = process.env.CONTINUA_FOXGLOVE ?? '';
const studio = join(modules, '@foxglove/studio-base/assets');
if (!existsSync(join(studio, 'index.js'))) {
  console.log(
    'skipped: CONTINUA_FOXGLOVE names no folder with @foxglove/studio-base; foxglove.test.mjs says how to get it',
  );
  process.exit(77);
}

const run = 'mechanisms/sub_dialogues.physics';
const file = join(temporaryFolder(), 'run.mcap');
execFileSync(program, ['export', join(root, 'traces', `${run}.run.jsonl`), '--to', 'mcap', '-o', file]);

const records = recordsOf(run);
const least_picture_bytes = 6000;
const sidebar_button = [25, 30];

const layout = {
  configById: {
    '3D!run': {
      followTf: 'world',
      cameraState: {
        distance: 1.7,
        perspective: true,
        phi: 55,
        thetaOffset: 0,
        fovy: 45,
        near: 0.1,
        far: 100,
        target: [0, 0, 0],
        targetOffset: [0, 0.15, 0.2],
        targetOrientation: [0, 0, 0, 1],
      },
      scene: {transforms: {visible: false, showLabel: false, axisScale: 0, lineWidth: 0}},
      topics: {'/scene': {visible: true}},
    },
    'RosOut!run': {topicToRender: '/dialogue', minLogLevel: 1, searchTerms: []},
    'StateTransitions!run': {
      isSynced: true,
      paths: [
        {value: '/state.state', timestampMethod: 'receiveTime'},
        {value: '/avatar/act.status', timestampMethod: 'receiveTime'},
      ],
    },
  },
  globalVariables: {},
  userNodes: {},
  playbackConfig: {speed: 5},
  layout: {
    first: {first: '3D!run', second: 'RosOut!run', direction: 'row', splitPercentage: 52},
    second: 'StateTransitions!run',
    direction: 'column',
    splitPercentage: 72,
  },
};

// The page: Studio with this layout and the file, and nothing that it would ask of its makers.
const page = (address) => `<!doctype html><meta charset="utf-8"><title>run</title>
<style>html, body, #root {height: 100%; margin: 0; display: flex; flex: 1}</style><div id="root"></div>
<script>window.global = window; window.process = {env: {}};</script>
<script src="/react.js"></script><script src="/react-dom.js"></script>
<script>window.react = React; window['react-dom'] = ReactDOM;</script>
<script src="/studio/index.js"></script>
<script>
const settings = new Map([['colorScheme', 'light'], ['timezone', 'UTC'], ['hideSignInPrompt', true],
  ['ui.open-dialog-startup', false], ['telemetry.telemetryEnabled', false], ['telemetry.crashReportingEnabled', false]]);
const appConfiguration = {get: (key) => settings.get(key), set: async (key, value) => settings.set(key, value),
  addChangeListener() {}, removeChangeListener() {}};
const data = ${JSON.stringify(layout)};
const layouts = new Map([['run', {id: 'run', name: 'run', permission: 'CREATOR_WRITE', baseline: {data}}]]);
const layoutStorage = {list: async () => [...layouts.values()], get: async (_, id) => layouts.get(id),
  put: async (_, one) => (layouts.set(one.id, one), one), delete: async (_, id) => layouts.delete(id), importLayouts: async () => {}};
localStorage.setItem('studio.profile-data', JSON.stringify({currentLayoutId: 'run'}));
initI18n().then(() => ReactDOM.render(React.createElement(App, {
  appConfiguration, layoutStorage, dataSources: [new RemoteDataSourceFactory()], extensionLoaders: [], enableGlobalCss: true,
  deepLinks: ['${address}/?ds=remote-file&ds.url=${address}/run.mcap']}),
  document.getElementById('root')));
</script>`;

const media = {'.js': 'text/javascript', '.wasm': 'application/wasm', '.html': 'text/html', '.css': 'text/css'};
const places = {
  '/react.js': join(modules, 'react/umd/react.production.min.js'),
  '/react-dom.js': join(modules, 'react-dom/umd/react-dom.production.min.js'),
  '/run.mcap': file,
};
let server, address, visitor;
before(async () => {
  server = createServer((request, response) => {
    const {pathname} = new URL(request.url, address);
    if (pathname === '/') return response.setHeader('content-type', 'text/html').end(page(address));
    const path = places[pathname] ?? join(studio, pathname.replace('/studio/', ''));
    if (!existsSync(path)) return response.writeHead(404).end();
    const range = /bytes=(\d+)-(\d*)/.exec(request.headers.range ?? '');
    const bytes = readFileSync(path);
    const [from, to] = range ? [Number(range[1]), Number(range[2] || bytes.length - 1)] : [0, bytes.length - 1];
    response.writeHead(range ? 206 : 200, {
      'content-type': media[extname(path)] ?? 'application/octet-stream',
      'accept-ranges': 'bytes',
      'content-length': to - from + 1,
      ...(range ? {'content-range': `bytes ${from}-${to}/${bytes.length}`} : {}),
    });
    return response.end(bytes.subarray(from, to + 1));
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  address = `http://127.0.0.1:${server.address().port}`;
  visitor = await Visitor.start(address, {webgl: true});
});
after(async () => {
  await visitor?.close();
  server?.close();
});

// Waits until this part of the page is a picture: flat areas take few bytes.
async function waitForPicture(clip) {
  const {page: shown} = visitor;
  for (let tries = 0; (await shown.screenshot({clip})).length < least_picture_bytes; ++tries) {
    assert.ok(tries < 60, 'nothing is drawn');
    await shown.waitForTimeout(1000);
  }
}

test('the 3D, Log and State Transitions panels show the run', async () => {
  await visitor.visit('/', {ready: null});
  const {page: shown} = visitor;
  await shown.getByText('foxglove.FrameTransforms').waitFor({timeout: 120000});
  await waitForPicture({x: 430, y: 60, width: 380, height: 380}); // 3D, beside the list of topics
  await shown.mouse.click(...sidebar_button);
  const hint = shown.getByText('Open settings to configure');
  await hint
    .locator('..')
    .getByRole('button')
    .click({timeout: 5000})
    .catch(() => {});
  await shown.getByTitle('Play', {exact: true}).click();
  const last = records.findLast((record) => record.kind === 'utterance');
  await shown.waitForFunction((words) => document.body.innerText.includes(words), last.text, {timeout: 120000});
  await shown.getByTitle('Play', {exact: true}).waitFor({timeout: 120000}); // the end is reached
  const text = await shown.evaluate(() => document.body.innerText);
  for (const path of ['/state.state', '/avatar/act.status']) assert.ok(text.includes(path), text);
  await waitForPicture({x: 60, y: 60, width: 500, height: 380});
  await waitForPicture({x: 60, y: 490, width: 1200, height: 140});
  if (process.env.CONTINUA_PICTURE) await shown.screenshot({path: process.env.CONTINUA_PICTURE});
});
