#!/usr/bin/env python3
"""Prints docs/architecture.svg: the folders of engine/ and replay/, and which of them may include which.

    ci/architecture.py > docs/architecture.svg

Names and arrows come from the two CMakeLists.txt (MAY_INCLUDE), the words below a name from the tables of the two
README.md, up to the first colon. An arrow that follows from others is left out. A test compares the picture.
"""
import re
import sys
from pathlib import Path
from xml.sax.saxutils import escape

ROOT = Path(__file__).resolve().parent.parent
BOX_WIDTH, BOX_HEIGHT, GAP, LANE = 172, 58, 20, 16  # px; LANE is the room of an arrow that passes a layer
LAYER_STEP = BOX_HEIGHT + 36
LEAST_WIDTH, MARGIN, TITLE_HEIGHT = 1064, 28, 62
# Folders that may include no more of the engine than these read run logs and nothing else.
READERS_MAY_INCLUDE = {"core", "term"}

FIXED_STYLE = """
  text { font-family: system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif; }
  .name { font: 600 15px ui-monospace, "DejaVu Sans Mono", monospace; }
  .words, .legend { font-size: 11.5px; }
  .title { font-size: 20px; font-weight: 600; }
  .about { font-size: 13px; }
  .data { stroke-dasharray: 4 3; }
  .arrow { fill: none; stroke-width: 1.4; }
"""
# Elements, their property, its value in a light and in a dark surrounding.
COLOURS = [
    ("text", "fill", "#23211d", "#ecebe8"),
    (".words, .legend, .about", "fill", "#6b665c", "#a5a29b"),
    (".paper", "fill", "#fbfaf7", "#1b1b1d"),
    (".panel", "fill", "#f1eee7", "#232326"),
    (".panel", "stroke", "#d9d3c5", "#38383d"),
    (".engine", "fill", "#dcebe4", "#21382f"),
    (".engine", "stroke", "#6fa58c", "#4f8a70"),
    (".runs", "fill", "#fbe7cf", "#40311f"),
    (".runs", "stroke", "#d39a4f", "#a97b3f"),
    (".reads", "fill", "#dde6f6", "#26324a"),
    (".reads", "stroke", "#7f9dd0", "#5f7fb8"),
    (".data", "fill", "#ffffff", "#2a2a2e"),
    (".data", "stroke", "#bdb5a4", "#55545a"),
    (".arrow", "stroke", "#a69e8e", "#77746d"),
    (".head", "fill", "#a69e8e", "#77746d"),
]


def style():
    light = "".join(f"  {names} {{ {of}: {colour}; }}\n" for names, of, colour, _ in COLOURS)
    dark = "".join(f"    {names} {{ {of}: {colour}; }}\n" for names, of, _, colour in COLOURS)
    return f"{FIXED_STYLE}{light}  @media (prefers-color-scheme: dark) {{\n{dark}  }}\n"


def floors(path):
    """The folders of a CMakeLists.txt, each with the set of folders that it may include."""
    text = re.sub(r"#[^\n]*", "", path.read_text())
    lists = {name: words.split() for name, words in re.findall(r"set\((\w+)\s([^()]*)\)", text)}
    found = {}
    for folder, words in re.findall(r"continua_folder\((\w+)\s+MAY_INCLUDE\s+([^()]*)\)", text):
        words = re.split(r"\b(?:NEEDS|PRECOMPILES)\b", words)[0]
        words = re.sub(r"\$\{(\w+)\}", lambda match: " ".join(lists[match[1]]), words)
        found[folder] = set(words.split()) - {"nothing", "web"}
    return found


def subjects(page):
    """The words for each folder: the second cell of the page's table, up to the first colon."""
    rows = re.findall(r"^\| ((?:`[\w/]+`(?:, )?)+) \| ([^|:]*)", page.read_text(), re.MULTILINE)
    return {name.rstrip("/"): words.strip() for names, words in rows for name in re.findall(r"`([\w/]+)`", names)}


