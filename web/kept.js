// The reader's choice at an earlier visit. Where storage is off it lasts for the page.

/** {value, set(value)} of this name, a value of JSON; `otherwise` where nothing was kept. */
export function kept(name, otherwise) {
  const one = {
    value: otherwise,
    set(value) {
      one.value = value;
      try {
        localStorage.setItem(name, JSON.stringify(value));
      } catch {
        /* then only this page knows */
      }
    },
  };
  try {
    one.value = JSON.parse(localStorage.getItem(name)) ?? otherwise;
  } catch {
    /* as at a first visit */
  }
  return one;
}
