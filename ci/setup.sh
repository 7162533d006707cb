#!/usr/bin/env bash
# Installs the missing packages of the build on Debian 12; with --tests those of the tests too. --list names those of the build.
set -euo pipefail

packages=(
  build-essential cmake ninja-build mold pkg-config git ca-certificates file
  libmujoco-dev libeigen3-dev libegl-dev libegl-mesa0 libgl1-mesa-dri
  libcpp-httplib-dev nlohmann-json3-dev libpugixml-dev libcli11-dev libfmt-dev libxxhash-dev libutf8proc-dev zlib1g-dev libzstd-dev libjemalloc-dev
  libgraphviz-dev libcairo2-dev fonts-dejavu-core ffmpeg
  pybind11-dev python3-dev
  catch2 librapidcheck-dev libbenchmark-dev
)
if [[ "${1:-}" == --list ]]; then
  echo "${packages[*]}"
  exit 0
fi
if [[ "${1:-}" == --tests ]]; then
  packages+=(ccache clang libclang-rt-14-dev chromium chromium-headless-shell locales lintian mmdebstrap zsh fish mypy praat libxml2-utils
    slurm-wlm munge espeak-ng pocketsphinx pocketsphinx-en-us
    python3-jsonschema python3-pytest python3-pandas python3-setuptools python3-wheel)
fi
# Another npm than Debian's may be installed; Debian's would remove it.
if ! command -v npm > /dev/null; then packages+=(nodejs npm); fi

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f='${Status}' "$package" 2> /dev/null || true)
  if [[ "$status" != "install ok installed" ]]; then missing+=("$package"); fi
done
if [[ ${#missing[@]} -eq 0 ]]; then exit 0; fi

as_root=()
if [[ $(id -u) -ne 0 ]]; then
  if ! command -v sudo > /dev/null; then
    echo "ci/setup.sh: missing ${missing[*]}; run as root, or install sudo" >&2
    exit 2
  fi
  as_root=(sudo)
fi
apt_get() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -y -o Acquire::Retries=3 "$@"; }

echo "ci/setup.sh: installing ${missing[*]}"
apt_get update
apt_get install --no-install-recommends "${missing[@]}" > /dev/null
