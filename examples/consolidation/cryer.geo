// SPDX-License-Identifier: BSD-3-Clause
// A quarter of a disc of 1 m around the origin, which turns into a sphere.
size = 0.05;
Point(1) = {0, 0, 0, size};
Point(2) = {1, 0, 0, size};
Point(3) = {0, 1, 0, size};
Line(1) = {1, 2};
Circle(2) = {2, 1, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
Physical Surface("clay") = {1};
Physical Curve("equator") = {1};
Physical Curve("surface") = {2};
