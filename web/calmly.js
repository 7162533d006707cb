// Slows down work that is too expensive for every frame of scrubbing.

/** `act` as a function that runs at most once in `ms`: at once if it can, else later with its latest arguments. */
export function calmly(act, ms) {
  let last = -Infinity;
  let timer = 0;
  let latest = null;
  return (...values) => {
    latest = values;
    if (timer) return;
    const wait = last + ms - performance.now();
    const now = () => {
      timer = 0;
      last = performance.now();
      act(...latest);
    };
    if (wait <= 0) now();
    else timer = setTimeout(now, wait);
  };
}
