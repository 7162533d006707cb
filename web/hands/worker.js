// Finds a hand in pictures by MediaPipe's model, beside the page: only here may WebAssembly be compiled (docs/SECURITY.md).
// Says {ready: true} once; then each ImageBitmap that comes is answered by {found}, in the form of a HandLandmarker's
// result. {problem}: a sentence. A script, not a module: the library can only be loaded by importScripts().

const folder = new URL('.', location).pathname;
const settings = {
  selfieMode: true, // pictures are taken as a mirror shows them, so that sides are the human's own
  maxNumHands: 1,
  modelComplexity: 0, // the model that is installed: half the time of the other one
};

// The library takes itself to be in a page and loads its parts by script elements; this much of a page it gets.
globalThis.window = globalThis;
globalThis.document = {
  createElement: (name) => {
    if (name === 'canvas') return new OffscreenCanvas(1, 1);
    const script = {
      setAttribute: (key, value) => Object.assign(script, {[key]: value}),
      addEventListener: (event, act) => Object.assign(script, {[event]: act}),
    };
    return script;
  },
  body: {
    appendChild: (script) => {
      importScripts(script.src);
      script.load();
    },
  },
};
// It tells of its graphics at every start.
console.warn = () => {};

let finder = null;
let found = null;

async function begin() {
  importScripts(`${folder}hands.js`);
  finder = new globalThis.Hands({locateFile: (name) => folder + name});
  finder.setOptions(settings);
  finder.onResults(({multiHandLandmarks, multiHandWorldLandmarks, multiHandedness}) => {
    found = {
      handedness: multiHandedness.map(({label, score}) => [{categoryName: label, score}]),
      landmarks: multiHandLandmarks,
      worldLandmarks: multiHandWorldLandmarks,
    };
  });
  await finder.initialize();
  postMessage({ready: true});
}

const tell = (problem) => postMessage({problem: String(problem.message ?? problem)});

addEventListener('message', async ({data: picture}) => {
  try {
    await finder.send({image: picture});
    postMessage({found});
  } catch (problem) {
    tell(problem);
  } finally {
    picture.close();
  }
});
begin().catch(tell);
