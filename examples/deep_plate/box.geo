// SPDX-License-Identifier: BSD-3-Clause
// Half of a section through a round box, 3 m by 6 m, with a plate of 1 m in its middle: n cells to a metre within 40 mm of the plate on its way, larger with the distance from
// there. The file that names n includes this one.
Point(1) = {0, -3, 0};
Point(2) = {3, -3, 0};
Point(3) = {3, 3, 0};
Point(4) = {0, 3, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1:4};
Plane Surface(1) = {1};
Field[1] = MathEval;
Field[1].F = Sprintf("%g + 0.15*max(0, sqrt(max(0, x - 0.5)^2 + max(0, Abs(y + 0.025) - 0.025)^2) - 0.04)", 1/n);
Background Field = 1;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeExtendFromBoundary = 0;
Physical Surface("clay") = {1};
Physical Curve("axis") = {4};
Physical Curve("right") = {2};
Physical Curve("bottom") = {1};
Physical Curve("top") = {3};
