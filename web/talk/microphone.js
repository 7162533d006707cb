// Speech by the browser's own recogniser, where it has one.
import {h, s} from '../dom.js';

const problems = {
  'not-allowed': 'The microphone may not be used: allow it in the browser, or type.',
  'service-not-allowed': 'The browser’s recogniser may not be used here: type instead.',
  'audio-capture': 'No microphone was found: connect one, or type.',
  network: 'The browser’s recogniser cannot be reached: type instead.',
  'language-not-supported': 'The browser’s recogniser knows no English: type instead.',
};
const sign = () =>
  s(
    'svg',
    {viewBox: '0 0 16 16', width: 18, height: 18, 'aria-hidden': 'true'},
    s('path', {
      fill: 'none',
      stroke: 'currentColor',
      'stroke-width': 1.5,
      'stroke-linecap': 'round',
      d: 'M6 4a2 2 0 0 1 4 0v4a2 2 0 0 1-4 0zM3.5 8a4.5 4.5 0 0 0 9 0M8 12.5V15',
    }),
  );
const harmless = ['no-speech', 'aborted'];
const most_alternatives = 5;
const hundredths = (x) => Math.round(x * 100) / 100;

/** Words that the recogniser may still revise; null without words. They never lead to an act. Pure. */
export function interimOf(result) {
  const text = result[0]?.transcript.trim();
  return text ? {kind: 'speech', text, final: false} : null;
}

/** A recogniser's result as an event of a trace; null for one without words. Pure. */
export function eventOf(result) {
  const readings = Array.from(result, ({transcript, confidence}) => ({
    text: transcript.trim(),
    confidence: hundredths(confidence),
  })).filter(({text}) => text);
  if (!readings.length) return null;
  const [{text, confidence}, ...others] = readings;
  // A recogniser that tells no confidence says 0, which would be believed.
  return {
    kind: 'speech',
    text,
    ...(confidence > 0 && {confidence}),
    ...(others.length && {
      alternatives: others.map((one) => (one.confidence > 0 ? one : {...one, confidence: confidence || 0.5})),
    }),
  };
}

/** `heard(event)`; `said(sentence)`: for the reader. @returns null where the browser cannot listen */
export function mountMicrophone({heard, said}) {
  const Recognition = window.SpeechRecognition ?? window.webkitSpeechRecognition;
  if (!Recognition) return null;
  const recognition = new Recognition();
  Object.assign(recognition, {continuous: true, interimResults: true, maxAlternatives: most_alternatives, lang: 'en'});
  let on = false;
  let interim = '';
  const button = h(
    'button',
    {
      type: 'button',
      class: 'microphone',
      'aria-pressed': 'false',
      'data-testid': 'microphone',
      title: 'Listen with the microphone',
      'aria-label': 'Listen with the microphone',
      onclick: () => listen(!on),
    },
    sign(),
  );
  function listen(wanted) {
    on = wanted;
    button.setAttribute('aria-pressed', String(on));
    try {
      if (on) recognition.start();
      else recognition.stop();
    } catch {
      /* it had been started, or stopped, already */
    }
  }
  recognition.onresult = ({resultIndex, results}) => {
    for (const result of Array.from(results).slice(resultIndex)) {
      const event = result.isFinal ? eventOf(result) : interimOf(result);
      const repeats = event?.final === false && event.text === interim;
      interim = event?.final === false ? event.text : '';
      if (event && !repeats) heard(event);
    }
  };
  recognition.onerror = ({error}) => {
    if (harmless.includes(error)) return;
    listen(false);
    said(problems[error] ?? `The microphone gave up (${error}): type instead.`);
  };
  // Recognisers stop by themselves after a silence.
  recognition.onend = () => {
    if (on) listen(true);
  };
  return {element: button, close: () => listen(false)};
}
