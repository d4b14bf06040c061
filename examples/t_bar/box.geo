// SPDX-License-Identifier: BSD-3-Clause
// Half of a box, 4 m by 8 m: n cells to a metre along the bar's path, 1.25 m by 3.5 m, longer by growth from one to the next towards the walls. The file that
// names n includes this one.
growth = 1.15;
rows = Round(Log(1 + 2.5*n*(growth - 1))/Log(growth));
x[] = {0, 1.25, 4};
y[] = {-4, -1.75, 1.75, 4};
For j In {0:3}
  For i In {0:2}
    Point(1 + i + 3*j) = {x[i], y[j], 0};
  EndFor
EndFor
For j In {0:3}
  Line(1 + j) = {1 + 3*j, 2 + 3*j};
  Line(11 + j) = {2 + 3*j, 3 + 3*j};
  Transfinite Curve {1 + j} = Round(1.25*n) + 1;
  Transfinite Curve {11 + j} = rows + 1 Using Progression growth;
EndFor
For i In {0:2}
  For j In {0:2}
    Line(21 + i + 3*j) = {1 + i + 3*j, 4 + i + 3*j};
  EndFor
  Transfinite Curve {21 + i} = rows + 1 Using Progression 1/growth;
  Transfinite Curve {24 + i} = Round(3.5*n) + 1;
  Transfinite Curve {27 + i} = rows + 1 Using Progression growth;
EndFor
For j In {0:2}
  Curve Loop(1 + j) = {1 + j, 22 + 3*j, -(2 + j), -(21 + 3*j)};
  Plane Surface(1 + j) = {1 + j};
  Curve Loop(11 + j) = {11 + j, 23 + 3*j, -(12 + j), -(22 + 3*j)};
  Plane Surface(11 + j) = {11 + j};
  Transfinite Surface {1 + j, 11 + j} Alternate;
EndFor
Physical Surface("clay") = {1:3, 11:13};
Physical Curve("axis") = {21, 24, 27};
Physical Curve("right") = {23, 26, 29};
Physical Curve("bottom") = {1, 11};
Physical Curve("top") = {4, 14};
