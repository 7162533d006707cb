// The automaton: its states and transitions, how often each was used, and where it stands.
import {h, s, panel, shown, brief, counted} from '../dom.js';
import {calmly} from '../calmly.js';
import {mergedGraph, layOut} from '../graph/graph_layout.js';
import {along, arrowHead, bent, loopPath, path} from '../graph/graph_paths.js';

const most_refused = 6, calm_ms = 150;

/** The value in "|options| > 1: |options| is 1"; all of a reason that has none. */
const valueOf = (reason) => {
  const text = brief(String(reason ?? '')), at = text.lastIndexOf(': ');
  const value = at < 0 ? text : text.slice(at + 2);
  return value.length > 26 ? `${value.slice(0, 25)}…` : value;
};

const rowText = (row) => `${row.id}: ${row.input ?? 'ε'}${row.condition ? `, ${shown(row.condition)}` : ''} / ${shown(row.operation)}` +
  (row.diverted ? ', turned away by a gate' : '') + (row.visits ? `, ${counted(row.visits, 'time')}` : ', never taken');

export function mountGraph(app) {
  const {data, client, comparison} = app;
  const view = s('g', {});
  const svg = s('svg', {role: 'group', 'aria-label': 'State graph', 'data-testid': 'graph'}, view);
  const refused_layer = s('g', {class: 'refused-layer'});
  const refused_list = h('details', {class: 'refused-list', hidden: true, 'data-testid': 'graph-refused'});
  const edge_card = h('div', {class: 'edge-card', role: 'status', hidden: true, 'data-testid': 'edge-card'});
  const only = h('input', {type: 'checkbox', checked: true, 'data-testid': 'taken-only', onchange: () => build()});
  const element = panel('graph', 'State graph', [
    h('span', {class: 'muted', 'data-testid': 'graph-count'}),
    h('label', {}, only, 'taken only'),
    h('button', {type: 'button', title: 'Fit into the panel (F)', onclick: () => fit()}, 'Fit')], h('div', {class: 'canvas'}, svg, refused_list, edge_card));
  const host = element.querySelector('.canvas');
  let refused_at = -1, refused_on = null;
  let placed = null, nodes = new Map(), edges = new Map(), lit = [], shown_n = 0;
  let view_x = 0, view_y = 0, scale = 1, fitted = true;

  const transform = () => view.setAttribute('transform', `translate(${view_x} ${view_y}) scale(${scale})`);
  const fit = () => {
    if (!placed || !host.clientWidth) return;
    scale = Math.min(host.clientWidth / placed.width, host.clientHeight / placed.height, 1.3);
    view_x = (host.clientWidth - placed.width * scale) / 2;
    view_y = (host.clientHeight - placed.height * scale) / 2;
    fitted = true;
    transform();
  };
  // The next time after the cursor that the automaton entered this state, from the start again after the last.
  const nextVisit = (id) => {
    const {n, to} = data.steps;
    const from = data.step(app.model.selection.n) + 1;
    for (let i = 0; i < n.length; ++i) {
      const place = (from + i) % n.length;
      if (data.names[to[place]] === id) return n[place];
    }
    return null;
  };

  // In a comparison, which of the two runs took it.
  const whose = ({visits, visits_b}) => (!comparison || Boolean(visits) === Boolean(visits_b) ? '' : visits ? ' only-a' : ' only-b');
  const visitsText = ({visits, visits_b}) => (!comparison ? `${visits}` : visits === visits_b ? `${visits}` : `A ${visits} B ${visits_b}`);

  const drawEdge = (edge) => {
    const loop = edge.from === edge.to;
    const points = edge.points;
    const middle = loop ? {x: points[2].x + 4, y: points[1].y + 6} : along(points, 0.4);
    const used = edge.visits + edge.visits_b;
    const width = used ? 1.2 + Math.min(3, Math.log10(used) * 1.1) : 0.8;
    const tell = () => tellEdge(edge);
    const group = s('g', {class: `edge ${used ? 'taken' : 'never'}${whose(edge)}${edge.rows.every((row) => row.diverted) ? ' diverted' : ''}`, role: 'button', tabindex: used ? 0 : -1, onclick: tell,
        onkeydown: (event) => { if (event.key === 'Enter' || event.key === ' ') { event.preventDefault(); event.stopPropagation(); tell(); } },
        'aria-label': `${edge.from} to ${edge.to}, taken ${visitsText(edge)} times; its transitions`},
      s('title', {}, `${edge.from} → ${edge.to}\n${edge.rows.map(rowText).join('\n')}`),
      s('path', {class: 'hit', d: loop ? loopPath(points) : path(points)}),
      s('path', {class: 'stroke', d: loop ? loopPath(points) : path(points), 'stroke-width': width}),
      s('path', {class: 'head', d: arrowHead(points)}),
      used > 0 && s('text', {class: 'count', x: middle.x, y: middle.y + 3, 'text-anchor': loop ? 'start' : 'middle'}, visitsText(edge)));
    return group;
  };

  // The transitions of an arrow, in words, until it is chosen again.
  let told_edge = null;
  const tellEdge = (edge) => {
    told_edge = told_edge === edge ? null : edge;
    edge_card.hidden = !told_edge;
    if (told_edge) edge_card.replaceChildren(h('b', {}, `${edge.from} → ${edge.to}`), h('ul', {}, edge.rows.map((row) => h('li', {}, rowText(row)))));
  };

  const drawNode = (node) => {
    const begins = node.id === data.graph.start;
    const jump = () => { const n = nextVisit(node.id); if (n !== null) app.jump(n); };
    const top = node.y - (node.lines.length - 1) * 6.5 + 4;
    return s('g', {class: `node ${node.visits || node.visits_b || begins ? 'taken' : 'never'}${whose(node)}`, role: node.visits ? 'button' : 'img', tabindex: node.visits ? 0 : null, 'data-state': node.id,
        'aria-label': `State ${node.id}, entered ${counted(node.visits, 'time')}${node.visits ? '; go to the next' : ''}`,
        onclick: jump, onkeydown: (event) => { if (event.key === 'Enter' || event.key === ' ') { event.preventDefault(); event.stopPropagation(); jump(); } }},
      s('title', {}, `${node.id}: entered ${counted(node.visits, 'time')}`),
      node.accepting && s('rect', {class: 'outer', x: node.x - node.w / 2 - 3, y: node.y - node.h / 2 - 3, width: node.w + 6, height: node.h + 6, rx: 10}),
      s('rect', {class: 'box', x: node.x - node.w / 2, y: node.y - node.h / 2, width: node.w, height: node.h, rx: 8}),
      node.lines.map((line, i) => s('text', {x: node.x, y: top + i * 13, 'text-anchor': 'middle'}, line)),
      node.anywhere && s('g', {class: 'edge never'}, s('title', {}, `from any state\n${rowText(node.anywhere)}`),
        s('path', {class: 'stroke', d: `M${node.x} ${node.y - node.h / 2 - 20}v14`}), s('path', {class: 'head', d: `M${node.x} ${node.y - node.h / 2 - 2}l-3.5 -6h7z`}),
        s('text', {class: 'count', x: node.x, y: node.y - node.h / 2 - 23, 'text-anchor': 'middle'}, 'from any state')),
      begins && s('path', {class: 'begin', d: `M${node.x - node.w / 2 - 9} ${node.y - 5}l8 5l-8 5z`}));
  };

  const build = () => {
    const merged = mergedGraph(data.graph, only.checked, comparison?.side.data.graph);
    placed = layOut(merged, Math.max(0.2, host.clientWidth / Math.max(1, host.clientHeight)));
    edges = new Map(placed.edges.map((edge) => [JSON.stringify([edge.from, edge.to]), drawEdge(edge)]));
    nodes = new Map(placed.nodes.map((node) => [node.id, drawNode(node)]));
    const by_use = placed.edges.toSorted((a, b) => a.visits - b.visits);
    view.replaceChildren(...by_use.map((edge) => edges.get(JSON.stringify([edge.from, edge.to]))), ...nodes.values(), refused_layer);
    const own = data.graph.edges.filter((edge) => !edge.diverted);
    element.querySelector('[data-testid=graph-count]').textContent =
      `${placed.nodes.length} of ${counted(data.graph.states.length, 'state')}, ${own.filter((e) => e.visits).length} of ${counted(own.length, 'transition')} taken`;
    lit = [];
    fit();
    light(shown_n);
  };

  const light = (n) => {
    shown_n = n;
    for (const one of nodes.values()) one.classList.remove('branch');
    for (const group of lit) group.classList.remove('current', 'last', 'current-b');
    lit = [];
    const step = data.step(n);
    const node = nodes.get(data.state(n));
    if (node) { node.classList.add('current'); lit.push(node); }
    const edge = step >= 0 && edges.get(JSON.stringify([data.steps.from[step], data.steps.to[step]]));
    if (edge) { edge.classList.add('last'); edge.parentNode.insertBefore(edge, [...nodes.values()][0]); lit.push(edge); }
    if (comparison) {
      const other = nodes.get(comparison.side.data.state(comparison.otherOf(app.model.selection)));
      if (other && other !== node) { other.classList.add('current-b'); lit.push(other); }
    }
    lightBranch(n);
    if (!fitted) follow(data.state(n));
    tellRefused(n, step);
  };

  // Where the chosen one of several configurations is.
  const lightBranch = async (n) => {
    const {branch} = app.model.selection;
    if (branch === null || !data.count('branches')) return;
    const stack = await client.stack(n, branch).catch(() => null);
    if (!stack?.branch || shown_n !== n || app.model.selection.branch !== branch) return;
    for (const one of nodes.values()) one.classList.toggle('branch', one.dataset.state === stack.branch.state);
  };

  // What could have been taken where the automaton stood, and the values that kept it from that.
  const tellRefused = (n, step) => {
    const at = data.kind(n) === 'refusal' ? n : step < 0 ? -1 : data.steps.n[step];
    if (at === refused_at && placed === refused_on) return;
    refused_at = at;
    refused_on = placed;
    if (!refused_list.hidden) {
      refused_layer.replaceChildren();
      refused_list.hidden = true;
    }
    if (at >= 0 && !app.playing) askRefused(at);
  };
  const askRefused = calmly(async (at) => {
    if (at !== refused_at) return;
    const record = await client.record(at).catch(() => null);
    if (!record || at !== refused_at) return;
    const refused = (record.refused ?? []).filter((one) => one?.id);
    const from = record.from ?? record.state;
    const targets = new Map();
    for (const one of refused)
      for (const edge of data.graph.edges.filter((row) => row.id === one.id && row.from === from && !row.diverted)) {
        if (!targets.has(edge.to)) targets.set(edge.to, []);
        targets.get(edge.to).push(one);
      }
    refused_layer.replaceChildren(...[...targets].slice(0, most_refused).flatMap(([to, ones], i) => drawRefused(from, to, ones, i)));
    refused_list.hidden = !refused.length;
    refused_list.replaceChildren(h('summary', {}, `${counted(refused.length, 'candidate')} refused`),
      h('ul', {}, refused.map((one) => h('li', {}, h('b', {}, one.id), ` ${shown(one.reason)}`))));
  }, calm_ms);
  const drawRefused = (from, to, ones, i) => {
    const a = placed.nodes.find((one) => one.id === from), b = placed.nodes.find((one) => one.id === to);
    if (!a || !b) return [];
    const points = a === b
      ? [{x: a.x - a.w / 2 + 4, y: a.y + a.h / 2}, {x: a.x - a.w / 2 - 4, y: a.y + a.h / 2 + 20}, {x: a.x - a.w / 2 + 24, y: a.y + a.h / 2 + 20}, {x: a.x - a.w / 2 + 22, y: a.y + a.h / 2}]
      : bent(a, b, 0.22 + 0.05 * i);
    const middle = a === b ? {x: points[1].x + 12, y: points[1].y + 9} : {x: (points[0].x + 2 * points[1].x + points[2].x) / 4, y: (points[0].y + 2 * points[1].y + points[2].y) / 4};
    const words = `${ones[0].id}: ${valueOf(ones[0].reason)}${ones.length > 1 ? `, and ${ones.length - 1} more` : ''}`;
    return s('g', {class: 'edge refused', role: 'img', 'aria-label': `refused: ${from} to ${to}, ${ones.map((one) => `${one.id}, ${shown(one.reason)}`).join('; ')}`},
      s('title', {}, ones.map((one) => `${one.id} refused: ${shown(one.reason)}`).join('\n')),
      s('path', {class: 'stroke', d: a === b ? loopPath(points) : path(points)}), s('path', {class: 'head', d: arrowHead(points)}),
      s('text', {class: 'count', x: middle.x, y: middle.y + 3, 'text-anchor': 'middle'}, words));
  };

  // Keeps the current state in sight when the reader has zoomed in.
  const follow = (id) => {
    const node = placed.nodes.find((one) => one.id === id);
    if (!node) return;
    const x = node.x * scale + view_x, y = node.y * scale + view_y, edge_px = 40;
    if (x < edge_px || x > host.clientWidth - edge_px) view_x += host.clientWidth / 2 - x;
    if (y < edge_px || y > host.clientHeight - edge_px) view_y += host.clientHeight / 2 - y;
    transform();
  };

  svg.addEventListener('wheel', (event) => {
    event.preventDefault();
    const box = svg.getBoundingClientRect(), x = event.clientX - box.left, y = event.clientY - box.top;
    const next = Math.max(0.2, Math.min(4, scale * Math.exp(-event.deltaY * 0.0015)));
    view_x = x - (x - view_x) * (next / scale);
    view_y = y - (y - view_y) * (next / scale);
    scale = next;
    fitted = false;
    transform();
  }, {passive: false});
  svg.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    let {clientX: x, clientY: y} = event, far = 0;
    const move = (moved) => {
      far += Math.abs(moved.clientX - x) + Math.abs(moved.clientY - y);
      if (far < 4) return;
      svg.classList.add('dragged');
      view_x += moved.clientX - x; view_y += moved.clientY - y;
      x = moved.clientX; y = moved.clientY;
      fitted = false;
      transform();
    };
    const done = () => {
      removeEventListener('pointermove', move);
      setTimeout(() => svg.classList.remove('dragged'));
    };
    addEventListener('pointermove', move);
    addEventListener('pointerup', done, {once: true});
  });
  svg.addEventListener('click', (event) => { if (svg.classList.contains('dragged')) event.stopPropagation(); }, true);

  let size = '';
  new ResizeObserver(() => {
    const now = `${host.clientWidth}x${host.clientHeight}`;
    if (now === size) return;
    size = now;
    build();
  }).observe(host);
  return {element, fit, render: ({n}) => { if (placed) light(n); else shown_n = n; }};
}
