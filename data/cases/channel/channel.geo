// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An open channel of 6 x 3 x 1 with a round pier, a little off the middle. `size` is the length of edges.
DefineConstant[ size = 0.24 ];
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 6, 3, 1};
Cylinder(2) = {1.5, 1.47, 0, 0, 0, 1, 0.25};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
e = 1e-6;
inlet() = Surface In BoundingBox{-e, -e, -e, e, 3 + e, 1 + e};
outlet() = Surface In BoundingBox{6 - e, -e, -e, 6 + e, 3 + e, 1 + e};
bed() = Surface In BoundingBox{-e, -e, -e, 6 + e, 3 + e, e};
surface() = Surface In BoundingBox{-e, -e, 1 - e, 6 + e, 3 + e, 1 + e};
right() = Surface In BoundingBox{-e, -e, -e, 6 + e, e, 1 + e};
left() = Surface In BoundingBox{-e, 3 - e, -e, 6 + e, 3 + e, 1 + e};
pier() = Surface In BoundingBox{1, 1, -e, 2, 2, 1 + e};
Physical Surface("inlet") = {inlet()};
Physical Surface("outlet") = {outlet()};
Physical Surface("bed") = {bed()};
Physical Surface("surface") = {surface()};
Physical Surface("banks") = {right(), left()};
Physical Surface("pier") = {pier()};
Physical Volume("water") = {3};
// Half as long at the pier and behind it.
Field[1] = Distance;
Field[1].SurfacesList = {pier()};
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].SizeMin = size / 2.5;
Field[2].SizeMax = size;
Field[2].DistMin = 0.1;
Field[2].DistMax = 1.2;
Background Field = 2;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.MshFileVersion = 2.2;
Mesh.RandomSeed = 1;
