# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Vortex core lines of the Arnold-Beltrami-Childress flow against balanced and complex neutral surfaces; streamlines of the
# convection.
trace abc_cores abc.vtu --follow none --vortex-cores velocity
trace abc_cores_all abc.vtu --follow none --vortex-cores velocity --unfiltered
draw abc_cores abc --panel balanced-linear,balanced-planar --panel neutral-complex \
  --panel balanced-linear,balanced-planar --columns 3 --size 1000x410 --opacity 0.45 --thickness 1.5 \
  --with 1@abc_cores/vortex-cores.vtp:goldenrod --with 2@abc_cores/vortex-cores.vtp:goldenrod \
  --with 3@abc_cores_all/vortex-cores.vtp:goldenrod --caption "VTK's cores, balanced" \
  --caption "VTK's cores, complex neutral" --caption "unfiltered cores, balanced"

trace convection_flow "$root/data/rayleigh_benard.vtu" --tensor tensor --follow none --streamlines velocity \
  --seed-grid 4,2,2
draw convection_flow convection --panel none --panel triple-curve --columns 2 --size 1000x370 --view -70,25 \
  --with convection_flow/streamlines.vtp:steelblue --thickness 1.2 --caption "streamlines" \
  --caption "with the triple degenerate curve"
