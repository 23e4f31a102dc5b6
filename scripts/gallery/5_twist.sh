# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The twisted block: the deformation, degenerate features of both stresses, isotropicity and magnitude surfaces.
for load in 030 100; do
  field=$root/data/twist_$load.vtu
  extract "cauchy_$load" "$field" --tensor cauchy --features degenerate-linear,degenerate-planar
  extract "pk1_$load" "$field" --tensor tensor --features degenerate-linear,degenerate-planar,triple-curve
done
extract twist_levels "$root/data/twist_100.vtu" --tensor tensor --features none --traceless \
  --isotropicity 0.7 --isotropicity -0.7 --isotropicity 0.5 --isotropicity -0.5 \
  --magnitude 10 --magnitude 20 --magnitude 30
draw twist_levels twist_levels --columns 6 --size 1600x520 --view -60,20 --opacity 0.8 --silhouettes \
  --panel isotropicity-0.7,isotropicity-neg-0.7 --panel isotropicity-0.5,isotropicity-neg-0.5 \
  --panel traceless --panel magnitude-10 --panel magnitude-20 --panel magnitude-30 \
  --caption "0.7, -0.7" --caption "0.5, -0.5" --caption "0" --caption "|T| = 10" --caption "|T| = 20" \
  --caption "|T| = 30"
