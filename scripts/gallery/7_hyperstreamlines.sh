# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Dominant hyperstreamlines with thorns and leaves: three crossings in the Lorenz system, and the one through
# (pi, pi, pi) in the Arnold-Beltrami-Childress flow.

# trace NAME FIELD OPTION...: curves in out/gallery/NAME, the summary in the numbers.
trace() {
  local name=$1 field=$2
  shift 2
  echo "== trace $name"
  {
    echo "== $name"
    echo "triplex trace $(basename -- "$field")" "$@"
    "$triplex" trace "$field" -o "$name" --quiet "$@"
    echo
  } >>"$numbers"
}

# crossing NAME X Y Z: a box around a point of a feature of the Lorenz system, and the curve through that point.
crossing() {
  local box
  box=$(awk -v x="$2" -v y="$3" -v z="$4" 'BEGIN {
    h = 2.5; print x - h, x + h, y - h, y + h, z - h, z + h }')
  # shellcheck disable=SC2086
  "$triplex" generate lorenz -n 6 --box $box -o "$1.vtu"
  extract "$1" "$1.vtu" --tolerance 2e-2r
  trace "$1_trace" "$1.vtu" --seed="$2,$3,$4" --spacing 0.16 --size 0.35 --radius 0.05
}
crossing at_degenerate 4.544 6.156 13.218
crossing at_spine 5 -3.5318792866941009 27.792592592592591  # its closed form at x = 5
crossing at_neutral -2.174 7.542 22.616
draw crossings at_degenerate at_spine at_neutral --columns 3 --size 1400x560 --view -60,20 --opacity 0.4 \
  --features degenerate-linear,degenerate-planar,neutral-real,triple-curve \
  --with 1@at_degenerate_trace/plant.vtp --with 2@at_spine_trace/plant.vtp --with 3@at_neutral_trace/plant.vtp \
  --caption "degenerate surface" --caption "triple degenerate curve" --caption "real neutral surface"

pi=3.141592653589793
trace abc_trace abc.vtu --periodic x,y,z --seed $pi,$pi,$pi --length 20
draw abc_hyperstreamline abc --panel none --panel neutral-real --columns 2 --size 1100x560 --no-nodes \
  --opacity 0.35 --with abc_trace/plant.vtp --caption "dominant hyperstreamline" \
  --caption "with the real neutral surface"
