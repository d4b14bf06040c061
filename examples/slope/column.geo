// SPDX-License-Identifier: BSD-3-Clause
// Half of a column of clay, 0.5 m wide and 1 m high, of n squares over its height and each of two triangles; air where it may go.
n = 12;
x[] = {0, 0.5, 0.75};
For j In {0:1}
  For i In {0:2}
    Point(1 + i + 3 * j) = {x[i], j, 0};
  EndFor
EndFor
For j In {0:1}
  For i In {0:1}
    Line(20 + i + 2 * j) = {1 + i + 3 * j, 2 + i + 3 * j};
    Transfinite Line {20 + i + 2 * j} = Round((x[i + 1] - x[i]) * n) + 1;
  EndFor
EndFor
For i In {0:2}
  Line(40 + i) = {1 + i, 4 + i};
  Transfinite Line {40 + i} = n + 1;
EndFor
For i In {0:1}
  Curve Loop(60 + i) = {20 + i, 41 + i, -(22 + i), -(40 + i)};
  Plane Surface(60 + i) = {60 + i};
  Transfinite Surface {60 + i} Alternate;
EndFor
Physical Surface("soil") = {60};
Physical Surface("air") = {61};
Physical Curve("base") = {20, 21};
Physical Curve("middle") = {40};
Physical Curve("top") = {22};
