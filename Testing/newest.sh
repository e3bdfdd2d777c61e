#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Runs a command of this project on a copy of it in a root directory with Debian testing, and so with
# a newer VTK than the system's. The root is kept in ~/.cache/participating-media, made anew after a
# month; build/vtk-newest is a link to its build folder.
#
# usage: Testing/newest.sh COMMAND [ARGUMENT...]
#
# The mirror and the settings of apt and pip, DNS and CA certificates are this machine's.
# PARTICIPATING_MEDIA_DEBIAN_MIRROR names the mirror where apt has none, as on Ubuntu.

set -euo pipefail
# shellcheck source=Testing/setup.sh
source "$(dirname "$0")/setup.sh"
[ $# -gt 0 ] || { usage; exit 1; }

suite=testing
keyring=/usr/share/keyrings/debian-archive-keyring.gpg
root=${XDG_CACHE_HOME:-$HOME/.cache}/participating-media/debian-$suite
copy=/usr/src/participating-media

debian_mirror() {
  local mirror=${PARTICIPATING_MEDIA_DEBIAN_MIRROR:-}
  if [ -z "$mirror" ]; then
    # shellcheck disable=SC2016 # apt expands these
    mirror=$(apt-get indextargets --format '$(ORIGIN) $(COMPONENT) $(LABEL) $(REPO_URI)' 'Created-By: Packages' |
      awk '$1 == "Debian" && $2 == "main" && $3 == "Debian" { print $4; exit }')
  fi
  [ -n "$mirror" ] || die "apt on this machine has no Debian mirror;" \
    "set PARTICIPATING_MEDIA_DEBIAN_MIRROR to the address of one"
  echo "$mirror"
}

# A mirror may lag behind; then its testing suite would be refused as out of date.
apt_settings() {
  apt-config dump Acquire | grep -E '^Acquire::(http|https|Check-|Force|Retries|Max-)' || :
  echo 'Acquire::Check-Valid-Until "false";'
}

make_root() {
  local packages mirror start=$SECONDS made=$root.new
  install_packages mmdebstrap debootstrap debian-archive-keyring
  mirror=$(debian_mirror)
  packages=(ca-certificates "${packages_build[@]}" "${packages_test[@]}")
  say "Making a root with Debian $suite in $root (some minutes; log: $log)"
  apt_settings > "$project/build/apt.conf"
  as_root rm -rf --one-file-system "$made" "$root"
  mkdir -p "${root%/*}"
  if ! as_root mmdebstrap --mode=root --variant=minbase --keyring="$keyring" \
    --aptopt="$project/build/apt.conf" --include="$(IFS=,; echo "${packages[*]}")" \
    "$suite" "$made" "deb [signed-by=$keyring] $mirror $suite main" >>"$log" 2>&1 </dev/null; then
    echo "mmdebstrap failed, trying debootstrap"
    as_root rm -rf --one-file-system "$made"
    logged as_root debootstrap --variant=minbase --keyring="$keyring" "$suite" "$made" "$mirror"
    as_root cp "$project/build/apt.conf" "$made/etc/apt/apt.conf.d/99participating-media"
    enter "$made" / apt-get update
    enter "$made" / apt-get install --yes --no-install-recommends "${packages[@]}"
  fi
  as_root mv "$made" "$root"
  as_root touch "$root" # its age decides when it is made anew
  echo "Made in $((SECONDS - start)) s"
}

# enter ROOT FOLDER COMMAND...: runs the command in the root, with this machine's access to the network.
enter() {
  local into=$1 folder=$2 file; shift 2
  for file in /etc/resolv.conf /etc/hosts /etc/pip.conf /etc/ssl/certs/ca-certificates.crt; do
    if [ -r "$file" ] && [ -d "$into${file%/*}" ]; then as_root cp -L --remove-destination "$file" "$into$file"; fi
  done
  [ -c "$into/dev/null" ] || as_root mknod -m 666 "$into/dev/null" c 1 3 || die "cannot make $into/dev/null"
  # shellcheck disable=SC2016 # expanded inside
  as_root env --unset=DISPLAY --unset=WAYLAND_DISPLAY --unset=XDG_RUNTIME_DIR --unset=XDG_CACHE_HOME \
    --unset=CMAKE_CXX_COMPILER_LAUNCHER \
    HOME=/root TMPDIR=/tmp LANG=C.UTF-8 PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    chroot "$into" /bin/sh -c 'cd "$1" && shift && exec "$@"' sh "$folder" "$@" </dev/null
}

mkdir -p "$project/build"
if [ ! -d "$root" ] || [ -n "$(find "$root" -maxdepth 0 -mtime +30)" ]; then make_root; fi

say "Copying the project into $root$copy"
as_root mkdir -p "$root$copy"
as_root find "$root$copy" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} +
tar -C "$project" --exclude-vcs --exclude=./build --exclude='./build-*' --exclude=./Examples/output -cf - . |
  as_root tar -C "$root$copy" --no-same-owner -xf -
ln -sfn "$root$copy/build" "$project/build/vtk-newest"

enter "$root" "$copy" "$@"
