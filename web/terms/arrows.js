// Curves from the leaves of a tree to the chips they came from.
import {s} from '../dom.js';

/** Draws `arrows` ([{chip, leaf: elements, kind, strong}]) into `svg`, which lies over `host`. */
export function arrowsTo(svg, host, arrows) {
  const frame = host.getBoundingClientRect();
  if (!frame.width) return;
  svg.setAttribute('width', host.clientWidth);
  svg.setAttribute('height', host.scrollHeight);
  svg.replaceChildren(
    ...arrows
      .filter(({leaf}) => leaf)
      .flatMap(({chip, leaf, kind, strong}) => {
        const from = leaf.getBoundingClientRect();
        const to = chip.getBoundingClientRect();
        const x1 = Math.min(from.right - frame.left + 3, host.clientWidth - 6);
        const y1 = from.top - frame.top + from.height / 2;
        const x2 = to.left - frame.left + to.width / 2;
        const y2 = to.bottom - frame.top;
        const bend = Math.max(20, (y1 - y2) / 2);
        const style = `curve ${kind}${strong ? ' strong' : ''}`;
        return [
          s('path', {class: style, d: `M${x1} ${y1}C${x1 + bend} ${y1} ${x2} ${y2 + bend} ${x2} ${y2 + 5}`}),
          s('path', {class: `${style} tip`, d: `M${x2 - 3} ${y2 + 7}L${x2} ${y2 + 1}L${x2 + 3} ${y2 + 7}Z`}),
        ];
      }),
  );
}
