// What is looked at: the run, the record, the stretch of time, the filter. The address is this state, written out;
// a link restores everything.

/**
 * @typedef {{run: string|null, n: number|null, zoom: [number, number]|null, filter: string, kind: string}} Selection
 */

/** @returns {Selection} */
export function parseAddress(address) {
  const url = new URL(address, 'http://localhost');
  const path = /^\/r\/([^/]+)\/?$/.exec(url.pathname);
  const n = /^\d+$/.test(url.searchParams.get('n') ?? '') ? Number(url.searchParams.get('n')) : null;
  const zoom = /^(-?\d+(?:\.\d+)?)\.\.(-?\d+(?:\.\d+)?)$/.exec(url.searchParams.get('z') ?? '');
  return {
    run: path ? decodeURIComponent(path[1]) : null,
    n,
    zoom: zoom && Number(zoom[1]) < Number(zoom[2]) ? [Number(zoom[1]), Number(zoom[2])] : null,
    filter: url.searchParams.get('filter') ?? '',
    kind: url.searchParams.get('kind') ?? '',
  };
}

/** @param {Selection} selection */
export function formatAddress({run, n, zoom, filter, kind}) {
  if (run === null) return '/';
  const parts = [];
  if (n !== null) parts.push(`n=${n}`);
  if (zoom) parts.push(`z=${+zoom[0].toFixed(3)}..${+zoom[1].toFixed(3)}`);
  if (kind) parts.push(`kind=${encodeURIComponent(kind)}`);
  if (filter) parts.push(`filter=${encodeURIComponent(filter)}`);
  return `/r/${encodeURIComponent(run)}${parts.length ? `?${parts.join('&')}` : ''}`;
}

const quiet_ms = 1500;   // steps closer together than this are one entry of the history
const write_ms = 250;    // the address is rewritten at most this often

export class Model {
  #listener;
  #last_step = -Infinity;
  #timer = 0;

  constructor(listener) {
    this.#listener = listener;
    this.selection = parseAddress(location.href);
    addEventListener('popstate', () => {
      clearTimeout(this.#timer);
      this.#timer = 0;
      const before = this.selection;
      this.selection = parseAddress(location.href);
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
      history.pushState(null, '', address);
    } else if (!this.#timer) {
      this.#timer = setTimeout(() => this.#flush(formatAddress(this.selection)), write_ms);
    }
    if (how === 'step') this.#last_step = now;
    this.#listener(before);
  }

  /** Fills in what the address left open, without a trace in the history. */
  settle(change) {
    this.selection = {...this.selection, ...change};
    history.replaceState(null, '', formatAddress(this.selection));
  }

  #flush(address) {
    clearTimeout(this.#timer);
    if (this.#timer) history.replaceState(null, '', address);
    this.#timer = 0;
  }
}
