// SPDX-License-Identifier: BSD-3-Clause
// Half of a layer around a sheet pile, which is at x = 0 from the surface down to the toe; below it the plane x = 0 is a gate with half of the head. Metres.
depth = 1;
toe = 0.5;
length = 3;
air = 0.1;
If(!Exists(size))
  size = 0.03;
EndIf
Point(1) = {0, -depth, 0, 2 * size};
Point(2) = {length, -depth, 0, 5 * size};
Point(3) = {length, 0, 0, 5 * size};
Point(4) = {0, 0, 0, 1.3 * size};
Point(5) = {0, -toe, 0, size};
Point(6) = {length, air, 0, 5 * size};
Point(7) = {0, air, 0, 1.3 * size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {4, 3};
Line(4) = {5, 4};
Line(5) = {1, 5};
Line(6) = {3, 6};
Line(7) = {7, 6};
Line(8) = {4, 7};
Curve Loop(1) = {1, 2, -3, -4, -5};
Plane Surface(1) = {1};
Curve Loop(2) = {3, 6, -7, -8};
Plane Surface(2) = {2};
Physical Surface("soil") = {1};
Physical Surface("air") = {2};
Physical Curve("sheet") = {4};
Physical Curve("gate") = {5};
Physical Curve("bottom") = {1};
Physical Curve("right") = {2};
