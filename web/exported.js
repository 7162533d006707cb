// Starts the page in an exported file, or in a site of them: unpacks its modules, and the recorded answers about the
// run that is in the file, and runs them. Not a module itself: it stands in the file as it is.

// Recordings that are in the file: number -> address.
const mediaInside = () => {
  const media = new Map();
  for (const node of document.querySelectorAll('script[data-media]')) {
    const bytes = Uint8Array.from(atob(node.textContent), (letter) => letter.charCodeAt(0));
    const address = URL.createObjectURL(new Blob([bytes], {type: node.dataset.type}));
    media.set(Number(node.dataset.media), address);
  }
  return media;
};

(async () => {
  const unpacked = (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).text();
  };
  const nodes = [...document.querySelectorAll('script[data-module]')];
  const modules =
    globalThis.continua_modules ??
    Object.fromEntries(nodes.map((node) => [node.dataset.module, node.textContent.trim()]));
  const sources = new Map();
  const addresses = new Map();
  for (const [path, packed] of Object.entries(modules)) sources.set(path, await unpacked(packed));

  // A module's own address, once those that it imports have theirs.
  const addressOf = (path) => {
    if (!addresses.has(path)) {
      const source = sources
        .get(path)
        .replace(/(\bfrom\s*|\bimport\s*\(?\s*)(['"])(\.{1,2}\/[^'"\n]+)\2/g, (whole, keyword, quote, wanted) => {
          const other = new URL(wanted, `file://${path}`).pathname;
          return sources.has(other) ? `${keyword}${quote}${addressOf(other)}${quote}` : whole;
        });
      addresses.set(path, URL.createObjectURL(new Blob([source], {type: 'text/javascript'})));
    }
    return addresses.get(path);
  };

  // One answer a line: the question, a tab, the answer as JSON.
  const answersIn = (text) => {
    const answers = new Map();
    for (const line of text.split('\n')) {
      const tab = line.indexOf('\t');
      if (tab > 0) answers.set(line.slice(0, tab), line.slice(tab + 1));
    }
    return answers;
  };

  try {
    const inside = document.getElementById('answers');
    const answers = inside && answersIn(await unpacked(inside.textContent.trim()));
    globalThis.continua_recorded = {
      answers, // null in a site: it has files of them
      answersIn,
      unpacked,
      media: mediaInside(),
      start: answers ? JSON.parse(answers.get('start')) : '/',
      icon: document.querySelector('link[rel=icon]').href,
    };
    await import(addressOf('/main.js'));
  } catch (problem) {
    document.getElementById('page').textContent = `This file cannot be shown here: ${problem.message}`;
  }
})();
