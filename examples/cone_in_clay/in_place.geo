// SPDX-License-Identifier: BSD-3-Clause
// Clay around a cone of 120 degrees and R = 0.5 m, whose shoulder is at the surface y = 0. h: size of the elements along its face.
h = 0.02;
R = 0.5;
z = 0.288675;
Point(1) = {0, -z, 0, h};
Point(2) = {R, 0, 0, h/2};
Point(3) = {2.5, 0, 0, 0.15};
Point(4) = {2.5, -1.8, 0, 0.2};
Point(5) = {0, -1.8, 0, 0.2};
Point(6) = {1.2, 0, 0, 0.05};
Line(1) = {1, 2};
Line(2) = {2, 6};
Line(3) = {6, 3};
Line(4) = {3, 4};
Line(5) = {4, 5};
Line(6) = {5, 1};
Curve Loop(1) = {1:6};
Plane Surface(1) = {1};
Physical Surface("clay") = {1};
Physical Curve("face") = {1};
Physical Curve("surface") = {2, 3};
Physical Curve("right") = {4};
Physical Curve("base") = {5};
Physical Curve("axis") = {6};
