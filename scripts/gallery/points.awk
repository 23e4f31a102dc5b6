# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# A point of a .vtp file for each line "x y z" of the input.
NF >= 3 { place[points++] = $1 " " $2 " " $3 }
END {
  print "<?xml version=\"1.0\"?>"
  print "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\"><PolyData>"
  printf "<Piece NumberOfPoints=\"%d\" NumberOfVerts=\"%d\" NumberOfLines=\"0\" ", points, points
  print "NumberOfStrips=\"0\" NumberOfPolys=\"0\">"
  print "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">"
  for (p = 0; p < points; p++) print place[p]
  print "</DataArray></Points><Verts><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">"
  for (p = 0; p < points; p++) print p
  print "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">"
  for (p = 1; p <= points; p++) print p
  print "</DataArray></Verts></Piece></PolyData></VTKFile>"
}
