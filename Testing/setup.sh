# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
#
# What the scripts of this project share: package lists for Debian and Ubuntu, quiet installation
# with a log, the build, and a window system to render into. Sourced by bash, never run.
# shellcheck shell=bash

# shellcheck disable=SC2034 # these lists are for the scripts that source this file
packages_build=(libvtk9-dev python3-vtk9 libglm-dev g++ cmake ninja-build
  libgl1-mesa-dri libegl1 xvfb xauth)
# shellcheck disable=SC2034
packages_test=(libgtest-dev python3-venv python3-numpy) \
  packages_examples=(invesalius-examples) packages_fuzz=(clang libclang-rt-dev) \
  packages_style=(clang-format clang-tidy codespell shellcheck) \
  packages_benchmark=(libbenchmark-dev libllvm19)

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
log=$project/build/setup.log
export DEBIAN_FRONTEND=noninteractive
if command -v ccache >/dev/null; then export CMAKE_CXX_COMPILER_LAUNCHER=ccache; fi

say() { printf '\n==> %s\n' "$*"; }
die() { printf '%s: %s\n' "${0##*/}" "$*" >&2; exit 1; }

# Prints the comment at the head of the calling script, from its first sentence on.
usage() { sed -n '/^$/q; /^#!/d; /SPDX/d; s/^#\( \|$\)//p' "$0"; }

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"
  elif command -v sudo >/dev/null; then sudo --preserve-env=DEBIAN_FRONTEND,http_proxy,https_proxy,no_proxy "$@"
  else die "needs root to install packages: run it as root, or install sudo"; fi
}

# Runs a command with its output in the log; the end of the log is shown if it fails.
logged() {
  mkdir -p "${log%/*}"
  if ! "$@" >>"$log" 2>&1 </dev/null; then
    tail -n 20 "$log" >&2
    die "'$*' failed; its output is in $log"
  fi
}

installed() { dpkg-query --show --showformat '${db:Status-Status}\n' "$1" 2>/dev/null | grep -qx installed; }

# Installs those of the named Debian packages that are missing.
install_packages() {
  local missing=() package start=$SECONDS
  command -v apt-get >/dev/null || die "needs apt-get (Debian 12 or newer, Ubuntu 24.04 or newer);" \
    "elsewhere install VTK 9.1 or newer, GLM and GoogleTest and use CMake, see CONTRIBUTING.md"
  for package in "$@"; do installed "$package" || missing+=("$package"); done
  if [ ${#missing[@]} = 0 ]; then say "All $# packages are installed already"; return; fi
  say "Installing ${missing[*]} (some minutes; log: $log)"
  logged as_root apt-get -o DPkg::Lock::Timeout=300 update
  logged as_root apt-get -o DPkg::Lock::Timeout=300 install --yes --no-install-recommends "${missing[@]}"
  echo "Installed in $((SECONDS - start)) s"
}

# build PRESET [CMAKE OPTION...]: configures and builds into build/PRESET.
build() {
  local preset=$1 start=$SECONDS; shift
  say "Building into build/$preset"
  cd "$project" || exit
  cmake --preset "$preset" "$@" | sed -E '/^-- (Found|Performing|Looking|Detecting|Check)/d'
  cmake --build --preset "$preset" --parallel "$(nproc)"
  echo "Built in $((SECONDS - start)) s"
}

# build_targets PRESET TARGET...: the same, of some targets only.
build_targets() {
  local preset=$1 start=$SECONDS; shift
  say "Building into build/$preset"
  cd "$project" || exit
  cmake --preset "$preset" -DPARTICIPATING_MEDIA_BUILD_TESTING=ON >/dev/null
  cmake --build --preset "$preset" --parallel "$(nproc)" --target "$@" | tail -n 1
  echo "Built in $((SECONDS - start)) s"
}

# True where the installed VTK can make a window without an X server.
vtk_has_egl() {
  dpkg --compare-versions "$(dpkg-query --show --showformat '${source:Upstream-Version}' libvtk9-dev)" ge 9.4
}

# Runs a command that renders: on the display if there is one, else without one. VTK before 9.4 knows
# X only; -noreset keeps xvfb-run of Debian 12 from replacing the command's exit status.
with_display() {
  if [ -n "${DISPLAY:-}" ]; then "$@"
  elif vtk_has_egl; then VTK_DEFAULT_OPENGL_WINDOW=vtkEGLRenderWindow "$@"
  else
    [ -d /tmp/.X11-unix ] || mkdir -m 1777 /tmp/.X11-unix
    xvfb-run --auto-servernum --server-args '-screen 0 1280x1024x24 -noreset' "$@"
  fi
}
