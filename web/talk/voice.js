// Speaks the avatar's words, where the reader wants it and the browser can.
const key = 'speaks';

export class Voice {
  constructor() {
    try {
      this.on = localStorage.getItem(key) === 'yes';
    } catch {
      this.on = false;
    }
  }
  /** @returns whether it speaks now */
  toggle() {
    this.on = !this.on;
    try {
      localStorage.setItem(key, this.on ? 'yes' : 'no');
    } catch {
      /* storage may be off: the choice lasts for this page */
    }
    if (!this.on) this.stop();
    return this.on;
  }
  say(text) {
    if (this.on && window.speechSynthesis)
      speechSynthesis.speak(Object.assign(new SpeechSynthesisUtterance(text), {lang: 'en'}));
  }
  stop() {
    window.speechSynthesis?.cancel();
  }
}
