// Small helpers for building the page from data. Text is always text: nothing here parses markup.

const SVG = 'http://www.w3.org/2000/svg';

function fill(element, props, children) {
  for (const [name, value] of Object.entries(props ?? {})) {
    if (value === null || value === undefined || value === false) continue;
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else if (name === 'style') for (const [key, text] of Object.entries(value)) element.style.setProperty(key, text);
    else element.setAttribute(name, value === true ? '' : value);
  }
  element.append(
    ...children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== false),
  );
  return element;
}

/** An HTML element. Properties named on… listen; null and false ones are left out. */
export const h = (tag, props, ...children) => fill(document.createElement(tag), props, children);

/** An SVG element. */
export const s = (tag, props, ...children) => fill(document.createElementNS(SVG, tag), props, children);

/** The address of the page's icon, which an exported file brings along. */
export const icon = () => globalThis.continua_recorded?.icon ?? '/icon.svg';

/** A term as people read it: λ for the backslash of the files. */
export const shown = (term) => String(term ?? '').replaceAll('\\', 'λ');

/** The same in brief: numbers to two decimals. */
export const brief = (term) => shown(term).replace(/-?\d+\.\d{3,}/g, (number) => Number(number).toFixed(2));

/** A value of the log as text. */
export const text = (value) =>
  shown(typeof value === 'string' ? value : value === null ? 'null' : JSON.stringify(value));

/** Seconds as "8:23", or with digits "8:23.480". Rounded to milliseconds before any are left out, so that all forms agree. */
export function clock(t, digits = 0) {
  const ms = Math.round(t * 1000);
  const [whole, rest] = [Math.floor(ms / 1000), ms - 1000 * Math.floor(ms / 1000)];
  const part = digits ? `.${String(rest).padStart(3, '0').slice(0, digits)}` : '';
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, '0')}${part}`;
}

/** An instant of a run to the millisecond. */
export const instant = (t) => clock(t, 3);

/** 27607 as "27,607". */
export const grouped = (number) => number.toLocaleString('en');

/** "1 act", "13 acts" */
export const counted = (number, one, many = `${one}s`) => `${grouped(number)} ${number === 1 ? one : many}`;

/** A dialog that a click beside it closes. */
export function dialog(props, ...children) {
  const element = h('dialog', props, ...children);
  element.addEventListener('click', (event) => {
    if (event.target === element) element.close();
  });
  return element;
}

/** Calls `act()` on a click, Enter and Space: for parts of a picture that work like a button. */
export function pressable(element, act) {
  element.addEventListener('click', act);
  element.addEventListener('keydown', (event) => {
    if (event.key !== 'Enter' && event.key !== ' ') return;
    event.preventDefault();
    event.stopPropagation();
    act();
  });
  return element;
}

/** Sets the text of an element where it has another: an equal one would be spoken again. */
export function put(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

/** The frame of a panel: heading, controls beside it, a button that lets it fill the page, and a body. */
export function panel(name, title, controls, body) {
  const larger = h(
    'button',
    {
      type: 'button',
      class: 'larger',
      title: 'Larger or smaller (Enter on the heading)',
      'aria-label': `Enlarge ${title}`,
      'aria-pressed': 'false',
      onclick: (event) =>
        event.target.dispatchEvent(
          new CustomEvent('enlarge', {bubbles: true, detail: event.target.closest('.panel').dataset.panel}),
        ),
    },
    '⤢',
  );
  return h(
    'section',
    {class: `panel ${name}`, 'aria-label': title, 'data-testid': `panel-${name}`, 'data-panel': name},
    h('header', {}, h('h2', {}, title), h('div', {class: 'controls'}, controls, larger)),
    body,
  );
}

/** Panels in one place, one of them in sight: {element, has(name), show(name)}. `chosen(name)` is called when a tab is chosen. */
export function tabs(name, panels, chosen) {
  const tab = (one, i) =>
    h(
      'button',
      {
        type: 'button',
        role: 'tab',
        id: `tab-${one.dataset.panel}`,
        'aria-controls': `body-${one.dataset.panel}`,
        'data-testid': `tab-${one.dataset.panel}`,
        onclick: () => chosen(one.dataset.panel),
        onkeydown: (event) => {
          const by = {ArrowRight: 1, ArrowLeft: -1}[event.key];
          if (!by) return;
          event.preventDefault();
          event.stopPropagation();
          const next = (i + by + panels.length) % panels.length;
          chosen(panels[next].dataset.panel);
          buttons[next].focus();
        },
      },
      one.getAttribute('aria-label'),
    );
  const buttons = panels.map(tab);
  panels.forEach((one) => {
    one.id = `body-${one.dataset.panel}`;
    one.setAttribute('role', 'tabpanel');
  });
  const element = h(
    'div',
    {class: `tabs ${name}`},
    h('div', {role: 'tablist', 'aria-label': 'More about the record'}, buttons),
    panels,
  );
  return {
    element,
    has: (wanted) => panels.some((one) => one.dataset.panel === wanted),
    show(wanted) {
      const shown = panels.some((one) => one.dataset.panel === wanted) ? wanted : panels[0].dataset.panel;
      panels.forEach((one, i) => {
        const on = one.dataset.panel === shown;
        one.hidden = !on;
        buttons[i].setAttribute('aria-selected', String(on));
        buttons[i].tabIndex = on ? 0 : -1;
      });
    },
  };
}
