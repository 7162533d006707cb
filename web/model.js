// The selection: the run (and the run it is compared with), the record, the branch, the cell, the term, the stretch of
// time, the filter, the panel. The address is the selection, written out; a link restores everything.

/**
 * @typedef {{run: string|null, other: string|null, live?: string, nowhere?: string, n: number|null, branch: number|null, cell: string, term: string,
 *            zoom: [number, number]|null, gaps: boolean, by_time: boolean, filter: string, kind: string, panel: string, tab: string, hunk: number|null,
 *            search: string}} Selection
 * `run` null: the start page; `other`: the run B of a comparison; `live`: on the live page alone, its session, '' before there is one; `nowhere`: the path of an address that no page has; `gaps`: idle time is drawn at its full length; `by_time`: B's lanes stand at its own times, not where A has the same inputs;
 * `panel`: the one that fills the page; `tab`: the one in front where several share a place; `hunk`: the difference that is shown; `search`: of the start page.
 */

const whole = (text) => (/^\d+$/.test(text ?? '') ? Number(text) : null);

/** @returns {Selection} */
export function parseAddress(address) {
  const url = new URL(address, 'http://localhost');
  const query = url.searchParams;
  const path = /^\/(?:r\/([^/]+)|diff\/([^/]+)\/([^/]+))\/?$/.exec(url.pathname);
  const live = /^\/live(?:\/([^/]*))?\/?$/.exec(url.pathname);
  const part = (i) => (path?.[i] ? decoded(path[i]) : null);
  const zoom = /^(-?\d+(?:\.\d+)?)\.\.(-?\d+(?:\.\d+)?)$/.exec(query.get('z') ?? '');
  return {
    run: part(1) ?? part(2),
    other: part(3),
    ...(live && {live: decoded(live[1] ?? '')}),
    ...(!path && !live && !/^\/(index\.html)?$/.test(url.pathname) && {nowhere: decoded(url.pathname)}),
    n: whole(query.get('n')),
    branch: whole(query.get('b')),
    cell: query.get('cell') ?? '',
    term: query.get('term') ?? '',
    zoom: zoom && Number(zoom[1]) < Number(zoom[2]) ? [Number(zoom[1]), Number(zoom[2])] : null,
    gaps: query.get('gaps') === 'full',
    by_time: query.get('by') === 'time',
    filter: query.get('filter') ?? '',
    kind: query.get('kind') ?? '',
    panel: query.get('panel') ?? '',
    tab: query.get('tab') ?? '',
    hunk: whole(query.get('h')),
    search: query.get('q') ?? '',
  };
}

function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

/** @param {Selection} selection */
export function formatAddress({
  run,
  other,
  live,
  n,
  branch,
  cell,
  term,
  zoom,
  gaps,
  by_time,
  filter,
  kind,
  panel,
  tab,
  hunk,
  search,
}) {
  if (live !== undefined) return live ? `/live/${encodeURIComponent(live)}` : '/live';
  const parts = [];
  const add = (name, value) => {
    if (value !== null && value !== '' && value !== undefined)
      parts.push(`${name}=${encodeURIComponent(value).replaceAll('%2C', ',')}`);
  };
  const path =
    run === null
      ? '/'
      : other === null
        ? `/r/${encodeURIComponent(run)}`
        : `/diff/${encodeURIComponent(run)}/${encodeURIComponent(other)}`;
  if (run === null) add('q', search);
  else {
    add('h', hunk);
    add('n', n);
    add('b', branch);
    add('cell', cell);
    add('term', term);
    if (zoom) add('z', `${+zoom[0].toFixed(3)}..${+zoom[1].toFixed(3)}`);
    if (gaps) add('gaps', 'full');
    if (by_time) add('by', 'time');
    add('kind', kind);
    add('filter', filter);
    add('panel', panel);
    add('tab', tab);
  }
  return path + (parts.length ? `?${parts.join('&')}` : '');
}

/** The selection of a page that has just been opened on a run, or on two. @returns {Partial<Selection>} */
export const fresh = (run, other = null) => ({
  run,
  other,
  n: null,
  branch: null,
  cell: '',
  term: '',
  zoom: null,
  filter: '',
  kind: '',
  panel: '',
  tab: '',
  hunk: null,
});

const quiet_ms = 1500; // steps closer together than this are one entry of the history
const write_ms = 250; // the address is rewritten at most this often

// The address of an exported page, wherever it lies, has no place for all this but behind its '#'.
const recorded = globalThis.continua_recorded;
const here = () => (recorded ? location.hash.slice(1) || recorded.start : location.href);

/** The link to an address as of formatAddress(). */
export const linkTo = (address) => (recorded ? `#${address}` : address);

export class Model {
  #listener;
  #last_step = -Infinity;
  #timer = 0;

  constructor(listener) {
    this.#listener = listener;
    this.selection = parseAddress(here());
    addEventListener('popstate', () => {
      clearTimeout(this.#timer);
      this.#timer = 0;
      const before = this.selection;
      this.selection = parseAddress(here());
      this.#listener(before);
    });
  }

  /**
   * Changes part of the selection. `how`: 'jump' is a new entry of the history, 'step' only after a pause,
   * 'slide' (scrubbing, playing, zooming) never.
   */
  go(change, how = 'jump') {
    const before = this.selection;
    this.selection = {...before, ...change};
    const address = formatAddress(this.selection);
    if (address === formatAddress(before)) return;
    const now = performance.now();
    if (how === 'jump' || (how === 'step' && now - this.#last_step > quiet_ms)) {
      this.#flush(formatAddress(before));
      history.pushState(null, '', linkTo(address));
    } else if (!this.#timer) {
      this.#timer = setTimeout(() => this.#flush(formatAddress(this.selection)), write_ms);
    }
    if (how === 'step') this.#last_step = now;
    this.#listener(before);
  }

  /** Opens a run, or the comparison of two; null: the start page. */
  open(run, other = null) {
    this.go(fresh(run, other));
  }
  /** Lets the panel fill the page; if it does already, shows all again. */
  enlarge(panel) {
    this.go({panel: this.selection.panel === panel ? '' : panel});
  }

  /** Fills in what the address left open, without a trace in the history. */
  settle(change) {
    this.selection = {...this.selection, ...change};
    history.replaceState(null, '', linkTo(formatAddress(this.selection)));
  }

  #flush(address) {
    clearTimeout(this.#timer);
    if (this.#timer) history.replaceState(null, '', linkTo(address));
    this.#timer = 0;
  }
}