def without_implied(allowed):
    """Only the arrows that do not follow from others."""
    reach = {}

    def below(folder):
        if folder not in reach:
            reach[folder] = set().union(*({each} | below(each) for each in allowed[folder])) if allowed[folder] else set()
        return reach[folder]

    return {folder: {each for each in others if not any(each in below(other) for other in others)}
            for folder, others in allowed.items()}


class Graph:
    """Boxes in layers: each as low as what it includes lets it be. An arrow over several layers gets a lane in each."""

    def __init__(self, allowed):
        self.arrows = without_implied(allowed)
        self.layer = {}
        for folder in allowed:
            self._place(folder)
        self.layers = [[] for _ in range(max(self.layer.values()) + 1)]
        for folder in allowed:
            self.layers[self.layer[folder]].append(folder)
        self.paths = []  # an arrow as nodes from the upper box to the lower one
        for upper in allowed:
            for lower in sorted(self.arrows[upper]):
                lanes = [(upper, lower, layer) for layer in range(self.layer[upper] - 1, self.layer[lower], -1)]
                for lane in lanes:
                    self.layers[lane[2]].append(lane)
                self.paths.append([upper, *lanes, lower])
        self.neighbours = {node: [] for layer in self.layers for node in layer}
        for path in self.paths:
            for one, other in zip(path, path[1:]):
                self.neighbours[one].append(other)
                self.neighbours[other].append(one)
        self._order()

    def _place(self, folder):
        if folder not in self.layer:
            self.layer[folder] = 1 + max((self._place(each) for each in self.arrows[folder]), default=-1)
        return self.layer[folder]

    def _crossings(self, layers):
        place = {node: index for layer in layers for index, node in enumerate(layer)}
        level = {node: index for index, layer in enumerate(layers) for node in layer}
        count = 0
        for index in range(1, len(layers)):
            ends = sorted((place[node], place[other]) for node in layers[index] for other in self.neighbours[node]
                          if level[other] == index - 1)
            count += sum(a[0] < b[0] and a[1] > b[1] for number, a in enumerate(ends) for b in ends[number + 1:])
        return count

    def _order(self):
        """Few crossings: each layer goes by the mean place of its neighbours, then neighbours swap while that helps."""
        best = [list(layer) for layer in self.layers]
        layers = [list(layer) for layer in self.layers]
        for sweep in range(24):
            place = {node: index / len(layer) for layer in layers for index, node in enumerate(layer)}
            for layer in layers if sweep % 2 else reversed(layers):
                def middle(node):
                    others = self.neighbours[node]
                    return sum(place[other] for other in others) / len(others) if others else place[node]
                layer.sort(key=lambda node: (middle(node), str(node)))
                place.update({node: index / len(layer) for index, node in enumerate(layer)})
            if self._crossings(layers) < self._crossings(best):
                best = [list(layer) for layer in layers]
        improved = True
        while improved:
            improved = False
            for layer in best:
                for index in range(len(layer) - 1):
                    before = self._crossings(best)
                    layer[index], layer[index + 1] = layer[index + 1], layer[index]
                    if self._crossings(best) < before:
                        improved = True
                    else:
                        layer[index], layer[index + 1] = layer[index + 1], layer[index]
        self.layers = best

    @staticmethod
    def _width(node):
        return LANE if isinstance(node, tuple) else BOX_WIDTH

    def _room(self, layer):
        return sum(self._width(node) + GAP for node in layer) - GAP

    def width(self):
        return max(self._room(layer) for layer in self.layers)

    def spread(self, inner):
        """Centres in x: near the neighbours' mean, no two boxes closer than GAP, all within the inner width."""
        self.x = {}
        for layer in self.layers:
            left = (inner - self._room(layer)) / 2
            for node in layer:
                self.x[node] = left + self._width(node) / 2
                left += self._width(node) + GAP
        for _ in range(200):
            for layer in self.layers:
                wish = [self._wish(node, inner) for node in layer]
                self._settle(layer, wish, inner)

    def _wish(self, node, inner):
        """Near the neighbours, lanes in line with lanes, all a little towards the middle."""
        pulls = [(self.x[other], 6 if isinstance(node, tuple) and isinstance(other, tuple) else 1)
                 for other in self.neighbours[node]] + [(inner / 2, 0.25)]
        return sum(x * weight for x, weight in pulls) / sum(weight for _, weight in pulls)

    def _settle(self, layer, wish, inner):
        apart = [(self._width(a) + self._width(b)) / 2 + GAP for a, b in zip(layer, layer[1:])]
        low = [self._width(layer[0]) / 2]
        for distance in apart:
            low.append(low[-1] + distance)
        high = [inner - self._width(layer[-1]) / 2]
        for distance in reversed(apart):
            high.insert(0, high[0] - distance)
        wish = [(2 * self.x[node] + place) / 3 for node, place in zip(layer, wish)]
        # Pushed apart to the right, and to the left: the mean of the two keeps the distances and takes no side.
        right, left = list(wish), list(wish)
        for index in range(len(wish)):
            right[index] = max(right[index], right[index - 1] + apart[index - 1] if index else low[0])
        for index in reversed(range(len(wish))):
            left[index] = min(left[index], left[index + 1] - apart[index] if index + 1 < len(wish) else high[-1])
        at = [min(max((a + b) / 2, least), most) for a, b, least, most in zip(right, left, low, high)]
        self.x.update(zip(layer, at))


