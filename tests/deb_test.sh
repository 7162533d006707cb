#!/usr/bin/env bash
# Makes the Debian package, has lintian judge it, unpacks it and runs the program from there, away from the source tree.
# With CONTINUA_BARE_ROOT=1 it is installed in a bare Debian 12 besides, and the README's tour runs there: two or three
# minutes, as root, with mmdebstrap. The argument is the build tree.
set -euo pipefail
build=$1
cd "$(dirname "$0")/.."
if ! command -v dpkg-shlibdeps > /dev/null; then echo "skipped: no dpkg-shlibdeps (dpkg-dev)"; exit 77; fi
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

cpack --config "$build/CPackConfig.cmake" -B "$out" > "$out/cpack.txt" || { cat "$out/cpack.txt" >&2; exit 1; }
package=$(echo "$out"/continua_*.deb)
if command -v lintian > /dev/null; then
  lintian --allow-root --fail-on error,warning "$package"
else
  echo "not judged: no lintian"
fi

# Nothing of the data is missing, and the program takes them from beside itself, wherever that is.
dpkg-deb -x "$package" "$out/root"
for folder in engine/knowledge mjcf traces; do diff -rq "$folder" "$out/root/usr/share/continua/$folder"; done
program=$out/root/usr/bin/continua
cd /
unset CONTINUA_HOME
"$program" machine interaction > /dev/null
"$program" replay "$out/root/usr/share/continua/traces/paper/correction.trace.jsonl" -o "$out/a.run.jsonl" > /dev/null
mv "$out/root/usr/share/continua" "$out/data"
if "$program" machine interaction 2> "$out/said" > /dev/null; then
  echo "the program found data although those beside it are gone" >&2
  exit 1
fi
grep -q 'set CONTINUA_HOME' "$out/said"
CONTINUA_HOME=$out/data "$program" check "$out/data/traces/paper" > /dev/null
echo "$(basename "$package"): $(stat -c %s "$package") bytes, runs from any place"

if [[ -z ${CONTINUA_BARE_ROOT:-} ]]; then echo "not installed in a bare root: CONTINUA_BARE_ROOT is not set"; exit 0; fi
if [[ $(id -u) != 0 ]] || ! command -v mmdebstrap > /dev/null; then echo "skipped: a bare root needs root and mmdebstrap"; exit 77; fi
cd - > /dev/null

# The tour in a folder of the new root that looks like the source tree, with the installed program and its data.
cat > "$out/tour" << 'END'
set -e
mkdir -p /tour/tests /tour/build
cp -r /usr/share/continua/* /tour
cp -r /usr/share/doc/continua/examples /root/pages/. /tour
mv /tour/readme_test.sh /tour/tests
ln -s /usr/bin/continua /tour/build/continua
continua doctor
bash /tour/tests/readme_test.sh /tour/build
echo "doctor and tour took $SECONDS s in a bare root"
END
mkdir "$out/pages"
cp -r README.md docs tests/readme_test.sh "$out/pages"
sources=(/etc/apt/sources.list.d/debian.sources /etc/apt/sources.list)
for list in "${sources[@]}"; do if [[ -s $list ]]; then break; fi; done
mmdebstrap --quiet --variant=minbase --format=null --dpkgopt=force-unsafe-io --include="$package" \
  --hook-dir=/usr/share/mmdebstrap/hooks/file-mirror-automount --customize-hook='mkdir "$1/root/pages"' --customize-hook="sync-in $out/pages /root/pages" \
  --customize-hook="upload $out/tour /root/tour" \
  --customize-hook='chroot "$1" env -i PATH=/usr/bin:/bin HOME=/root LC_ALL=C.UTF-8 bash /root/tour' \
  bookworm - "$list"
