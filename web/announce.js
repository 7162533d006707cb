// Sentences for those who hear the page, and the clipboard.

/** Says the sentence to a screen reader. */
export function announce(sentence) {
  document.getElementById('sentence').textContent = sentence;
}

/** Copies the text and announces `done`. @returns {Promise<boolean>} whether the browser allowed it */
export async function copy(text, done) {
  try {
    await navigator.clipboard.writeText(text);
    announce(done);
    return true;
  } catch {
    return false;
  }
}

/** Copies the address of the page as it is shown. */
export const copyLink = () => copy(location.href, 'The link was copied.');