class Picture:
    def __init__(self, width):
        self.width, self.parts, self.y = width, [], MARGIN

    def text(self, x, y, kind, words, anchor="start"):
        self.parts.append(f'<text class="{kind}" x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{escape(words)}</text>')

    def box(self, x, y, width, height, kind, radius=9):
        self.parts.append(f'<rect class="{kind}" x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" '
                          f'rx="{radius}"/>')

    def folder(self, centre, top, kind, name, words):
        self.box(centre - BOX_WIDTH / 2, top, BOX_WIDTH, BOX_HEIGHT, kind)
        lines = wrapped(words, 27)
        first = top + (33 if not lines else 25 if len(lines) == 1 else 21)
        self.text(centre, first, "name", name, "middle")
        for number, line in enumerate(lines):
            self.text(centre, first + 16 + 13 * number, "words", line, "middle")

    def panel(self, title, about, height):
        self.box(MARGIN, self.y, self.width - 2 * MARGIN, height, "panel", 14)
        self.text(2 * MARGIN, self.y + 30, "title", title)
        self.text(2 * MARGIN, self.y + 50, "about", about)

    def graph(self, title, about, graph, kind_of, words):
        height = TITLE_HEIGHT + len(graph.layers) * LAYER_STEP - (LAYER_STEP - BOX_HEIGHT) + MARGIN + 12
        self.panel(title, about, height)
        top = {}
        for number, layer in enumerate(graph.layers):
            for node in layer:
                top[node] = self.y + TITLE_HEIGHT + 14 + (len(graph.layers) - 1 - number) * LAYER_STEP
        for path in graph.paths:
            self.arrow(graph, path, top)
        for layer in graph.layers:
            for node in layer:
                if not isinstance(node, tuple):
                    self.folder(graph.x[node] + 2 * MARGIN, top[node], kind_of(node), node, words[node])
        self.y += height + MARGIN

    def arrow(self, graph, path, top):
        x = graph.x[path[0]] + 2 * MARGIN + self._port(graph, path[0], path[1])
        y = top[path[0]] + BOX_HEIGHT
        line = f"M{x:.1f} {y:.1f}"
        for before, node in zip(path, path[1:]):
            last = node == path[-1]
            to_x = graph.x[node] + 2 * MARGIN + (self._port(graph, node, before) if last else 0)
            to_y = top[node] - (6 if last else 0)
            bend = (y + to_y) / 2
            line += f" C{x:.1f} {bend:.1f} {to_x:.1f} {bend:.1f} {to_x:.1f} {to_y:.1f}"
            x, y = to_x, to_y
            if not last:
                y += BOX_HEIGHT
                line += f" V{y:.1f}"
        self.parts.append(f'<path class="arrow" d="{line}"/>')
        self.parts.append(f'<path class="head" d="M{x - 4:.1f} {y - 2:.1f} h8 l-4 8 z"/>')

    @staticmethod
    def _port(graph, node, other):
        """How far from the middle of a box its arrow to or from another node begins: in the order of the others."""
        down = [each for each in graph.neighbours[node]
                if graph_layer(graph, each) < graph_layer(graph, node)]
        side = down if other in down else [each for each in graph.neighbours[node] if each not in down]
        side.sort(key=lambda each: (graph.x[each], str(each)))
        room = min(24, (BOX_WIDTH - 40) / max(1, len(side) - 1))
        return (side.index(other) - (len(side) - 1) / 2) * room


