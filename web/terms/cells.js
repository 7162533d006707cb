// Finds the cell of the stack that a name like '5.action' means while symbols come and go. Pure; knows no page.

const idOf = (key) => Number(String(key).split('.', 1)[0]);
/** The slot that such a name names. */
export const slotOf = (key) => String(key).slice(String(key).indexOf('.') + 1);

/** How the selection names a cell that the server tells of. */
export const keyOf = (cell) => `${cell.symbol}.${cell.slot}`;

export class CellTracker {
  #key = null;
  #symbols = new Set();

  /** The one of the server's `cells` that `key` means, or null: its symbol may have been rewritten since, or not yet. */
  find(cells, key) {
    if (!key) return null;
    if (key !== this.#key) {
      this.#key = key;
      this.#symbols = new Set([idOf(key)]);
    }
    const slot = slotOf(key);
    const found = (cells ?? []).find((cell) => cell.slot === slot && cell.symbols?.some((id) => this.#symbols.has(id)));
    for (const id of found?.symbols ?? []) this.#symbols.add(id);
    return found ?? null;
  }
}
