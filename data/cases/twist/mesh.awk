# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Writes the CalculiX input of a twisted box: [-0.5,0.5]^2 x [0,length], nx x nx x nz hexahedra.
# Variables: nx, nz, length_z, degrees (a list: one step each), type (C3D8),
# release (1: the back face may move along z, as a plane).

function node(i, j, k) { return 1 + i + (nx + 1) * (j + (nx + 1) * k) }

function nodes_and_elements(   i, j, k, e) {
  print "*NODE, NSET=ALL"
  for (k = 0; k <= nz; ++k) for (j = 0; j <= nx; ++j) for (i = 0; i <= nx; ++i)
    printf "%d, %.12g, %.12g, %.12g\n", node(i, j, k), i / nx - 0.5, j / nx - 0.5, length_z * k / nz
  print "*ELEMENT, TYPE=" type ", ELSET=BODY"
  for (k = 0; k < nz; ++k) for (j = 0; j < nx; ++j) for (i = 0; i < nx; ++i)
    printf "%d, %d, %d, %d, %d, %d, %d, %d, %d\n", ++e, node(i, j, k), node(i + 1, j, k),
      node(i + 1, j + 1, k), node(i, j + 1, k), node(i, j, k + 1), node(i + 1, j, k + 1),
      node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)
  print "*NSET, NSET=FRONT, GENERATE"
  printf "1, %d, 1\n", node(nx, nx, 0)
  print "*NSET, NSET=BACK, GENERATE"
  printf "%d, %d, 1\n", node(0, 0, nz), node(nx, nx, nz)
}

# The back face as a plane: all of its nodes have the third displacement of the first.
function plane(   i, j) {
  for (j = 0; j <= nx; ++j) for (i = 0; i <= nx; ++i) if (i + j > 0)
    printf "*EQUATION\n2\n%d, 3, 1., %d, 3, -1.\n", node(i, j, nz), node(0, 0, nz)
}

# A rotation of the back face about z, as displacements.
function rotate(angle,   i, j, x, y, c, s) {
  c = cos(angle); s = sin(angle)
  print "*BOUNDARY"
  for (j = 0; j <= nx; ++j) for (i = 0; i <= nx; ++i) {
    x = i / nx - 0.5; y = j / nx - 0.5
    printf "%d, 1, 1, %.12e\n", node(i, j, nz), c * x - s * y - x
    printf "%d, 2, 2, %.12e\n", node(i, j, nz), s * x + c * y - y
  }
  if (!release) print "BACK, 3, 3"
}

BEGIN {
  pi = atan2(0, -1)
  nodes_and_elements()
  if (release) plane()
  print "*MATERIAL, NAME=RUBBER\n*HYPERELASTIC, NEO HOOKE\n200., 0.002"
  print "*SOLID SECTION, ELSET=BODY, MATERIAL=RUBBER"
  print "*BOUNDARY\nFRONT, 1, 3"
  steps = split(degrees, angles, " ")
  for (n = 1; n <= steps; ++n) {
    print "*STEP, NLGEOM, INC=200\n*STATIC\n0.25, 1., 1e-4, 0.25"
    rotate(angles[n] * pi / 180)
    print "*NODE FILE, FREQUENCY=1000\nU\n*EL FILE, FREQUENCY=1000\nS\n*END STEP"
  }
}
