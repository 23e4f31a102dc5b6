# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The Arnold-Beltrami-Childress flow: all features; streamlines inside and outside principal vortices with the spine.
"$triplex" generate abc -n 20 --velocity -o abc.vtu
extract abc abc.vtu --periodic x,y,z
draw abc abc --sheet --columns 4 --size 1050x380 --opacity 0.75
flow() { awk -v flow=abc -v step=0.02 -v steps="$1" -f "$root/scripts/gallery/streamline.awk"; }
# On the axes of the six principal vortices, where two terms of a component of the velocity are largest.
printf '%s\n' "0.2 0 1.5708" "0.2 3.1416 4.7124" "1.5708 0.2 0" "4.7124 0.2 3.1416" "0 1.5708 0.2" \
  "3.1416 4.7124 0.2" | flow 1500 >ordered.vtp
printf '%s\n' "0.5 4.2 3.3" | flow 12000 >chaotic.vtp
draw abc_vortices abc --panel none --panel triple-curve --panel triple-curve --columns 3 --size 900x390 \
  --with 1@ordered.vtp:steelblue --with 1@chaotic.vtp:#c0c0c0 --with 2@ordered.vtp:steelblue \
  --with 3@chaotic.vtp:#b0b0b0 --thickness 1.4 --caption "streamlines" \
  --caption "principal vortices, spine" --caption "a chaotic streamline, spine"
