// SPDX-License-Identifier: BSD-3-Clause
// Soil of 0.5 m x 1 m between two bands of free space; n cells along 0.5 m. The file that names n includes this one.
Point(1) = {0, -1/(2*n), 0};       Point(2) = {0.5, -1/(2*n), 0};
Point(3) = {0, 0, 0};              Point(4) = {0.5, 0, 0};
Point(5) = {0, 1, 0};              Point(6) = {0.5, 1, 0};
Point(7) = {0, 1 + 1/(2*n), 0};    Point(8) = {0.5, 1 + 1/(2*n), 0};
Line(1) = {1, 2};  Line(2) = {3, 4};  Line(3) = {5, 6};  Line(4) = {7, 8};
Line(5) = {1, 3};  Line(6) = {3, 5};  Line(7) = {5, 7};
Line(8) = {2, 4};  Line(9) = {4, 6};  Line(10) = {6, 8};
Curve Loop(1) = {1, 8, -2, -5};   Plane Surface(1) = {1};
Curve Loop(2) = {2, 9, -3, -6};   Plane Surface(2) = {2};
Curve Loop(3) = {3, 10, -4, -7};  Plane Surface(3) = {3};
Transfinite Curve {1, 2, 3, 4} = n + 1;
Transfinite Curve {6, 9} = 2*n + 1;
Transfinite Curve {5, 7, 8, 10} = 2;
Transfinite Surface {1, 2, 3} Alternate;
Physical Surface("soil") = {2};
Physical Surface("space") = {1, 3};
Physical Curve("left") = {5, 6, 7};
Physical Curve("right") = {8, 9, 10};
