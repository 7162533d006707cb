// Recordings for the tests of the page, made by ffmpeg, and runs whose traces name them.
import {execFileSync, spawnSync} from 'node:child_process';
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {program, root, skip} from './support.mjs';

const seconds = 20;
const sources = {
  // From black to white, so that a pixel tells the time; and a tone of one second in two.
  'ramp.webm': [
    ...['-f', 'lavfi', '-i', `color=black:s=160x120:r=10:d=${seconds},format=gray,geq=lum='255*T/${seconds}'`],
    ...['-f', 'lavfi', '-i', `aevalsrc=0.5*sin(880*PI*t)*lt(mod(t\\,2)\\,1):d=${seconds}:s=48000`],
    ...['-c:v', 'libvpx', '-g', '10', '-b:v', '300k', '-c:a', 'libopus', '-b:a', '32k'],
  ],
  'bars.webm': [
    ...['-f', 'lavfi', '-i', `testsrc2=s=320x240:r=10:d=${seconds}`],
    ...['-c:v', 'libvpx', '-g', '10', '-b:v', '300k'],
  ],
  'tone.wav': ['-f', 'lavfi', '-i', `sine=frequency=330:duration=${seconds}:sample_rate=16000`],
};

/** Puts ramp.webm, with sound, bars.webm, without, and tone.wav into the folder. */
export function makeFilms(folder) {
  if (spawnSync('ffmpeg', ['-version']).status !== 0) skip('there is no ffmpeg');
  for (const [name, words] of Object.entries(sources))
    execFileSync('ffmpeg', ['-loglevel', 'error', '-y', ...words, join(folder, name)]);
}

/** Replays a worked example in the folder as `name`, its trace with these recordings in the header. */
export function filmed(folder, name, media) {
  const [header, ...events] = readFileSync(join(root, 'traces/paper/correction.trace.jsonl'), 'utf8').split('\n');
  const own = JSON.stringify({...JSON.parse(header), ...(media.length && {media})});
  const trace = join(folder, `${name}.trace.jsonl`);
  writeFileSync(trace, [own, ...events].join('\n'));
  execFileSync(program, ['replay', trace, '--no-physics', '-o', join(folder, `${name}.run.jsonl`)]);
}
