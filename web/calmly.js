// For what is too dear to do on every frame of scrubbing.

/** `act`, done at once when it was not for `ms`; else when that long has passed, with what it was last called with. */
export function calmly(act, ms) {
  let last = -Infinity, timer = 0, latest = null;
  return (...values) => {
    latest = values;
    if (timer) return;
    const wait = last + ms - performance.now();
    const now = () => {
      timer = 0;
      last = performance.now();
      act(...latest);
    };
    if (wait <= 0) now(); else timer = setTimeout(now, wait);
  };
}
