#!/usr/bin/env node
// How long the start page of very many runs takes to be there, and how it scrolls, in a browser without a graphics card.
//
//   CONTINUA=build/continua node tests/bench/bench_start_page.mjs [NUMBER_OF_RUNS]
//
// The runs are copies of four short ones of traces/paper under other names. One line a figure; nothing is judged.
import {copyFileSync, mkdirSync, symlinkSync, utimesSync} from 'node:fs';
import {join} from 'node:path';
import {root, serve, temporaryFolder, Visitor} from '../web/support.mjs';

const count = Number(process.argv[2] ?? 3000);
if (!Number.isInteger(count) || count < 1) {
  console.error(`found ${process.argv[2]}; expected a number of runs`);
  process.exit(2);
}
const each_px = 600; // scrolled in a frame: a fast turn of the wheel
const kinds = ['correction', 'dialogue_gesture', 'disambiguation', 'one_breath'];
const in_a_folder = 250;
const begun_s = 1.6e9; // when the first of them was written

const folder = temporaryFolder();
symlinkSync(join(root, 'traces/documents'), join(folder, 'documents'));
for (let i = 0; i < count; ++i) {
  const session = join(folder, `series_${String(Math.floor(i / in_a_folder)).padStart(2, '0')}`);
  if (i % in_a_folder === 0) mkdirSync(session);
  const kind = kinds[i % kinds.length];
  const path = join(session, `${kind}_${String(i).padStart(5, '0')}.run.jsonl`);
  copyFileSync(join(root, `traces/paper/${kind}.run.jsonl`), path);
  utimesSync(path, begun_s + i, begun_s + i);
}

const told = (name, value, unit) => console.log(`  ${name.padEnd(46)} ${value.toFixed(0).padStart(8)} ${unit}`);
const paintOf = () =>
  visitor.page.evaluate(() => performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? NaN);
const rowsAt = () =>
  visitor.page.evaluate(async () => {
    while (!document.querySelector('[data-testid=run]')) await new Promise(requestAnimationFrame);
    return performance.now();
  });

/** Scrolls the page from its top to its end; milliseconds between its frames. */
const scrolled = () =>
  visitor.page.evaluate(
    (step) =>
      new Promise((done) => {
        const page = document.querySelector('.start');
        const frames = [];
        let last = null;
        const frame = (now) => {
          if (last !== null) frames.push(now - last);
          last = now;
          const before = page.scrollTop;
          page.scrollTop += step;
          if (page.scrollTop > before) requestAnimationFrame(frame);
          else done({frames, px: before});
        };
        page.scrollTop = 0;
        requestAnimationFrame(frame);
      }),
    each_px,
  );

const server = await serve(folder);
const visitor = await Visitor.start(server.address);
console.log(`the start page of ${count.toLocaleString('en')} runs`);
await visitor.visit('/');
told('first paint, while the runs are being read', await paintOf(), 'ms');
told('first rows, while the runs are being read', await rowsAt(), 'ms');
const began = performance.now();
for (let pending = true; pending; ) {
  await new Promise((done) => setTimeout(done, 500));
  const {runs} = await (await fetch(`${server.address}/api/runs`)).json();
  pending = runs.some((run) => run.pending);
}
told('until all are read', performance.now() - began, 'ms');
await visitor.visit('/');
told('first paint, when all are read', await paintOf(), 'ms');
told('first rows, when all are read', await rowsAt(), 'ms');
for (const way of ['the first scroll', 'the second scroll']) {
  const {frames, px} = await scrolled();
  const sorted = frames.toSorted((a, b) => a - b);
  told(
    `${way}, ${px.toLocaleString('en')} px, ${each_px} px a frame`,
    frames.reduce((sum, one) => sum + one, 0),
    'ms',
  );
  told('  a frame, median', sorted[Math.floor(sorted.length / 2)], 'ms');
  told('  a frame, longest', sorted.at(-1), 'ms');
}
const rows = await visitor.page.evaluate(() => document.querySelectorAll('[data-testid=run]').length);
told('rows in the page at the end', rows, '');
await visitor.close();
server.stop();
