#!/usr/bin/env bash
# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Twisted block and cube in CalculiX: twist_030.vtu, twist_100.vtu, twist_cube_54deg.vtu.
# With --large: twist_030_large.vtu, twist_100_large.vtu (36 x 36 x 72 elements).
#
#   data/cases/twist/run.sh [--large] [OUTPUT-DIRECTORY]
set -euo pipefail

nx=10
suffix=""
if [[ "${1:-}" == --large ]]; then
  nx=36
  suffix="_large"
  shift
fi
output="${1:-out/cases}"
# shellcheck source=data/cases/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"
prepare
mesh="$cases_directory/twist/mesh.awk"
cd "$work"

awk -v "nx=$nx" -v "nz=$((2 * nx))" -v length_z=2 -v "degrees=5.4 18" -v release=0 -v type=C3D8 \
  -f "$mesh" >block.inp
quietly ccx block
"$triplex" import block.frd --time 1 -o "$output/twist_030$suffix.vtu"
"$triplex" import block.frd --time 2 -o "$output/twist_100$suffix.vtu"

if [[ -z "$suffix" ]]; then
  awk -v nx=14 -v nz=14 -v length_z=1 -v degrees=54 -v release=1 -v type=C3D8 -f "$mesh" >cube.inp
  quietly ccx cube
  "$triplex" import cube.frd -o "$output/twist_cube_54deg.vtu"
fi
