// Where two runs differ: why, then one difference after the other.
import {h, panel, brief, counted, seconds} from '../dom.js';

const described = {
  input: 'another input', happened: 'something else happened', decided: 'the same, decided by something else', timing: 'at another time',
  outcome: 'an act came to something else', poses: 'bodies are elsewhere',
};
const telling = ({kind, a, b}) => (kind === 'input' && (a[0] ?? b[0]).kind === 'expect' ? 'another expectation' : described[kind] ?? kind);
const sign = (hunk) => (!hunk.a.length ? '+' : !hunk.b.length ? '−' : '~');
const most_lines = 6;

export function mountDifferences(app) {
  const {comparison} = app, {told, hunks} = comparison;
  const line = (mark, side, record) => h('li', {class: `line ${side}`}, h('span', {class: 'sign', 'aria-hidden': 'true'}, mark),
    h('span', {class: 'unseen'}, side === 'a' ? 'in A ' : 'in B '), h('span', {class: 'n'}, `#${record.n}`), ` ${record.kind} ${brief(record.brief)}`);
  const lines = (mark, side, records) => [
    records.slice(0, most_lines).map((one) => line(mark, side, one)),
    records.length > most_lines && h('li', {class: 'muted'}, `and ${records.length - most_lines} more`)];
  const item = (hunk, i) => h('li', {class: `hunk ${hunk.kind}`, 'data-testid': 'hunk'},
    h('button', {type: 'button', onclick: () => show(i)}, h('span', {class: 'sign'}, sign(hunk)), ` ${telling(hunk)}, ${seconds(hunk.t)}`),
    h('ul', {}, lines('−', 'a', hunk.a), lines('+', 'b', hunk.b)));
  const list = h('ol', {class: 'hunks'}, hunks.map(item));
  const rows = [...list.children];
  const copied = h('button', {type: 'button', 'data-testid': 'markdown', onclick: async () => {
    copied.textContent = await app.copy(told.markdown, 'The comparison was copied as Markdown.') ? 'Copied' : 'Not copied';
    setTimeout(() => { copied.textContent = 'Copy as Markdown'; }, 1200);
  }}, 'Copy as Markdown');
  const element = panel('differences', 'Differences', [
    h('button', {type: 'button', title: 'Previous difference (P)', 'aria-label': 'Previous difference', onclick: () => go(-1)}, '↑'),
    h('button', {type: 'button', title: 'Next difference (N)', 'aria-label': 'Next difference', onclick: () => go(1)}, '↓'),
    told.markdown && copied],
    h('div', {class: 'body', tabindex: 0, role: 'region', 'aria-label': 'Cause and differences'},
      told.evidence.length > 0 && [h('h3', {}, 'What speaks for the cause'), h('ul', {class: 'evidence'}, told.evidence.map((one) => h('li', {}, brief(one))))],
      hunks.length ? [h('h3', {}, counted(told.count, 'difference')), list] : h('p', {class: 'empty'}, 'Nothing that happened differs.'),
      told.meet && h('p', {class: 'meet'}, 'They meet again: ',
        h('button', {type: 'button', class: 'link', onclick: () => app.jump(told.meet.a)}, `A #${told.meet.a}, B #${told.meet.b}`)),
      told.givens.length > 0 && [h('h3', {}, 'What the runs do not have in common'), h('ul', {class: 'givens'}, told.givens.map((one) => h('li', {}, `${one.kind}: ${one.sentence}`)))]));
  let current = null;

  const show = (i) => app.jump(comparison.recordOf(i), {hunk: i});
  const go = (by) => {
    if (!hunks.length) return;
    const {hunk} = app.model.selection;
    show(hunk === null ? (by > 0 ? 0 : hunks.length - 1) : Math.max(0, Math.min(hunks.length - 1, hunk + by)));
  };
  return {
    element, go,
    render({hunk}) {
      const row = rows[hunk] ?? null;
      if (row === current) return;
      current?.classList.remove('current');
      current?.firstChild.removeAttribute('aria-current');
      current = row;
      if (!row) return;
      row.classList.add('current');
      row.firstChild.setAttribute('aria-current', 'true');
      // Within the panel: the page itself stays where it is.
      const body = element.querySelector('.body'), top = row.offsetTop - body.offsetTop;
      if (top < body.scrollTop || top + row.offsetHeight > body.scrollTop + body.clientHeight) body.scrollTop = top - 8;
    },
  };
}
