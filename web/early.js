// Sends the requests that the address calls for while the page's modules are still on their way; run_client.js takes
// the answers.
const asked = (globalThis.continua_early = new Map());
const ask = (path) => asked.set(path, fetch(path));
const of_run = (id) => {
  for (const view of ['', '/graph', '/columns', '/media']) ask(`/api/runs/${id}${view}`);
};
const [, kind, a, b] = /^\/(r|diff)\/([^/]+)(?:\/([^/]+))?\/?$/.exec(location.pathname) ?? [];
if (kind === 'r') of_run(a);
else if (kind === 'diff' && b) {
  of_run(a);
  of_run(b);
  ask(`/api/diff?a=${a}&b=${b}`);
} else if (/^\/live(\/|$)/.test(location.pathname)) ask('/api/sessions');
else ask('/api/runs');
