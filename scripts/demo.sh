#!/usr/bin/env bash
# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs, builds, extracts the features of a real field and draws them. Leaves everything in
# out/demo. Usage: scripts/demo.sh [FIELD]; the default is data/rayleigh_benard.vtu.
set -euo pipefail

field=""
if [[ $# -gt 0 ]]; then
  field=$(realpath -- "$1")
fi
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
field=${field:-data/rayleigh_benard.vtu}
out=out/demo
jobs=${JOBS:-$(nproc)}

scripts/install_packages.sh
if command -v ccache >/dev/null; then
  export CMAKE_CXX_COMPILER_LAUNCHER=ccache
fi
cmake --preset release
cmake --build build/release --parallel "$jobs" --target triplex_program

mkdir -p "$out"
triplex=build/release/bin/triplex
echo
echo "== triplex extract $field"
status=0
"$triplex" extract "$field" -o "$out" || status=$?
if [[ $status -ne 0 && $status -ne 2 ]]; then
  exit "$status"
fi
echo
echo "== triplex render"
# With an authority file of our own, xvfb-run has no directory to remove: now and then that fails.
authority=$(mktemp)
trap 'rm -f -- "$authority"' EXIT
xvfb-run -a -f "$authority" -s "-screen 0 1280x1024x24" \
  "$triplex" render "$out" -o "$out/picture.png"

echo
echo "The demo is done."
echo "  surfaces and curve  $PWD/$out/*.vtp  (open them in ParaView)"
echo "  report              $PWD/$out/report.json"
echo "  picture             $PWD/$out/picture.png"
if [[ $status -eq 0 ]]; then
  echo "Everything in it is certified."
else
  echo "Everything in it is certified, but for the cells that the report lists as unresolved."
fi
