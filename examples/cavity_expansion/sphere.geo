// SPDX-License-Identifier: BSD-3-Clause
// A quarter of a ring around the origin, from the radius 1 m to 15 m; the cells grow with it. Free cells beyond, for the soil that the cavity pushes outwards.
rows = 8;
radii[] = {1, 15, 16};
columns[] = {40, 2};
Point(1) = {0, 0, 0};
For i In {0:2}
  Point(11 + i) = {radii[i], 0, 0};
  Point(21 + i) = {0, radii[i], 0};
  Circle(1 + i) = {11 + i, 1, 21 + i};
  Transfinite Curve {1 + i} = rows + 1;
EndFor
For i In {0:1}
  Line(11 + i) = {11 + i, 12 + i};
  Line(21 + i) = {21 + i, 22 + i};
  Transfinite Curve {11 + i, 21 + i} = columns[i] + 1 Using Progression Exp(Log(radii[i + 1]/radii[i])/columns[i]);
  Curve Loop(1 + i) = {11 + i, 2 + i, -(21 + i), -(1 + i)};
  Plane Surface(1 + i) = {1 + i};
EndFor
Transfinite Surface {1, 2} Alternate;
Physical Surface("clay") = {1};
Physical Surface("free") = {2};
Physical Curve("equator") = {11, 12};
Physical Curve("wall") = {1};
