#!/usr/bin/env node
// How long a browser without a graphics card takes to open a run, how it scrubs, and what memory its page takes.
//
//   CONTINUA=build/continua node tests/bench/bench_page.mjs RUN…
//
// Each figure stands next to that of the first run: give a small run first.
import {execFileSync} from 'node:child_process';
import {basename, dirname} from 'node:path';
import {serve, Visitor} from '../web/support.mjs';

const runs = process.argv.slice(2);
if (!runs.length) {
  console.error('which runs? RUN…');
  process.exit(2);
}

/** Megabytes of the process that shows the page: the largest of the browser's renderers. */
function memoryOf(browser) {
  const lines = execFileSync('ps', ['-eo', 'rss,args']).toString().split('\n');
  const renderers = lines
    .filter((line) => line.includes('--type=renderer'))
    .map((line) => Number(line.trim().split(/\s+/)[0]));
  return Math.max(0, ...renderers) / 1024;
}

const wait_prepared = 20000;
const rows = [];
for (const run of runs) {
  const server = await serve(run);
  const visitor = await Visitor.start(server.address);
  const id = await (async () => {
    for (let waited = 0; waited < wait_prepared; waited += 200) {
      const {
        runs: [one],
      } = await (await fetch(`${server.address}/api/runs`)).json();
      if (!one.pending) return one.id;
      await new Promise((done) => setTimeout(done, 200));
    }
    throw new Error(`${run} is not read in ${wait_prepared} ms`);
  })();
  await new Promise((done) => setTimeout(done, 3000));
  const page = await visitor.visit(`/r/${encodeURIComponent(id)}`);
  // Since the browser began to go there: something painted, all panels there, all of their answers come.
  const {paint, opened, settled} = await page.evaluate(() => ({
    paint: performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? NaN,
    opened: performance.getEntriesByName('built')[0].startTime,
    settled: performance.getEntriesByName('settled')[0].startTime,
  }));
  // The cursor is moved on every frame over the whole run, then the view is zoomed: the page's cost of each frame.
  const frames = await page.evaluate(
    () =>
      new Promise((done) => {
        const {cursor, data, parts} = window.continua.page;
        const costs = [];
        const count = 240;
        parts.lanes.all();
        let i = 0;
        let last = performance.now();
        const frame = (now) => {
          const began = performance.now();
          if (i < count / 2) cursor.select(Math.floor(((data.size * i) / count) * 2), 'slide');
          else parts.lanes.zoomBy(i % 20 < 10 ? 0.9 : 1 / 0.9);
          costs.push([performance.now() - began, now - last]);
          last = now;
          if (++i < count) requestAnimationFrame(frame);
          else done(costs);
        };
        requestAnimationFrame(frame);
      }),
  );
  const sorted = (k) => frames.map((one) => one[k]).sort((a, b) => a - b);
  const part = (list, share) => list[Math.floor((list.length - 1) * share)];
  const work = sorted(0);
  const between = sorted(1);
  rows.push({
    run: basename(run, '.run.jsonl'),
    records: await page.evaluate(() => window.continua.page.data.size),
    paint,
    opened,
    settled,
    work50: part(work, 0.5),
    work95: part(work, 0.95),
    fps: 1000 / part(between, 0.5),
    memory: memoryOf(visitor),
  });
  await visitor.close();
  server.stop();
}
const [first] = rows;
for (const row of rows) {
  console.log(`${row.run}: ${row.records.toLocaleString('en')} records`);
  for (const [name, unit, digits] of [
    ['paint', 'ms', 0],
    ['opened', 'ms', 0],
    ['settled', 'ms', 0],
    ['work50', 'ms', 2],
    ['work95', 'ms', 2],
    ['fps', '/s', 0],
    ['memory', 'MB', 0],
  ])
    console.log(
      `  ${name.padEnd(8)} ${row[name].toFixed(digits).padStart(8)} ${unit}   ${(row[name] / first[name]).toFixed(2)} ×`,
    );
}
