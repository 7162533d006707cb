// Small helpers for building the page from data. Text is always text: nothing here parses markup.

const SVG = 'http://www.w3.org/2000/svg';

function fill(element, props, children) {
  for (const [name, value] of Object.entries(props ?? {})) {
    if (value === null || value === undefined || value === false) continue;
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else if (name === 'style') for (const [key, text] of Object.entries(value)) element.style.setProperty(key, text);
    else element.setAttribute(name, value === true ? '' : value);
  }
  element.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== false));
  return element;
}

/** An HTML element. Properties named on… listen; null and false ones are left out. */
export const h = (tag, props, ...children) => fill(document.createElement(tag), props, children);

/** An SVG element. */
export const s = (tag, props, ...children) => fill(document.createElementNS(SVG, tag), props, children);

/** A term as people read it: λ for the backslash of the files. */
export const shown = (term) => String(term ?? '').replaceAll('\\', 'λ');

/** The same in brief: numbers to two decimals. */
export const brief = (term) => shown(term).replace(/-?\d+\.\d{3,}/g, (number) => Number(number).toFixed(2));

/** A value of the log as text. */
export const text = (value) => shown(typeof value === 'string' ? value : value === null ? 'null' : JSON.stringify(value));

/** Seconds as "12.480 s". */
export const seconds = (t) => `${t.toFixed(3)} s`;

/** Seconds as "8:23". */
export function clock(t) {
  const whole = Math.floor(t);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, '0')}`;
}

/** 27607 as "27,607". */
export const grouped = (number) => number.toLocaleString('en');

/** "1 act", "13 acts" */
export const counted = (number, one, many = `${one}s`) => `${grouped(number)} ${number === 1 ? one : many}`;

/** The frame of a panel: heading, controls beside it, and a body. */
export function panel(name, title, controls, body) {
  return h('section', {class: `panel ${name}`, 'aria-label': title, 'data-testid': `panel-${name}`},
    h('header', {}, h('h2', {}, title), h('div', {class: 'controls'}, controls)), body);
}
