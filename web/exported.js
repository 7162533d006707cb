// Starts the page in an exported file: unpacks its modules and the recorded answers about the run, and runs them. Not a
// module itself: it stands in the file as it is.
(async () => {
  const unpacked = (node) => {
    const bytes = Uint8Array.from(atob(node.textContent.trim()), (letter) => letter.charCodeAt(0));
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip')));
  };
  const sources = new Map();
  const addresses = new Map();
  for (const node of document.querySelectorAll('script[data-module]'))
    sources.set(node.dataset.module, await unpacked(node).text());

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

  try {
    // One answer a line: the question, a tab, the answer as JSON.
    const answers = new Map();
    for (const line of (await unpacked(document.getElementById('answers')).text()).split('\n')) {
      const tab = line.indexOf('\t');
      if (tab > 0) answers.set(line.slice(0, tab), line.slice(tab + 1));
    }
    globalThis.continua_recorded = {
      answers,
      start: JSON.parse(answers.get('start')),
      icon: document.querySelector('link[rel=icon]').href,
    };
    await import(addressOf('/main.js'));
  } catch (problem) {
    document.getElementById('page').textContent = `This file cannot be shown here: ${problem.message}`;
  }
})();
