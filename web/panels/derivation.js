// How the term behind the record (or behind the chosen cell of the stack) came about: a tree of applications, from the
// words and gestures up, in words, as λ-terms or in continuation-passing style, with the steps of working it out.
import {h, s, panel, shown} from '../dom.js';
import {Latest} from '../terms/latest.js';
import {CellTracker, keyOf} from '../terms/cells.js';
import {Printer} from '../terms/term.js';
import {depths, described, isHole, line, nodeAt, sources, stepsAt, told} from '../terms/derivation.js';
import {arrowsTo} from '../terms/arrows.js';

const depth_names = {gloss: 'words', 'λ': 'λ', CPS: 'CPS'};
const depth_titles = {gloss: 'words: what was said and shown', 'λ': 'λ-notation', CPS: 'CPS: continuation-passing style'};
const shorter = (number) => number.replace(/-?\d+\.\d{3,}/g, (one) => String(+Number(one).toFixed(3)));

export function mountDerivation(app) {
  const subject = h('p', {class: 'subject', 'data-testid': 'subject'});
  const bar = h('div', {class: 'step-bar', 'data-testid': 'steps', hidden: true});
  const expression = h('code', {class: 'expression', 'data-testid': 'expression', hidden: true});
  const chips = h('ul', {class: 'chips', 'data-testid': 'chips', 'aria-label': 'Words and gestures it came from'});
  const tree = h('ul', {class: 'tree', role: 'tree', 'aria-label': 'Derivation', 'data-testid': 'tree'});
  const curves = s('svg', {class: 'curves', 'aria-hidden': 'true'});
  const inner = h('div', {class: 'inner'}, h('div', {class: 'about'}, subject, bar), expression, chips, tree, curves);
  const body = h('div', {class: 'terms', tabindex: 0, role: 'region', 'aria-label': 'Term'}, inner);
  const chosen = h('p', {class: 'chosen-node', 'data-testid': 'node', hidden: true});
  const tracker = new CellTracker();
  const buttons = depths.map((one) => h('button', {type: 'button', 'data-testid': `depth-${depth_names[one]}`, 'aria-label': depth_titles[one], title: depth_titles[one], onclick: () => setDepth(one)}, depth_names[one]));
  const group = h('div', {class: 'depths', role: 'group', 'aria-label': 'Depth (Alt+↑, Alt+↓)'}, buttons);
  let depth = 'gloss', found = null, root = null, states = [], place = 0;

  const jump = (n, words = `#${n}`) => h('button', {type: 'button', class: 'link', onclick: () => app.jump(n)}, words);

  function setDepth(to) {
    depth = to;
    draw();
  }
  const depthBy = (by) => setDepth(depths[Math.max(0, Math.min(depths.length - 1, depths.indexOf(depth) + by))]);
  const stepBy = (by) => {
    place = Math.max(0, Math.min(states.length - 1, place + by));
    drawSteps();
  };

  const onKeys = (event) => {
    if (!event.altKey || event.ctrlKey || event.metaKey || event.target.closest?.('dialog')) return;
    const up = {ArrowUp: -1, ArrowDown: 1}[event.key], along = {ArrowLeft: -1, ArrowRight: 1}[event.key];
    if (!root || (!up && !(along && states.length > 1))) return;
    event.preventDefault();
    if (up) depthBy(up); else stepBy(along);
  };
  document.addEventListener('keydown', onKeys);

  const drawSteps = () => {
    bar.hidden = expression.hidden = states.length < 2;
    if (bar.hidden) return;
    const {term, redex, rule, haskell} = states[place], last = place === states.length - 1;
    const held = document.activeElement?.dataset?.by;
    const button = (by, sign, label) => h('button', {type: 'button', 'data-by': by, 'aria-label': label, 'aria-disabled': String(by < 0 ? place === 0 : last), onclick: () => stepBy(by)}, sign);
    bar.replaceChildren(button(-1, '‹', 'Step back (Alt+←)'), button(1, '›', 'Step on (Alt+→)'),
      h('span', {'data-testid': 'step', role: 'status'}, `${place} of ${states.length - 1}${last ? ': worked out' : `: next ${rule}`}`));
    expression.replaceChildren(...new Printer({sign: 'λ', mark: redex, haskell}).pieces(term).map(({text, marked}) => (marked ? h('mark', {class: 'redex'}, shorter(text)) : shorter(text))));
    if (held) bar.querySelector(`[data-by="${held}"]`)?.focus();
  };

  const item = (node, path, level, role) => {
    const {text, type} = line(node, depth), below = Array.isArray(node.children) ? node.children.filter((one) => one && typeof one === 'object') : [];
    const roles = depth === 'CPS' && node.how === 'application' ? ['m', 'n'] : [];
    const from = isHole(node) ? node.origin.text : told(node.origin);
    return h('li', {role: 'none'},
      h('div', {role: 'treeitem', class: `node-line ${isHole(node) ? 'hole' : node.how}`, 'aria-level': level, 'aria-selected': 'false', 'aria-expanded': below.length ? 'true' : null, tabindex: -1, 'data-path': path},
        role && h('span', {class: 'role'}, role), h('span', {class: 'term'}, isHole(node) && depth !== 'gloss' ? `▢ ${shorter(text)}` : shorter(text)), isHole(node) && h('span', {class: 'unseen'}, 'open'),
        type && h('span', {class: 'type'}, h('span', {class: 'unseen'}, 'of type '), type),
        node.rule && h('span', {class: 'badge'}, h('span', {class: 'unseen'}, 'raised by '), `↑ ${shown(node.rule)}`), from && h('span', {class: 'from'}, `← ${from}`)),
      below.length > 0 && h('ul', {role: 'group'}, below.map((one, i) => item(one, path ? `${path}.${i}` : `${i}`, level + 1, roles[i]))));
  };

  const select = (path) => app.model.go({term: path});
  tree.addEventListener('click', (event) => {
    const one = event.target.closest('[role=treeitem]');
    if (one) select(one.dataset.path || 'root');
  });
  tree.addEventListener('focusin', (event) => { for (const one of tree.querySelectorAll('[role=treeitem]')) one.tabIndex = one === event.target ? 0 : -1; });
  tree.addEventListener('keydown', (event) => {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const all = [...tree.querySelectorAll('[role=treeitem]')], at = all.indexOf(event.target);
    const by = {ArrowUp: -1, ArrowDown: 1}[event.key];
    if (at < 0 || (!by && event.key !== 'Enter' && event.key !== ' ')) return;
    event.preventDefault();
    if (by) all[Math.max(0, Math.min(all.length - 1, at + by))].focus();
    else select(all[at].dataset.path || 'root');
  });

  const draw = () => {
    for (const [i, one] of buttons.entries()) one.setAttribute('aria-pressed', String(depths[i] === depth));
    const held = tree.contains(document.activeElement) ? document.activeElement.dataset.path : null;
    states = stepsAt(root, depth);
    place = 0;
    drawSteps();
    chips.replaceChildren(...(root ? sources(root) : []).map((one) => h('li', {}, h('button', {type: 'button', class: `chip ${one.kind}`, 'data-paths': one.paths.join(' '), 'data-testid': 'chip',
      onclick: () => app.jump(one.n)}, one.text, h('span', {class: 'n'}, ` #${one.n}`)))));
    tree.replaceChildren(...(root ? [item(root, '', 1)] : []));
    tree.hidden = !root;
    chips.hidden = !chips.children.length;
    group.hidden = !root;
    if (held !== null) tree.querySelector(`[data-path="${held}"]`)?.focus();
    mark();
  };

  // The root's path is empty; in the selection it is 'root', which an empty one is not.
  const chosenPath = () => {
    const {term} = app.model.selection;
    return term ? (term === 'root' ? '' : term) : null;
  };

  const mark = () => {
    const path = chosenPath(), node = path === null ? null : nodeAt(root, path);
    const all = [...tree.querySelectorAll('[role=treeitem]')];
    for (const one of all) one.setAttribute('aria-selected', String(Boolean(node) && one.dataset.path === path));
    if (!tree.contains(document.activeElement)) for (const one of all) one.tabIndex = one === (all.find((each) => node && each.dataset.path === path) ?? all[0]) ? 0 : -1;
    chosen.hidden = !node;
    if (node)
      chosen.replaceChildren(...[h('span', {class: 'term'}, shorter(line(node, 'λ').text)), ': ', shorter(described(node)) || 'nothing more is known of it', ' ',
        Number.isInteger(node.n) && jump(node.n, `applied at #${node.n}`), ' ', Number.isInteger(node.origin?.n) && jump(node.origin.n, `told at #${node.origin.n}`)].filter(Boolean));
    bend();
  };

  const bend = () => {
    const path = chosenPath();
    arrowsTo(curves, inner, [...chips.querySelectorAll('.chip')].flatMap((chip) => chip.dataset.paths.split(' ').map((leaf) => ({
      chip, leaf: tree.querySelector(`[data-path="${leaf}"]`), kind: chip.className, strong: path !== null && (leaf === path || path === '' || leaf.startsWith(`${path}.`)),
    }))));
  };
  const observer = new ResizeObserver(() => bend());
  observer.observe(inner);

  const latest = new Latest(
    async (wanted) => {
      const space = wanted.indexOf(' '), cell = wanted.slice(space + 1), explained = await app.client.explain(Number(wanted.slice(0, space)));
      const of_cell = cell ? tracker.find(explained.cells, cell) : null;
      const told_cell = of_cell ? await app.client.explain(of_cell.set, keyOf(of_cell)).catch(() => null) : null;
      return {explained, cell: told_cell ? of_cell : null, root: told_cell ? told_cell.derivation : explained.derivation};
    },
    (answer) => {
      const same = found && JSON.stringify(answer.root) === JSON.stringify(root);
      found = answer;
      root = answer.root && typeof answer.root === 'object' ? answer.root : null;
      const {explained, cell} = answer;
      subject.replaceChildren(...(cell ? [`The value of ${cell.slot}, set at `, jump(cell.set)]
        : root ? [`Behind ${explained.kind} `, jump(explained.about, `#${explained.about}`)]
          : ['No term is behind this record.']));
      if (same) mark(); else draw();
    },
    (problem) => {
      root = null;
      draw();
      subject.replaceChildren(h('span', {class: 'trouble'}, problem.message));
    });

  draw();
  return {
    element: panel('derivation', 'Derivation', group, [body, chosen]),
    render({n, cell}) {
      latest.want(`${n} ${cell ?? ''}`);
      if (found) mark();
    },
    close() {
      document.removeEventListener('keydown', onKeys);
      observer.disconnect();
    },
  };
}
