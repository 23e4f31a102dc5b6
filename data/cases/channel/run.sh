#!/usr/bin/env bash
# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Open-channel flow past a cylinder in OpenFOAM on tets by gmsh: channel_laminar.vtu, the gradient of the velocity.
#
#   data/cases/channel/run.sh [--large] [OUTPUT-DIRECTORY]
#
# --large: edges of 0.08 instead of 0.25, channel_laminar_large.vtu; SIZE=... for other meshes.
set -euo pipefail

size="${SIZE:-0.25}"
name=channel_laminar
if [[ "${1:-}" == --large ]]; then
  size="${SIZE:-0.08}"
  name=channel_laminar_large
  shift
fi
output="${1:-out/cases}"
# shellcheck source=data/cases/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"
prepare

cp -r "$cases_directory/channel/"{0,constant,system,channel.geo} "$work"
cd "$work"
quietly gmsh -3 -format msh2 -setnumber size "$size" channel.geo -o channel.msh
quietly gmshToFoam channel.msh
quietly pimpleFoam
"$triplex" import . -o "$output/$name.vtu"
