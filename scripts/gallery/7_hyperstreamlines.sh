# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Dominant hyperstreamlines with thorns and leaves: crossings in the Lorenz system, and through (pi, pi, pi) in the
# Arnold-Beltrami-Childress flow.

# trace NAME FIELD OPTION...: curves in out/gallery/NAME, the summary in the numbers.
trace() {
  local name=$1 field=$2
  shift 2
  { echo "== $name"; echo "triplex trace $(basename -- "$field")" "$@"; } >>"$numbers"
  "$triplex" trace "$field" -o "$name" --quiet "$@" >>"$numbers"
  echo >>"$numbers"
}

pi=3.141592653589793
trace abc_trace abc.vtu --periodic x,y,z --seed $pi,$pi,$pi --length 25
printf '%s\n' "$pi $pi $pi" | awk -f "$root/scripts/gallery/points.awk" >seed.vtp
draw abc_hyperstreamline abc --panel none --panel neutral-real --columns 2 --size 1300x640 --no-nodes \
  --opacity 0.35 --with abc_trace/plant.vtp --with seed.vtp:red --caption "dominant hyperstreamline" \
  --caption "with the real neutral surface"
