// The recordings of the interaction, played in step with the cursor.
import {counted, h, panel, put} from '../dom.js';
import {Playback} from '../media/playback.js';

const size = (bytes) => (bytes < 1e6 ? `${Math.ceil(bytes / 1e3)} kB` : `${(bytes / 1e6).toFixed(1)} MB`);

/** One recording: its picture or sound, its name, whether it is heard. */
class View {
  #told = h('span', {class: 'muted', role: 'status'});
  #mute;

  constructor(one, {cursor, heard}) {
    const name = one.label || one.file;
    const title = [one.file, one.kind, size(one.bytes)].filter(Boolean).join(', ');
    this.kind = one.kind === 'audio' ? 'audio' : 'video';
    this.player = h(this.kind, {
      src: one.src,
      preload: 'auto',
      playsinline: true,
      'aria-label': name,
      'data-testid': 'media-player',
    });
    this.player.muted = !heard;
    this.player.addEventListener('click', () => cursor.play());
    this.player.addEventListener('error', () => put(this.#told, 'this browser cannot play it'));
    this.player.addEventListener('volumechange', () => this.#showSound());
    this.playback = new Playback(this.player, one.offset);
    const toggle = () => {
      this.player.muted = !this.player.muted;
    };
    const props = {type: 'button', 'aria-label': `Hear ${name}`, 'data-testid': 'media-hear', onclick: toggle};
    this.#mute = h('button', props, 'Hear');
    this.#showSound();
    const caption = h('figcaption', {}, this.#mute, h('span', {class: 'name', title}, name), this.#told);
    this.element = h('figure', {class: this.kind, 'data-testid': 'media-view'}, this.player, caption);
  }

  #showSound() {
    this.#mute.setAttribute('aria-pressed', String(!this.player.muted));
  }

  follow(cursor) {
    const there = this.playback.follow({t: cursor.time, playing: cursor.playing, speed: cursor.speed});
    this.element.classList.toggle('outside', !there);
    if (!this.player.error) put(this.#told, there ? '' : 'nothing recorded here');
  }
  close() {
    this.playback.close();
  }
}

const missing = ({file, problem}) =>
  h('p', {class: 'trouble', 'data-testid': 'media-missing'}, `The recording ${file} ${problem}.`);

// Asks for the waveforms, one after the other since each takes the server a while, and keeps them with the recordings.
async function listen(media, client, heard) {
  for (const [i, {problem, offset, sound}] of media.entries()) {
    if (problem || sound.peaks) continue;
    const told = await client.peaks(i).catch(({message}) => ({problem: message}));
    if (told.problem) sound.problem = `no waveform: ${told.problem}`;
    else sound.peaks = {...told, offset};
    heard();
  }
}

/**
 * `media`: the recordings as the server tells them, each with `src` where it can be had, and `sound`, into which its
 * waveform is put; `heard()` is called when one is there.
 */
export function mountMedia({media, client, cursor, heard}) {
  listen(media, client, heard);
  const there = media.filter((one) => !one.problem);
  const views = there.map((one, i) => new View(one, {cursor, heard: i === 0}));
  const ofKind = (kind) => views.filter((view) => view.kind === kind).map(({element}) => element);
  const body = h(
    'div',
    {class: 'body', tabindex: 0, role: 'region', 'aria-label': counted(there.length, 'recording')},
    h('div', {class: 'pictures'}, ofKind('video')),
    ofKind('audio'),
    media.filter((one) => one.problem).map(missing),
  );
  return {
    element: panel('media', 'Media', null, body),
    views,
    render() {
      for (const view of views) view.follow(cursor);
    },
    close() {
      for (const view of views) view.close();
    },
  };
}
