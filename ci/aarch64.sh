#!/usr/bin/env bash
# The same bytes on another kind of processor: builds for aarch64, replays all traces there under qemu-user, without
# physics, and compares with the release build. As root, with mmdebstrap, qemu-user and g++-aarch64-linux-gnu; skipped
# without them.
set -euo pipefail
cd "$(dirname "$0")/.."
for tool in mmdebstrap qemu-aarch64 aarch64-linux-gnu-g++; do
  if [[ $(id -u) != 0 ]] || ! command -v "$tool" > /dev/null; then
    echo "ci/aarch64.sh: skipped: it needs root, mmdebstrap, qemu-user and g++-aarch64-linux-gnu"
    exit 0
  fi
done
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-2}
build=build/aarch64 root=$PWD/build/aarch64/root libraries=usr/lib/aarch64-linux-gnu
mkdir -p "$build"

# The libraries of the build, unpacked: none of their programs is run.
if [[ ! -e $root/$libraries/libmujoco.so ]]; then
  for list in /etc/apt/sources.list.d/debian.sources /etc/apt/sources.list; do if [[ -s $list ]]; then break; fi; done
  packages=$(ci/setup.sh --list | tr ' ' '\n' | grep -E '^lib.*-dev$|^nlohmann|^zlib' | paste -sd,)
  rm -rf "$root"
  mmdebstrap --quiet --variant=extract --architectures=arm64 --include="libc6-dev,libstdc++-12-dev,$packages" bookworm "$root" "$list"
fi

export PKG_CONFIG_SYSROOT_DIR=$root PKG_CONFIG_LIBDIR=$root/$libraries/pkgconfig:$root/usr/share/pkgconfig
cmake --preset release -B "$build" -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 -DCMAKE_SYSROOT="$root" \
  -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ -DCMAKE_C_COMPILER=aarch64-linux-gnu-gcc -DCMAKE_LIBRARY_ARCHITECTURE=aarch64-linux-gnu \
  -DCMAKE_FIND_ROOT_PATH="$root" -DCMAKE_FIND_ROOT_PATH_MODE_PROGRAM=NEVER -DCMAKE_FIND_ROOT_PATH_MODE_LIBRARY=ONLY \
  -DCMAKE_FIND_ROOT_PATH_MODE_INCLUDE=ONLY -DCMAKE_FIND_ROOT_PATH_MODE_PACKAGE=ONLY -DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=bfd \
  -DCONTINUA_BUILD_TESTS=OFF -DCONTINUA_BUILD_PYTHON=OFF -DCONTINUA_WERROR=OFF > /dev/null
cmake --build "$build" --target continua

out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
mapfile -t traces < <(find traces -name '*.trace.jsonl' | sort)
sessions=../shared/data/pilot2018
if [[ -d $sessions ]]; then
  find "$sessions" -name '*.txt' | sort | awk 'NR % 7 == 0' | xargs build/continua import -o "$out/sessions/" 2> /dev/null
  traces+=("$out"/sessions/*.jsonl)
fi
build/continua replay "${traces[@]}" --no-physics -o "$out/here" > "$out/said"
qemu-aarch64 -L "$root" "$build/continua" replay "${traces[@]}" --no-physics -o "$out/there" > "$out/said"

decisions() { tail -n 1 "$1" | grep -o '"decisions":"[0-9a-f]*"'; }
# But for the first line, which names compiler and processor, and digests that cover it.
bytes() { sed -E -e 1d -e '/^."kind":"(block|end)"/s/"digest":"[0-9a-f]*"//' "$1"; }
logs=0 same=0
while read -r log; do
  name=${log#"$out/here/"}
  there=$out/there/$name
  ((++logs))
  if cmp -s <(bytes "$log") <(bytes "$there"); then
    ((++same))
  elif [[ $(decisions "$log") == $(decisions "$there") ]]; then
    echo "$name: the same decisions, other bytes" >&2
  else
    echo "$name: other decisions" >&2
  fi
done < <(find "$out/here" -name '*.run.jsonl' | sort)
echo "ci/aarch64.sh: $logs logs, $same of them the same bytes"
((same == logs))
