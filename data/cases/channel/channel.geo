// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A channel [0,6] x [0,3] x [0,1] with an upright cylinder, in tets. size: length of edges far from the cylinder.
SetFactory("OpenCASCADE");
DefineConstant[ size = {0.25, Name "size"} ];
Box(1) = {0, 0, 0, 6, 3, 1};
Cylinder(2) = {1.5, 1.47, 0, 0, 0, 1, 0.25};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
e = 1e-3;
Physical Surface("inlet") = Surface In BoundingBox{-e, -e, -e, e, 3 + e, 1 + e};
Physical Surface("outlet") = Surface In BoundingBox{6 - e, -e, -e, 6 + e, 3 + e, 1 + e};
Physical Surface("sides") = { Surface In BoundingBox{-e, -e, -e, 6 + e, e, 1 + e},
                              Surface In BoundingBox{-e, 3 - e, -e, 6 + e, 3 + e, 1 + e} };
Physical Surface("bed") = Surface In BoundingBox{-e, -e, -e, 6 + e, 3 + e, e};
Physical Surface("top") = Surface In BoundingBox{-e, -e, 1 - e, 6 + e, 3 + e, 1 + e};
cylinder[] = Surface In BoundingBox{1.2, 1.2, -e, 1.8, 1.8, 1 + e};
Physical Surface("obstacle") = cylinder[];
Physical Volume("water") = Volume{:};
Field[1] = Distance;
Field[1].SurfacesList = {cylinder[]};
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].SizeMin = 0.4 * size;
Field[2].SizeMax = size;
Field[2].DistMin = 0.1;
Field[2].DistMax = 1;
Background Field = 2;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.RandomSeed = 1;
