// SPDX-License-Identifier: BSD-3-Clause
// A quarter of the soil under a square of 2 m: 4 m wide, 3 m deep. Elements of `edge` at the edge of the square.
SetFactory("OpenCASCADE");
If (!Exists(edge))
  edge = 0.1;
EndIf
far = 4;
depth = 3;
Box(1) = {0, -depth, 0, far, depth, far};
Point(101) = {0, 0, 0};
Point(102) = {1, 0, 0};
Point(103) = {1, 0, 1};
Point(104) = {0, 0, 1};
Line(101) = {101, 102};
Line(102) = {102, 103};
Line(103) = {103, 104};
Line(104) = {104, 101};
Curve Loop(101) = {101, 102, 103, 104};
Plane Surface(101) = {101};
BooleanFragments{ Volume{1}; Delete; }{ Surface{101}; Delete; }
small = 1e-6;
Physical Volume("clay") = {1};
Physical Surface("base") = Surface In BoundingBox {-small, -depth - small, -small, far + small, -depth + small, far + small};
wall() = Surface In BoundingBox {far - small, -depth - small, -small, far + small, small, far + small};
wall() += Surface In BoundingBox {-small, -depth - small, far - small, far + small, small, far + small};
Physical Surface("wall") = {wall()};

Field[1] = MathEval;
Field[1].F = Sprintf("%g + 0.3*sqrt((0.5*(x + z + sqrt((x - z)*(x - z))) - 1)^2 + y*y)", edge);
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeMax = 0.8;
