# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
#
# What the scripts of the cases share. Sourced after: set -euo pipefail.

cases_directory="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
triplex="${TRIPLEX:-$cases_directory/../../build/release/bin/triplex}"

# Debian's OpenFOAM has its settings here.
export WM_PROJECT_DIR="${WM_PROJECT_DIR:-/usr/share/openfoam}"

fail() {
  echo "${0##*/}: $*" >&2
  exit 1
}

# The solvers and the program; a directory for the results in $output, one for the run in $work, removed at the end.
prepare() {
  "$cases_directory/install_solvers.sh"
  [[ -x "$triplex" ]] || fail "no program $triplex; build it (scripts/demo.sh) or set TRIPLEX"
  triplex="$(realpath "$triplex")"
  mkdir -p "$output"
  output="$(realpath "$output")"
  work="$(mktemp -d)"
  trap 'rm -rf "$work"' EXIT
}

# Runs a program quietly; shows the end of its log if it fails.
quietly() {
  local log="$work/$1.log"
  if ! nice "$@" >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    fail "$1 failed"
  fi
}
