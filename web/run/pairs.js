// Which runs can be compared: at a server any two, in a site those whose comparison is among its files.

/** The ids of two runs of fetchRuns() in the order in which they can be compared; null: they cannot. */
export function pairOf(a, b) {
  const holds = (one, other) => !one.compared || one.compared.some((comparison) => comparison.with === other.id);
  if (holds(a, b)) return [a.id, b.id];
  return holds(b, a) ? [b.id, a.id] : null;
}
