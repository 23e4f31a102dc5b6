# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The twisted block: the deformation, degenerate features of both stresses, isotropicity and magnitude surfaces.
for load in 030 100; do
  field=$root/data/twist_$load.vtu
  extract "cauchy_$load" "$field" --tensor cauchy --features degenerate-linear,degenerate-planar
  extract "pk1_$load" "$field" --tensor tensor --domains
done
extract twist_levels "$root/data/twist_100.vtu" --tensor tensor --features none --traceless \
  --isotropicity 0.7 --isotropicity -0.7 --isotropicity 0.5 --isotropicity -0.5 \
  --magnitude 10 --magnitude 20 --magnitude 30
draw twist_levels twist_levels --columns 6 --size 1400x460 --view -60,20 --opacity 0.8 --silhouettes \
  --panel isotropicity-0.7,isotropicity-neg-0.7 --panel isotropicity-0.5,isotropicity-neg-0.5 \
  --panel traceless --panel magnitude-10 --panel magnitude-20 --panel magnitude-30 \
  --caption "0.7, -0.7" --caption "0.5, -0.5" --caption "0" --caption "|T| = 10" --caption "|T| = 20" \
  --caption "|T| = 30"
draw twist_deformation pk1_030 pk1_100 --panel none --no-legend --size 800x560 --view -60,20 --columns 2 --silhouettes \
  --displace displacement --with "1@$root/data/twist_030.vtu:tan" --with "2@$root/data/twist_100.vtu:tan" \
  --caption "30 % of the load" --caption "100 % of the load"
features=(--features degenerate-linear,degenerate-planar,triple-curve)
draw twist cauchy_030 pk1_030 cauchy_100 pk1_100 "${features[@]}" --columns 4 --size 1500x600 --view -60,20 --no-nodes \
  --thickness 1.2 --caption "Cauchy, 30 %" --caption "PK1, 30 %" --caption "Cauchy, 100 %" \
  --caption "PK1, 100 %"
draw twist_near pk1_030 pk1_100 "${features[@]}" --clip -0.02,0.02,-0.02,0.02,1.6,1.66 --columns 2 --size 1100x620 --no-nodes \
  --opacity 0.8 --silhouettes --caption "PK1, 30 %" --caption "PK1, 100 %"
