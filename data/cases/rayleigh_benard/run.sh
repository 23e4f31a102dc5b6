#!/usr/bin/env bash
# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Rayleigh-Benard convection in OpenFOAM: convection.vtu, the gradient of the velocity.
#
#   data/cases/rayleigh_benard/run.sh [--large] [OUTPUT-DIRECTORY]
#
# --large: 44 cells per unit of length instead of 11, convection_large.vtu; N=... for other grids.
set -euo pipefail

n="${N:-11}"
name=convection
if [[ "${1:-}" == --large ]]; then
  n="${N:-44}"
  name=convection_large
  shift
fi
output="${1:-out/cases}"
# shellcheck source=data/cases/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"
[[ "$n" =~ ^[1-9][0-9]*$ ]] || fail "N=$n: give a whole number of cells per unit of length"
prepare

cp -r "$cases_directory/rayleigh_benard/"{0,constant,system} "$work"
cd "$work"
# Time steps shrink with the cells, so that the Courant number stays.
sed -i "s/^N 11;/N $n;/; s/^N2 22;/N2 $((2 * n));/" system/blockMeshDict
sed -i "s/^deltaT 1;/deltaT $(awk -v n="$n" 'BEGIN { print 1 / int((n + 10) / 11) }');/" system/controlDict
quietly blockMesh
quietly setFields
quietly buoyantBoussinesqPimpleFoam
"$triplex" import . -o "$output/$name.vtu"