def graph_layer(graph, node):
    return node[2] if isinstance(node, tuple) else graph.layer[node]


def wrapped(words, width):
    """At most two lines of about the same length."""
    if len(words) <= width:
        return [words] if words else []
    spaces = [match.start() for match in re.finditer(" ", words)]
    cut = min(spaces, key=lambda place: abs(2 * place - len(words)))
    return [words[:cut], words[cut + 1:]]


def main():
    engine, replay = floors(ROOT / "engine/CMakeLists.txt"), floors(ROOT / "replay/CMakeLists.txt")
    words = {name: subjects(ROOT / name / "README.md") for name in ("engine", "replay")}
    for name, folders in (("engine", engine), ("replay", replay)):
        for folder in folders:
            if folder not in words[name]:
                sys.exit(f"architecture.py: the table of {name}/README.md has no row `{folder}`")
    inside = {folder: others & set(replay) for folder, others in replay.items()}
    reads = {folder for folder, others in replay.items() if others & set(engine) <= READERS_MAY_INCLUDE}

    graphs = Graph(inside), Graph(engine)
    width = max(LEAST_WIDTH, *(graph.width() + 4 * MARGIN for graph in graphs))
    for graph in graphs:
        graph.spread(width - 4 * MARGIN)

    picture = Picture(width)
    picture.panel("web", "The page in the browser: plain ES modules, served or exported by replay.", 70)
    picture.y += 70 + MARGIN
    picture.graph("replay", "The program continua, around the engine. An arrow says: may include.", graphs[0],
                  lambda folder: "reads" if folder in reads else "runs", words["replay"])
    legend = picture.y - MARGIN - 20
    for x, kind, text in ((2 * MARGIN, "reads", "does not know the engine"), (2 * MARGIN + 200, "runs", "uses the engine")):
        picture.box(x, legend - 11, 14, 14, kind, 3)
        picture.text(x + 21, legend, "legend", text)
    picture.graph("engine", "What the human did becomes what the avatar thinks, says and does. The engine does not know replay.",
                  graphs[1], lambda folder: "engine", words["engine"])
    kinds = sorted(path.name for path in (ROOT / "engine/knowledge").iterdir() if path.is_dir())
    data = [("engine/knowledge", ", ".join(kinds)), ("mjcf", "scenes, objects, the arm"),
            ("traces", "recorded interactions, each with its approved run")]
    picture.panel("data", "Files that need no compiler.", 62 + BOX_HEIGHT + 18)
    step = (width - 4 * MARGIN + GAP) / len(data)
    for number, (name, about) in enumerate(data):
        left, top = 2 * MARGIN + number * step, picture.y + 62
        picture.box(left, top, step - GAP, BOX_HEIGHT, "data")
        picture.text(left + (step - GAP) / 2, top + 25, "name", name, "middle")
        picture.text(left + (step - GAP) / 2, top + 43, "words", about, "middle")
    height = picture.y + 62 + BOX_HEIGHT + 18 + MARGIN
    print(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
          f'role="img" aria-label="The folders of Continua and what each may include">')
    print(f"<style>{style()}</style>")
    print(f'<rect class="paper" width="{width}" height="{height}" rx="16"/>')
    print("\n".join(picture.parts))
    print("</svg>")


main()
