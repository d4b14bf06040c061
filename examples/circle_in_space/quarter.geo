// SPDX-License-Identifier: BSD-3-Clause
// A quarter of a cylinder of soil, 3 m in radius and depth, under a disk of 1 m. Elements of `edge` at the edge of the disk.
SetFactory("OpenCASCADE");
If (!Exists(edge))
  edge = 0.1;
EndIf
far = 3;
Point(1) = {0, 0, 0};
Point(2) = {1, 0, 0};
Point(3) = {far, 0, 0};
Point(4) = {far, -far, 0};
Point(5) = {0, -far, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 1};
Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {1};
Extrude {{0, 1, 0}, {0, 0, 0}, -Pi / 2} { Surface{1}; }
Physical Volume("clay") = {1};
small = 1e-6;
Physical Surface("base") = Surface In BoundingBox {-small, -far - small, -small, far + small, -far + small, far + small};
all() = Surface In BoundingBox {-small, -far - small, -small, far + small, small, far + small};
wall() = {};
For k In {0 : #all() - 1}
  box() = BoundingBox Surface{all(k)};
  If (box(3) > far - small && box(5) > far - small && box(4) - box(1) > far - small)
    wall() += {all(k)};
  EndIf
EndFor
Physical Surface("wall") = {wall()};

// Beside the edge, below the disk, and far away.
Field[1] = MathEval;
Field[1].F = Sprintf("%g + 0.3*sqrt((sqrt(x*x + z*z) - 1)*(sqrt(x*x + z*z) - 1) + y*y)", edge);
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeMax = 0.8;
