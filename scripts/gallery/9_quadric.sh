# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# A magnitude surface in one tet, step by step: an ellipsoid that leaves the tet by all four faces.
one=$root/scripts/gallery/one_tet.vtk
extract one_tet "$one" --features none --magnitude 0.29 --tolerance 2e-4
echo "== quadric one_tet"
{
  echo "== one_tet_steps"
  "$triplex" quadric "$one" --features none --magnitude 0.29 --samples 6 -o one_tet_steps
  echo
} >>"$numbers"
draw quadric one_tet --panel none --panel none --panel none --panel magnitude-0.29 --columns 4 --size 1400x400 \
  --view -42,18 --zoom 1.05 --outline none --no-legend --with 1@one_tet_steps/tet.vtp:black \
  --with 2@one_tet_steps/tet.vtp:black --with 2@one_tet_steps/curves.vtp:navy \
  --with 3@one_tet_steps/parameters.vtp:navy --with 4@one_tet_steps/tet.vtp:black \
  --with 4@one_tet_steps/triangles.vtp:white --thickness 0.9 --caption "a tet" --caption "conics on its faces" \
  --caption "parameter domain" --caption "surface"
