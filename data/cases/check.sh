#!/usr/bin/env bash
# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Runs all cases at their small size and compares the results with the files in data/.
#
#   data/cases/check.sh [OUTPUT-DIRECTORY]
set -euo pipefail

here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
output="${1:-out/cases}"
"$here/twist/run.sh" "$output"
"$here/rayleigh_benard/run.sh" "$output"
"$here/channel/run.sh" "$output"

# CalculiX writes six digits; differences of neighbours are divided by the width of an element, which leaves five.
for name in twist_030 twist_100 twist_cube_54deg; do
  python3 "$here/compare.py" "$output/$name.vtu" "$here/../$name.vtu" 2e-5
done
# The same versions of the solvers give the same digits; others agree up to their tolerances.
for name in convection channel_laminar; do
  python3 "$here/compare.py" "$output/$name.vtu" "$here/../$name.vtu" 1e-4
done
