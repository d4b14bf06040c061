// SPDX-License-Identifier: BSD-3-Clause
// A quarter of a ring from r = 1 to 10, n cells along 90 deg, as long as wide; within it, from 0.9 to 1, space for the wall to move. The file
// that names n includes this one.
growth = 1 + Pi/(2*n);
rows = Round(Log(10)/Log(growth));
Point(1) = {0, 0, 0};
Point(2) = {0.9, 0, 0};  Point(3) = {0, 0.9, 0};
Point(4) = {1, 0, 0};    Point(5) = {0, 1, 0};
Point(6) = {10, 0, 0};   Point(7) = {0, 10, 0};
Circle(1) = {2, 1, 3};  Circle(2) = {4, 1, 5};  Circle(3) = {6, 1, 7};
Line(4) = {2, 4};  Line(5) = {4, 6};
Line(6) = {3, 5};  Line(7) = {5, 7};
Curve Loop(1) = {4, 2, -6, -1};  Plane Surface(1) = {1};
Curve Loop(2) = {5, 3, -7, -2};  Plane Surface(2) = {2};
Transfinite Curve {1, 2, 3} = n + 1;
Transfinite Curve {4, 6} = Ceil(0.2*n/Pi) + 1;
Transfinite Curve {5, 7} = rows + 1 Using Progression 10^(1/rows);
Transfinite Surface {1, 2} Alternate;
Physical Surface("space") = {1};
Physical Surface("rock") = {2};
Physical Curve("floor") = {4, 5};
Physical Curve("axis") = {6, 7};
Physical Curve("far") = {3};
