# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Trajectories of the Lorenz system and of the Arnold-Beltrami-Childress flow, for pictures: one from each line "x y z" of
# the input, by the classical Runge-Kutta method with a fixed step (no control of errors), as lines of a .vtp file.
#   awk -v flow=lorenz|abc -v step=0.005 -v steps=8000 -f streamline.awk seeds > lines.vtp
# abc: what leaves the box [0, 2 pi]^3 goes on at the opposite side; the line is cut there.
BEGIN { pi = atan2(0, -1); A = 1; B = sqrt(2 / 3); C = sqrt(1 / 3); points = 0; lines = 0; open = 0 }

function velocity(x, y, z) {
  if (flow == "lorenz") {
    u = 10 * (y - x); v = x * (28 - z) - y; w = x * y - 8 / 3 * z
  } else {
    u = A * sin(z) + C * cos(y); v = B * sin(x) + A * cos(z); w = C * sin(y) + B * cos(x)
  }
}

function add_point(x, y, z) {
  place[points] = sprintf("%.7g %.7g %.7g", x, y, z)
  if (!open) { first[lines] = points; open = 1 }
  points++
}

function end_line() {
  if (!open) return
  last[lines] = points
  lines++
  open = 0
}

# x in [0, 2 pi), after cutting the line if it was not.
function wrapped(x) {
  if (x >= 0 && x < 2 * pi) return x
  end_line()
  return x < 0 ? x + 2 * pi : x - 2 * pi
}

NF >= 3 {
  x = $1 + 0; y = $2 + 0; z = $3 + 0
  add_point(x, y, z)
  for (k = 0; k < steps; k++) {
    velocity(x, y, z); u1 = u; v1 = v; w1 = w
    velocity(x + step / 2 * u1, y + step / 2 * v1, z + step / 2 * w1); u2 = u; v2 = v; w2 = w
    velocity(x + step / 2 * u2, y + step / 2 * v2, z + step / 2 * w2); u3 = u; v3 = v; w3 = w
    velocity(x + step * u3, y + step * v3, z + step * w3)
    x += step / 6 * (u1 + 2 * u2 + 2 * u3 + u)
    y += step / 6 * (v1 + 2 * v2 + 2 * v3 + v)
    z += step / 6 * (w1 + 2 * w2 + 2 * w3 + w)
    if (flow == "abc") { x = wrapped(x); y = wrapped(y); z = wrapped(z) }
    add_point(x, y, z)
  }
  end_line()
}

END {
  print "<?xml version=\"1.0\"?>"
  print "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\"><PolyData>"
  printf "<Piece NumberOfPoints=\"%d\" NumberOfVerts=\"0\" NumberOfLines=\"%d\" ", points, lines
  print "NumberOfStrips=\"0\" NumberOfPolys=\"0\">"
  print "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">"
  for (p = 0; p < points; p++) print place[p]
  print "</DataArray></Points>"
  print "<Lines><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">"
  for (l = 0; l < lines; l++) for (p = first[l]; p < last[l]; p++) print p
  print "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">"
  sum = 0
  for (l = 0; l < lines; l++) { sum += last[l] - first[l]; print sum }
  print "</DataArray></Lines></Piece></PolyData></VTKFile>"
}
