// Light or dark: the system's choice, or the reader's, which is remembered.

const dark_system = matchMedia('(prefers-color-scheme: dark)');
const listeners = [];

const shownTheme = () => document.documentElement.dataset.theme ?? (dark_system.matches ? 'dark' : 'light');
const tell = () => listeners.forEach((listener) => listener());

/** Calls `listener()` whenever the colours may have changed. */
export function onTheme(listener) {
  listeners.push(listener);
}

/** A text that differs whenever the theme does. */
export const themeKey = () => `${document.documentElement.dataset.theme} ${dark_system.matches}`;

/** Applies the theme that the reader chose at an earlier visit. */
export function restoreTheme() {
  try {
    const theme = localStorage.getItem('theme');
    if (theme === 'dark' || theme === 'light') document.documentElement.dataset.theme = theme;
  } catch {
    /* storage may be off: the system's choice holds */
  }
}

export function toggleTheme() {
  const theme = shownTheme() === 'dark' ? 'light' : 'dark';
  document.documentElement.dataset.theme = theme;
  try {
    localStorage.setItem('theme', theme);
  } catch {
    /* storage may be off: the choice lasts for this page */
  }
  tell();
}

dark_system.addEventListener('change', tell);
