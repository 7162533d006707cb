// A player that keeps in step with the cursor: it is never asked where it is, but told.

const close_s = 0.04; // as good as in step
const far_s = 0.3; // jumps; nearer ones are caught up with by playing a little faster or slower
const still_s = 0.01; // of a player that stands
const most_hurry = 0.15; // part of the speed
const rates = [0.0625, 16]; // that browsers play at

/** How fast to play so that a player that is `ahead` seconds of its place comes back to it. */
export const rateFor = (ahead, speed) => {
  const hurry = Math.abs(ahead) < close_s ? 0 : Math.max(-most_hurry, Math.min(most_hurry, -ahead));
  return Math.max(rates[0], Math.min(rates[1], speed * (1 + hurry)));
};

export class Playback {
  #player;
  #offset;
  #wanted = null; // {place, playing, speed} in seconds of the recording; null: there is nothing at that instant

  /** `offset`: seconds of the recording when the run's time is 0. */
  constructor(player, offset) {
    this.#player = player;
    this.#offset = offset;
    for (const event of ['loadedmetadata', 'seeked']) player.addEventListener(event, this.#obey);
  }

  /** @returns whether the recording has anything at `t`, as far as is known */
  follow({t, playing, speed}) {
    const place = t + this.#offset;
    const {duration} = this.#player;
    const there = place >= 0 && !(place > duration);
    this.#wanted = there ? {place, playing, speed} : null;
    this.#obey();
    return there;
  }

  #obey = () => {
    const player = this.#player;
    if (!this.#wanted?.playing && !player.paused) player.pause();
    // A seek under way ends with another look.
    if (!this.#wanted || player.seeking || player.readyState < HTMLMediaElement.HAVE_METADATA) return;
    const {place, playing, speed} = this.#wanted;
    const ahead = player.currentTime - place;
    if (Math.abs(ahead) > (playing && !player.paused ? far_s * Math.max(1, speed) : still_s))
      player.currentTime = place;
    if (!playing) return;
    player.playbackRate = rateFor(ahead, speed);
    if (player.paused) this.#play();
  };

  // Browsers let no sound begin before the reader has pressed anything.
  #play() {
    this.#player.play().catch((problem) => {
      if (problem.name !== 'NotAllowedError' || this.#player.muted) return;
      this.#player.muted = true;
      this.#obey();
    });
  }

  close() {
    this.#wanted = null;
    this.#player.pause();
    this.#player.removeAttribute('src');
    this.#player.load();
  }
}
