#!/usr/bin/env bash
# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes every picture of docs/gallery.md, and docs/gallery/numbers.txt, which its figures are from. Installs what is missing and
# builds the program first; with TRIPLEX=PROGRAM in the environment it takes that one instead. Fields and meshes stay in out/gallery; with KEEP=1 those that are there are
# drawn again. Less than ten minutes on two cores, after the build.
# Usage: scripts/gallery.sh
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

if [[ -z "${TRIPLEX:-}" ]]; then
  scripts/install_packages.sh
  if command -v ccache >/dev/null; then
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache
  fi
  cmake --preset release
  cmake --build build/release --parallel "${JOBS:-$(nproc)}" --target triplex_program
  TRIPLEX=build/release/bin/triplex
fi

root=$PWD
pictures=$root/docs/gallery
numbers=$pictures/numbers.txt
triplex=$(realpath -- "$TRIPLEX")
mkdir -p "$pictures" out/gallery
authority=$(mktemp)  # of our own, so that xvfb-run has no directory to remove
trap 'rm -f -- "$authority"' EXIT
cd out/gallery
: >"$numbers"

# extract NAME FIELD [OPTION...]: meshes in out/gallery/NAME, the table in the numbers.
extract() {
  local name=$1 field=$2 status=0
  shift 2
  echo "== extract $name"
  if [[ -z "${KEEP:-}" || ! -f $name.txt ]]; then
    rm -rf -- "$name" "$name.txt"
    "$triplex" extract "$field" -o "$name" --quiet "$@" >table.txt || status=$?
    if [[ $status -ne 0 && $status -ne 2 ]]; then
      exit "$status"
    fi
    {
      echo "== $name"
      echo "triplex extract $(basename -- "$field")" "$@"
      cat table.txt
      # With --domains, their volumes.
      awk '/^  "domains": \{/ { inside = 1; next } /^  \}/ { inside = 0 } inside { print "volume " $0 }' "$name/report.json"
      echo
    } >"$name.txt"
  fi
  cat "$name.txt" >>"$numbers"
}

# on_display COMMAND...: draws without a screen.
on_display() {
  xvfb-run -a -f "$authority" -s "-screen 0 1280x1024x24" "$triplex" "$@"
}

# draw PICTURE DIR... OPTION...
draw() {
  local picture=$1
  shift
  on_display render "$@" -o "$pictures/$picture.png"
}

for part in "$root"/scripts/gallery/*.sh; do
  # shellcheck source=/dev/null
  source "$part"
done
du -ch "$pictures"/*.png | tail -n 1
