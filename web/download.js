// A file that the page made, for the reader to keep.
import {h} from './dom.js';

/** Hands the text over as a file of this name; `type`: its media type. */
export function download(text, name, type) {
  const link = h('a', {href: URL.createObjectURL(new Blob([text], {type})), download: name});
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href));
}
