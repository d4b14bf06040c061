// SPDX-License-Identifier: BSD-3-Clause
// One row of cells from the radius 1 m to 400 m, which grow with it, and a free cell beyond.
h = 0.1;
x[] = {1, 400, 420};
For i In {0:2}
  Point(1 + i) = {x[i], 0, 0};
  Point(11 + i) = {x[i], h, 0};
  Line(1 + i) = {1 + i, 11 + i};
  Transfinite Curve {1 + i} = 2;
EndFor
For i In {0:1}
  Line(11 + i) = {1 + i, 2 + i};
  Line(21 + i) = {11 + i, 12 + i};
  Curve Loop(1 + i) = {11 + i, 2 + i, -(21 + i), -(1 + i)};
  Plane Surface(1 + i) = {1 + i};
EndFor
Transfinite Curve {11, 21} = 178 Using Progression 1.03;
Transfinite Curve {12, 22} = 2;
Transfinite Surface {1, 2} Alternate;
Physical Surface("sand") = {1};
Physical Surface("free") = {2};
Physical Curve("base") = {11, 12};
Physical Curve("top") = {21, 22};
Physical Curve("outer") = {2};
