// The queries of replay/queries over the tables of the shipped runs, in DuckDB.
//   CONTINUA=build/continua CONTINUA_NODE_MODULES=… node queries_test.mjs
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, readdirSync, rmSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const source = join(dirname(fileURLToPath(import.meta.url)), '../../..');
const modules = process.env.CONTINUA_NODE_MODULES ?? '';
let duckdb;
try {
  duckdb = createRequire(join(modules, 'x.js'))('@duckdb/node-api');
} catch (problem) {
  console.log(`@duckdb/node-api is missing: skipped (${problem.code ?? problem})`);
  process.exit(77);
}

// Facts of the shipped runs that each query must find; `row` is the first that the query gives.
const expected = {
  latency: (rows) => rows.some((row) => row.act === 'put' && row.times > 10n && row.median_s >= 0),
  machine_versions: (rows) => rows.some((row) => row.machine_name === 'diana2018' && row.done > 0n),
  questions_per_command: (rows) => rows.some((row) => row.run.endsWith('building_blocks') && row.questions > 5n),
  refused_inputs: (rows) => rows[0].times > 1n && rows[0].state && rows[0].input,
  unknown_words: (rows) => rows.length > 0 && rows.every((row) => row.word && row.example),
};

const folder = mkdtempSync(join(tmpdir(), 'tables'));
let faults = 0;
const complain = (sentence) => {
  console.error(sentence);
  faults += 1;
};
try {
  execFileSync(process.env.CONTINUA, ['table', join(source, 'traces'), '-o', folder], {stdio: 'inherit'});
  const connection = await (await duckdb.DuckDBInstance.create(':memory:')).connect();
  const rowsOf = async (sql) => (await connection.runAndReadAll(sql)).getRowObjects();
  await connection.run(`set file_search_path = '${folder}'`);
  await connection.run(readFileSync(join(folder, 'load.sql'), 'utf8'));
  for (const table of readdirSync(folder).filter((file) => file.endsWith('.jsonl'))) {
    const lines = readFileSync(join(folder, table), 'utf8').split('\n').length - 1;
    const name = table.replace('.jsonl', '');
    const [{count}] = await rowsOf(`select count(*) as count from "${name}"`);
    if (Number(count) !== lines) complain(`${table}: ${lines} lines, ${count} rows`);
    const csv = join(folder, `${name}.csv`);
    const [{cells}] = await rowsOf(
      `select count(*) as cells from read_csv('${csv}', header = true, all_varchar = true)`,
    );
    if (Number(cells) !== lines) complain(`${name}.csv: ${lines} lines, ${cells} rows`);
  }
  const queries = readdirSync(join(source, 'replay/queries')).filter((file) => file.endsWith('.sql'));
  for (const query of queries) {
    const rows = await rowsOf(readFileSync(join(source, 'replay/queries', query), 'utf8'));
    const holds = expected[query.replace('.sql', '')];
    if (!holds) complain(`${query}: this test expects nothing of it`);
    else if (!holds(rows))
      complain(
        `${query}: ${rows.length} rows, the first ${JSON.stringify(rows[0], (_, v) => (typeof v === 'bigint' ? Number(v) : v))}`,
      );
  }
  console.log(`${queries.length} queries, ${faults} faults`);
} finally {
  rmSync(folder, {recursive: true});
}
process.exit(faults ? 1 : 0);
