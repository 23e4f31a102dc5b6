# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The eigenvalue space, and three fields in it.
on_display plot-space -o "$pictures/space.png" --size 1000x500
on_display plot-space "$root/data/rayleigh_benard.vtu" --tensor tensor --size 1000x500 \
  -o "$pictures/space_convection.png" --json space_convection.json
on_display plot-space "$root/data/twist_100.vtu" --tensor tensor --size 1000x500 \
  -o "$pictures/space_twist.png" --json space_twist.json
