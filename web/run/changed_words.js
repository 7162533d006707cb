// Two texts by their words: those that they share at both ends, and those that differ between. Pure.

/** {before, a, b, after}: `before + a + after` is the first text, `before + b + after` the second. */
export function changedWords(a, b) {
  const [one, other] = [a, b].map((text) => text.split(/(?<=\s)/));
  const shortest = Math.min(one.length, other.length);
  let before = 0;
  while (before < shortest && one[before] === other[before]) ++before;
  let after = 0;
  while (after < shortest - before && one.at(-1 - after) === other.at(-1 - after)) ++after;
  const middle = (words) => words.slice(before, words.length - after).join('');
  return {
    before: one.slice(0, before).join(''),
    a: middle(one),
    b: middle(other),
    after: one.slice(one.length - after).join(''),
  };
}
