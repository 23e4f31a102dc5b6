# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Rayleigh-Benard convection: all features, a close-up at the plane between the cells, and the symmetric part.
extract convection "$root/data/rayleigh_benard.vtu" --tensor tensor
extract convection_symmetric "$root/data/rayleigh_benard.vtu" --tensor tensor --symmetric \
  --features degenerate-linear,degenerate-planar
draw convection convection --sheet --columns 2 --size 800x540 --view -70,25 --opacity 0.85 --no-nodes
draw convection_near convection --clip 1,1.3,0.35,0.65,0.35,0.65 --size 1300x620 --view -60,20 --no-nodes \
  --opacity 0.9 --opacity neutral-complex=0.45 --silhouettes \
  --panel degenerate-linear,degenerate-planar,neutral-real,neutral-complex,balanced-linear,balanced-planar,triple-curve \
  --panel triple-curve --caption "mode surfaces" --caption "triple degenerate curve"
draw symmetric convection_symmetric convection --size 1000x420 --view -70,25 --opacity 0.85 --no-nodes --columns 2 \
  --panel degenerate-linear,degenerate-planar,triple-curve \
  --caption "symmetric part" --caption "velocity gradient"
