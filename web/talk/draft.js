// The words being typed and the clicks made meanwhile. Typing takes longer than speaking, so a click belongs to a word and
// not to its own time. Pure.

const word_s = 0.25; // how long a spoken word takes
const longest_s = 1.2; // of the whole: well within the time in which the engine joins words and pointing
const thousandths = (x) => Math.round(x * 1000) / 1000;

export const wordsOf = (text) => text.trim().split(/\s+/).filter(Boolean);

export class Draft {
  text = '';
  clicks = []; // {target, word}: after which word, from 0

  /** A click now. */
  click(target) {
    this.clicks.push({target, word: Math.max(0, wordsOf(this.text).length - 1)});
  }
  remove(click) {
    this.clicks = this.clicks.filter((one) => one !== click);
  }
  type(text) {
    this.text = text;
    if (!wordsOf(text).length) this.clicks = [];
  }
  /** The word a click goes with, as the text is now. */
  wordOf({word}) {
    return wordsOf(this.text)[word] ?? wordsOf(this.text).at(-1) ?? '';
  }

  /** Takes what was typed: the function gives its events at a time of the engine; null: there is nothing. */
  take() {
    const {clicks} = this;
    const text = this.text.trim();
    const words = wordsOf(text);
    this.text = '';
    this.clicks = [];
    if (!words.length) return null;
    return (now) => (clicks.length ? together(text, words, clicks, now) : [{kind: 'speech', text}]);
  }
}

/** The words as if they had been spoken until now, each click at the time of its word. */
function together(text, words, clicks, now) {
  const span = Math.min(word_s * words.length, longest_s, now);
  const from = now - span;
  const at = (i) => thousandths(from + (Math.min(i, words.length - 1) * span) / words.length);
  const strokes = clicks.map(({target, word}) => ({
    t: at(word),
    kind: 'gesture',
    name: 'point',
    hand: 'right',
    phase: 'stroke',
    target,
  }));
  return [
    {t: at(0), kind: 'speech', text, until: thousandths(now), words: words.map((one, i) => ({text: one, t: at(i)}))},
    ...strokes.sort((a, b) => a.t - b.t),
  ];
}
