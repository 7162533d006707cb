// The program serving runs and a real browser looking at them, for the tests of the page. Where that cannot be had the
// test ends with status 77: skipped.
import {execFileSync, spawn} from 'node:child_process';
import {existsSync, mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {dirname, extname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

export const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
export const program = process.env.CONTINUA ?? join(root, 'build/continua');
const chromium_path = process.env.CHROMIUM || '/usr/bin/chromium';
export const packages = process.env.CONTINUA_NODE_MODULES ?? join(root, 'build/tests/web/npm/node_modules');

/** Ends the test as skipped. */
export function skip(why) {
  console.log(`skipped: ${why}`);
  process.exit(77);
}
if (!existsSync(program)) skip(`${program} is not built`);
if (!existsSync(chromium_path)) skip(`there is no browser at ${chromium_path}`);
if (!existsSync(join(packages, 'playwright-core'))) skip(`playwright-core is not in ${packages}`);
const require = createRequire(resolve(packages, 'x.js'));
const {chromium} = require('playwright-core');
const axe = readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');

/** A new folder, gone at the end of the process. */
export function temporaryFolder() {
  const folder = mkdtempSync(join(tmpdir(), 'continua-page-'));
  process.on('exit', () => rmSync(folder, {recursive: true, force: true}));
  return folder;
}

/** The log of a run below traces/, by the name of its file without ending, with all its documents in it. */
export const logOf = (run) =>
  execFileSync(program, ['export', join(root, 'traces', `${run}.run.jsonl`), '--to', 'jsonl'], {
    encoding: 'utf8',
    maxBuffer: 2 ** 30,
  });
/** Its records. */
export const recordsOf = (run) =>
  logOf(run)
    .split('\n')
    .filter(Boolean)
    .map((line) => JSON.parse(line));
/** The number of the first record that is wanted. */
export const numberOf = (run, wanted) => recordsOf(run).find(wanted).n;

/** `continua serve` of these paths; an object among them: {env} of the server. @returns {Promise<{address: string, pid: number, stop(): void}>} */
export async function serve(...paths) {
  const words = paths.filter((path) => typeof path === 'string');
  const {env = process.env} = paths.find((path) => typeof path === 'object') ?? {};
  const server = spawn(program, ['serve', ...words, '--port', '0'], {env, stdio: ['ignore', 'pipe', 'inherit']});
  const address = await new Promise((resolve, reject) => {
    let said = '';
    server.stdout.on('data', (part) => {
      said += part;
      const found = /http:\/\/[\d.]+:\d+/.exec(said);
      if (found) resolve(found[0]);
    });
    server.on('exit', () => reject(new Error(`the server ended: ${said}`)));
  });
  return {address, pid: server.pid, stop: () => server.kill()};
}

// While the page is being worked on, CONTINUA_WEB names the folder its files are taken from instead of the program.
const from_disk = process.env.CONTINUA_WEB;
const media = {'.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml'};
async function serveFromDisk(route, address) {
  const {pathname} = new URL(route.request().url());
  const file = join(from_disk, /^\/(r\/|diff\/|live(\/|$)|$)/.test(pathname) ? 'index.html' : pathname);
  if (!route.request().url().startsWith(address) || pathname.startsWith('/api/') || !existsSync(file))
    return route.fallback();
  return route.fulfill({body: readFileSync(file), contentType: media[extname(file)]});
}

const patience_ms = 60000; // machines that do much else at the time are slow

/** A browser that visits one server, and what its page complains of. */
export class Visitor {
  /** `webgl`: with WebGL, drawn without a graphics card; `words`: more words for the browser. */
  static async start(address, {webgl = false, words = []} = {}) {
    const visitor = new Visitor();
    visitor.address = address;
    visitor.launch = () =>
      chromium.launch({
        executablePath: chromium_path,
        args: [
          '--no-sandbox',
          '--disable-background-networking',
          '--no-first-run',
          '--disable-component-update',
          '--disable-sync',
          ...words,
          ...(webgl
            ? ['--use-angle=swiftshader', '--enable-unsafe-swiftshader']
            : ['--disable-gpu', '--disable-3d-apis']),
        ],
      });
    return visitor;
  }

  // A page as in a browser's first visit, but for the files that the browser has: they are a fifth of a page's cost.
  async #newPage(options) {
    this.browser ??= await this.launch();
    const wanted = JSON.stringify(options);
    const served = this.address.startsWith('http');
    if (!served || !this.context || this.options !== wanted) {
      await this.context?.close();
      this.context = await this.browser.newContext({viewport: {width: 1280, height: 720}, ...options});
      this.options = wanted;
      return this.context.newPage();
    }
    await this.page.close();
    await this.context.clearCookies();
    await this.context.clearPermissions();
    await this.context.setOffline(false);
    const page = await this.context.newPage();
    const session = await this.context.newCDPSession(page);
    await session.send('Storage.clearDataForOrigin', {origin: this.address, storageTypes: 'local_storage'});
    await session.detach();
    return page;
  }

  /** A fresh page at this address once `ready` is there. `complaints` gathers all that a good page does not do. */
  async visit(path, {ready = '[data-ready]', ...options} = {}) {
    this.page = await this.#newPage(options);
    this.page.setDefaultTimeout(patience_ms);
    this.complaints = [];
    const {page, complaints} = this;
    page.on('console', (message) => {
      if (['error', 'warning'].includes(message.type())) complaints.push(message.text());
    });
    page.on('pageerror', (problem) => complaints.push(problem.stack));
    page.on('request', (request) => {
      if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(this.address))
        complaints.push(`asked ${request.url()}`);
    });
    if (from_disk)
      await page.route(
        (url) => !url.pathname.startsWith('/api/'),
        (route) => serveFromDisk(route, this.address),
      );
    await page.goto(this.address + path);
    if (ready) await page.waitForSelector(ready, {state: 'attached'});
    return page;
  }

  at(id) {
    return this.page.locator(`[data-testid=${id}]`);
  }
  n() {
    return this.page.evaluate(() => window.continua.model.selection.n);
  }
  async query(name) {
    return new URL(await this.page.evaluate(() => location.href)).searchParams.get(name);
  }
  /** Waits until the address says so: it is written a little after the fact. */
  addressSays(name, value) {
    return this.page.waitForFunction(
      ([key, wanted]) => new URL(location.href).searchParams.get(key) === wanted,
      [name, String(value)],
    );
  }
  /** The faults that axe finds in the page as it is, in short; also targets below 24 px. `options` are those of axe's run. REQUIRES a visit with bypassCSP. */
  async violations(options = {rules: {'target-size': {enabled: true}}}) {
    await this.page.evaluate(axe);
    const {violations} = await this.page.evaluate(
      (those) => window.axe.run({resultTypes: ['violations'], ...those}),
      options,
    );
    return violations.map(({id, nodes}) => `${id}: ${nodes.map((node) => node.html).slice(0, 3)}`);
  }
  /** Draws a stretch over most of the timeline, with Shift. */
  async selectStretch() {
    const {keyboard, mouse} = this.page;
    await this.at('timeline').scrollIntoViewIfNeeded();
    const {x, y, width} = await this.at('timeline').boundingBox();
    await keyboard.down('Shift');
    await mouse.move(x + 120, y + 40);
    await mouse.down();
    await mouse.move(x + width - 40, y + 40, {steps: 4});
    await mouse.up();
    await keyboard.up('Shift');
    await this.at('stretch').waitFor();
  }
  async close() {
    await this.browser?.close();
  }
}

/** A visitor of a server of its own for these runs, until test `t` ends, whichever way. */
export async function guestOf(t, runs) {
  const server = await serve(runs);
  t.after(server.stop);
  const guest = await Visitor.start(server.address);
  t.after(() => guest.close());
  return guest;
}
