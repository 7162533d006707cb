// The last change of a stack in words, and the stack before it. Pure; knows no page.

const asText = (value) => (typeof value === 'string' ? value : JSON.stringify(value));

const doings = {
  none: () => 'left as it was',
  push: () => 'push: a symbol was laid on top',
  push_each: () => 'push each: one symbol was laid on top for each element',
  pop: (many) =>
    many === 1 || typeof many !== 'number'
      ? 'pop: the top symbol was taken off'
      : `pop: ${many} symbols were taken off`,
  rewrite: () => 'rewrite: the top symbol was replaced',
  rewrite_each: () => 'rewrite each: the top symbol was replaced by one for each element',
  flush: () => 'flush: everything was taken off',
  correction: () => 'made anew from what was observed',
  pop_until: (condition) => `pop until ${asText(condition)}: what lay above was taken off`,
};

/** The operation of a transition or rewrite: {what, sets: [[slot, expression]]}. */
export function operationWords(operation) {
  const [name, content] =
    operation && typeof operation === 'object'
      ? (Object.entries(operation)[0] ?? [])
      : [asText(operation ?? 'none'), null];
  const sets =
    content && typeof content === 'object' && !Array.isArray(content) && name !== 'pop_until'
      ? Object.entries(content).map(([slot, value]) => [slot, value === null ? 'null' : asText(value)])
      : [];
  return {
    what:
      doings[name]?.(content) ??
      `${name ?? 'unknown operation'}${content === null || content === undefined ? '' : ` ${asText(content)}`}`,
    sets,
  };
}

/**
 * The stack as rows, top first: [{change, before: symbol|null, after: symbol|null}] with the symbols as {id, made,
 * slots: {name: value}}, and `folded`: how many at the end did not change and lie deeper than the first of them.
 */
export function stackRows({symbols = [], removed = []}) {
  const rows = removed.map((one) => ({change: 'removed', before: one, after: null}));
  for (const one of symbols) {
    const slots = {...one.slots};
    if (one.change === 'changed')
      for (const [slot, {was}] of Object.entries(one.slots_changed ?? {})) {
        if (was === null || was === undefined) delete slots[slot];
        else slots[slot] = was;
      }
    rows.push({change: one.change, before: one.change === 'added' ? null : {...one, slots}, after: one});
  }
  let same = 0;
  while (same < rows.length && rows[rows.length - 1 - same].change === 'same') ++same;
  const shown = same === rows.length ? 1 : 0; // the top of an untouched stack is shown
  return {rows, folded: same - shown >= 2 ? same - shown : 0};
}

/** 4.2 as "4.2 s ago", 0 as "just now". */
export const age = (seconds) =>
  seconds > 0.0005
    ? `${seconds < 10 ? +seconds.toFixed(2) : seconds < 100 ? seconds.toFixed(1) : Math.round(seconds)} s ago`
    : 'just now';
