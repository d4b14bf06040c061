// SPDX-License-Identifier: BSD-3-Clause
// A wedge of soil from x = 1 m to 15 m, y = 0 to slope x, in n rows of cells; along x they grow with the radius. Beyond it a column of free cells, for the
// soil that the cavity pushes outwards. The file that names n includes this one.
slope = Tan(0.2);
growth = 1 + 0.2/n;
columns = Round(Log(15)/Log(growth));
x[] = {1, 15, 16};
For i In {0:2}
  Point(1 + i) = {x[i], 0, 0};
  Point(11 + i) = {x[i], slope*x[i], 0};
  Line(1 + i) = {1 + i, 11 + i};
  Transfinite Curve {1 + i} = n + 1;
EndFor
For i In {0:1}
  Line(11 + i) = {1 + i, 2 + i};
  Line(21 + i) = {11 + i, 12 + i};
  Curve Loop(1 + i) = {11 + i, 2 + i, -(21 + i), -(1 + i)};
  Plane Surface(1 + i) = {1 + i};
EndFor
Transfinite Curve {11, 21} = columns + 1 Using Progression Exp(Log(15)/columns);
Transfinite Curve {12, 22} = 2;
Transfinite Surface {1, 2} Alternate;
Physical Surface("clay") = {1};
Physical Surface("free") = {2};
Physical Curve("axis") = {11, 12};
Physical Curve("outer") = {2};
