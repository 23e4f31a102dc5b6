# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The Lorenz system: all features with a trajectory and the critical points, and the node.
"$triplex" generate lorenz -n 10 -o lorenz.vtu
extract lorenz lorenz.vtu --tolerance 2e-2r
echo "-13.76 -19.58 27" |
  awk -v flow=lorenz -v step=0.01 -v steps=4500 -f "$root/scripts/gallery/streamline.awk" >attractor.vtp
printf '8.485281374 8.485281374 27\n-8.485281374 -8.485281374 27\n' |
  awk -f "$root/scripts/gallery/points.awk" >critical.vtp
draw lorenz lorenz --sheet --columns 4 --size 1400x450 --view -60,18 --opacity 0.7 --silhouettes \
  --with 1@attractor.vtp:#606060 --with critical.vtp:gold

"$triplex" generate lorenz -n 10 --box -3 3 -3 3 26 32 -o lorenz_node.vtu
extract lorenz_node lorenz_node.vtu --tolerance 1e-2r
draw lorenz_node lorenz_node --size 1300x560 --opacity 0.75 --view -70,12 \
  --panel degenerate-planar --panel degenerate-planar,neutral-real,balanced-planar \
  --caption "planar degenerate surface" --caption "with real neutral, planar balanced"
