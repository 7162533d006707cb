#!/usr/bin/env bash
# Executes the notebooks with the module and the program of a build tree, and keeps each as a page: make.sh BUILD. Needs
# Debian's python3-nbconvert and python3-ipykernel, which no test does. pilot.ipynb also needs the recordings of the
# pilot study (CONTINUA_PILOT, a folder), and is left as it is without.
set -euo pipefail
build=$(cd "$1" && pwd)
cd "$(dirname "$0")"

page() {  # NAME TITLE
  {
    cat << END
<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>$2</title>
<style>
  body { max-width: 60rem; margin: 2rem auto; padding: 0 1rem; font: 16px/1.5 sans-serif; color-scheme: light dark; }
  pre { font: 13px/1.4 monospace; overflow-x: auto; }
  .input pre { padding: 0.6rem; border-left: 3px solid #48f; background: #8881; }
  .prompt, .anchor-link { display: none; }
  table { border-collapse: collapse; font-size: 14px; }
  th, td { padding: 0.2rem 0.7rem; border-bottom: 1px solid #8885; text-align: left; }
  img { max-width: 100%; }
</style>
<body>
END
    PATH=$build:$PATH PYDEVD_DISABLE_FILE_VALIDATION=1 PYTHONPATH=$build/python /usr/bin/python3 -m nbconvert --to html --template basic --execute --stdout --log-level ERROR "$1.ipynb"
    echo '</body></html>'
  } > "$1.html.new"
  mv "$1.html.new" "$1.html"
}

page tour "A conversation with an avatar, replayed and questioned"
if [ -n "${CONTINUA_PILOT:-}" ]; then
  page pilot "Three figures of a pilot study, from tables"
fi
