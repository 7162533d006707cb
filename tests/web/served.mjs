// A folder of runs, the program serving it, and a browser that looks at it, for as long as a test file runs.
import {after, before} from 'node:test';
import {serve, temporaryFolder, Visitor} from './support.mjs';

export const folder = temporaryFolder();
export let server, visitor;

/** `fill()` puts the runs into the folder; `options` of Visitor.start(). */
export function serveFolder(fill, options = {}) {
  before(async () => {
    await fill();
    server = await serve(folder);
    visitor = await Visitor.start(server.address, options);
  });
  after(async () => {
    await visitor?.close();
    server?.stop();
  });
}

export const at = (id) => visitor.at(id);
/** Resolves when the start page knows all runs. */
export const listed = () =>
  visitor.page.waitForFunction(
    () => document.querySelectorAll('[data-testid=run]').length && !/being read/.test(document.body.innerText),
  );
