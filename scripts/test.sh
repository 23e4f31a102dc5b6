#!/usr/bin/env bash
# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs, builds and runs all tests: an optimised build with all assertions on, about 20 minutes on 2
# idle cores. With --sanitize the tests that are not slow run first under the address and undefined
# behaviour sanitizers, in a build of their own: twice as long again. The last lines are the summary
# of ctest.
set -euo pipefail

sanitize=false
for argument in "$@"; do
  case "$argument" in
    --sanitize) sanitize=true ;;
    *)
      echo "usage: scripts/test.sh [--sanitize]" >&2
      exit 1
      ;;
  esac
done
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
jobs=${JOBS:-$(nproc)}

scripts/install_packages.sh
if command -v ccache >/dev/null; then
  export CMAKE_CXX_COMPILER_LAUNCHER=ccache
fi

if $sanitize; then
  echo "== Sanitizers"
  cmake --preset asan
  cmake --build build/asan --parallel "$jobs"
  ctest --preset asan --parallel "$jobs"
fi

echo "== All tests"
cmake --preset test
cmake --build build/test --parallel "$jobs"
ctest --preset test --parallel "$jobs"
