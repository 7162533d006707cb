// The scene in words, for those who do not see the picture, and the facts that MJCF has about bodies. Pure, except that MJCF is
// read with the browser's XML parser.

const near_m = 0.06;

const cm = (metres) => Math.round(Math.abs(metres) * 100);

/** "12 cm right, 3 cm nearer, 5 cm up", as the human sees it from the middle of the table. */
export function placeText([x, y, z]) {
  const parts = [
    cm(x) && `${cm(x)} cm ${x > 0 ? 'right' : 'left'}`,
    cm(y) && `${cm(y)} cm ${y > 0 ? 'farther' : 'nearer'}`,
    cm(z) && `${cm(z)} cm ${z > 0 ? 'up' : 'down'}`,
  ].filter(Boolean);
  return parts.length ? parts.join(', ') : 'in the middle';
}

/** The object nearest to a point, where one is close. */
export function objectNear(point, objects, poses) {
  let best = null;
  let least = near_m;
  for (const name of objects) {
    const pose = poses.get(name);
    const away = pose ? Math.hypot(pose[0] - point[0], pose[1] - point[1]) : Infinity;
    if (away < least) [best, least] = [name, away];
  }
  return best;
}

/** A sentence or two about what goes on, and, unless `brief`, where the objects are. */
export function sceneSentence({objects, poses, pointing, acts, titles = {}}, brief = false) {
  const title = (name) => titles[name] ?? name;
  const sentences = [];
  for (const {who, target} of pointing) {
    const near = objectNear(target, objects, poses);
    sentences.push(
      `${who === 'avatar' ? 'The avatar' : 'The human'} points ${near ? `at ${title(near)}` : placeText(target)}.`,
    );
  }
  for (const {program, told = program, target} of acts)
    sentences.push(
      told === program
        ? `The avatar carries out ${program}${target ? `, to ${placeText(target)}` : ''}.`
        : `The avatar ${told}.`,
    );
  const shown = brief ? [] : objects.filter((name) => poses.has(name));
  if (shown.length > 12) sentences.push(`${shown.length} objects.`);
  else if (shown.length)
    sentences.push(`${shown.map((name) => `${title(name)}: ${placeText(poses.get(name))}`).join('; ')}.`);
  return sentences.join(' ') || (brief ? '' : 'Nothing that has a place.');
}

/**
 * The bodies of the scene's MJCF: `objects`, those that move freely, in their order, and `grip`, the point
 * between the avatar's fingers: {body, pos}, or null. Without readable MJCF every drawn body counts as an object.
 */
export function readMjcf(mjcf, drawn) {
  const otherwise = {objects: drawn.filter((name) => name !== 'world'), grip: null};
  if (typeof mjcf !== 'string') return otherwise;
  const xml = new DOMParser().parseFromString(mjcf, 'text/xml');
  if (xml.querySelector('parsererror')) return otherwise;
  const free = (body) =>
    [...body.children].some(
      (child) => child.tagName === 'freejoint' || (child.tagName === 'joint' && child.getAttribute('type') === 'free'),
    );
  const objects = [...xml.querySelectorAll('body[name]')]
    .filter(free)
    .map((body) => body.getAttribute('name'))
    .filter((name) => drawn.includes(name));
  const site = xml.querySelector('body[name] > site[name=grip]');
  const pos = (site?.getAttribute('pos') ?? '').trim().split(/\s+/).map(Number);
  const grip =
    site && pos.length === 3 && pos.every(Number.isFinite)
      ? {body: site.parentElement.getAttribute('name'), pos}
      : null;
  return {objects, grip};
}
