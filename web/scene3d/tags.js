// Names and numbers next to the bodies of the scene.
import {h} from '../dom.js';

/** Shows [text, place in pixels or null] above each place: `up`, as CSS writes it. */
export function showTags(host, tags, up) {
  const elements = tags
    .filter(([, place]) => place)
    .map(([text, [x, y]]) => {
      const transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) translate(-50%, ${up})`;
      return h('span', {class: 'tag', style: {transform}}, text);
    });
  if (elements.length || host.childElementCount) host.replaceChildren(...elements);
}
