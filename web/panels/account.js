// The run in a few sentences, act by act, and minute by minute.
import {h, clock, panel} from '../dom.js';

export function mountAccount({client, jump}) {
  const body = h('div', {class: 'body', tabindex: 0, role: 'region', 'aria-label': 'The run in words'});
  const button = ({text, n}) => h('button', {type: 'button', class: 'link', onclick: () => jump(n)}, text);
  const list = (title, lines, shown) =>
    lines.length > 0 &&
    h(
      'section',
      {},
      h('h3', {}, title),
      h(
        'ol',
        {},
        lines.map((line) => h('li', {'data-n': line.n}, shown(line))),
      ),
    );
  let asked = false;

  function show({sentences, acts, minutes}) {
    const parts = [
      h(
        'p',
        {'data-testid': 'account'},
        sentences.map((one) => [button(one), ' ']),
      ),
      list('Act by act', acts, (line) => [
        line.failed && h('span', {class: 'badge bad'}, '✘ failed'),
        line.failed && ' ',
        button(line),
      ]),
      list('Minute by minute', minutes, (line) => [
        h('b', {}, `${clock(line.from)} – ${clock(line.to)} `),
        button(line),
      ]),
    ];
    body.replaceChildren(...parts.filter(Boolean));
  }
  async function ask() {
    asked = true;
    body.replaceChildren(h('p', {class: 'muted'}, 'Being read …'));
    try {
      show(await client.account());
    } catch (problem) {
      body.replaceChildren(h('p', {class: 'trouble'}, problem.message));
    }
  }
  const element = panel('account', 'Summary', null, body);
  return {
    element,
    /** Read once it is in sight: a long run takes a while. */
    render({n}) {
      if (!asked && !element.hidden) ask();
      for (const line of body.querySelectorAll('ol')) {
        const items = [...line.children];
        const now = items.findLast((item) => Number(item.dataset.n) <= n);
        for (const item of items) item.classList.toggle('current', item === now);
      }
    },
  };
}
