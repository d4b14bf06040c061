// SPDX-License-Identifier: BSD-3-Clause
// The square with triangles of about 1 m / n, without order; the file that names n includes this one.
Point(1) = {0, 0, 0, 1/n};  Point(2) = {1, 0, 0, 1/n};
Point(3) = {1, 1, 0, 1/n};  Point(4) = {0, 1, 0, 1/n};
Line(1) = {1, 2};  Line(2) = {2, 3};  Line(3) = {3, 4};  Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Mesh.Algorithm = 6;
Physical Surface("box") = {1};
Physical Curve("bottom") = {1};
Physical Curve("right") = {2};
Physical Curve("top") = {3};
Physical Curve("left") = {4};
