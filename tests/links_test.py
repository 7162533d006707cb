#!/usr/bin/env python3
"""Checks that pages and comments cite only what the repository has: links_test.py SOURCE_DIR.

In pages: the targets of links, headings of pages included. In all files: names of pages (RUNLOG.md), the sections of
SEMANTICS.md, and sources with their folder (world/geometry.h).
"""
import re
import subprocess
import sys
from pathlib import Path

root = Path(sys.argv[1])
listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"], cwd=root, text=True,
                        capture_output=True)
if listed.returncode != 0:
    print("links_test.py: skipped: not a git checkout", file=sys.stderr)
    sys.exit(77)
files = [name for name in listed.stdout.splitlines() if (root / name).is_file()]
pages = [name for name in files if name.endswith(".md")]
page_names = {Path(name).name for name in pages}
SOURCES = (".md", ".h", ".cpp", ".js", ".mjs", ".sh", ".py", ".json", ".txt", ".cmake", ".xml")
problems = []


def anchors(page):
    """The anchors that Markdown viewers make of a page's headings."""
    text = re.sub(r"^```.*?^```", "", (root / page).read_text(), flags=re.MULTILINE | re.DOTALL)
    headings = re.findall(r"^#+ (.*)$", text, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def check_link(page, line, target):
    path, _, anchor = target.partition("#")
    where = (root / page).parent / path if path else root / page
    if not where.exists():
        problems.append(f"{page}:{line}: found a link to {target}, expected a file of the repository")
    elif anchor and where.suffix == ".md" and anchor not in anchors(where.resolve().relative_to(root.resolve())):
        problems.append(f"{page}:{line}: found a link to {target}, expected a heading of that page")


# A cited source may be named from any of these folders, or from the file's own.
BASES = [root, root / "engine", root / "replay", root / "tests", root / "web"]
# Files of others that comments name.
FOREIGN = {"graphviz/gvc.h", "mujoco/mujoco.h"}


def check_source(name, line, cited):
    bases = [*BASES, (root / name).parent, (root / name).parent.parent]
    if cited not in FOREIGN and not any((base / cited).exists() for base in bases):
        problems.append(f"{name}:{line}: found {cited}, expected a file of the repository")


sections = set(re.findall(r"^## (\d+)\.", (root / "engine/SEMANTICS.md").read_text(), re.MULTILINE))
for name in files:
    if not name.endswith(SOURCES) or name.startswith(("web/node_modules", "traces/")) and not name.endswith(".md"):
        continue
    for number, line in enumerate((root / name).read_text(errors="replace").splitlines(), 1):
        if name.endswith(".md"):
            for target in re.findall(r"\]\(([^)\s]+)\)", line):
                if not re.match(r"[a-z]+:", target):
                    check_link(name, number, target)
        for cited in re.findall(r"\b([A-Z][A-Z_]+\.md)\b", line):
            if cited not in page_names:
                problems.append(f"{name}:{number}: found {cited}, expected a page of the repository")
        for cited in re.findall(r"(?<![\w./<\"-])((?:[a-z_0-9]+/)+[a-z_0-9]+\.(?:h|cpp|sh|js))\b", line):
            check_source(name, number, cited.removeprefix("continua/"))
        for section in re.findall(r"SEMANTICS\.md §(\d+)", line):
            if section not in sections:
                problems.append(f"{name}:{number}: found SEMANTICS.md §{section}, which it does not have")
print("\n".join(problems), file=sys.stderr)
sys.exit(1 if problems else 0)
