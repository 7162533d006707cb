#!/usr/bin/env bash
# Executes tour.ipynb with the module of a build tree, and keeps it as tour.html: make.sh BUILD. Needs Debian's
# python3-nbconvert and python3-ipykernel, which no test does.
set -euo pipefail
build=$(cd "$1" && pwd)
cd "$(dirname "$0")"
{
  cat << 'END'
<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>A conversation with an avatar, replayed and questioned</title>
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
  PYDEVD_DISABLE_FILE_VALIDATION=1 PYTHONPATH=$build/python /usr/bin/python3 -m nbconvert --to html --template basic --execute --stdout --log-level ERROR tour.ipynb
  echo '</body></html>'
} > tour.html.new
mv tour.html.new tour.html
