// SPDX-License-Identifier: BSD-3-Clause
// A cut 1 m high with n squares over its height, each of two triangles: soil left of x = 0 up to y = 1, a bed of 0.4 m below, air where the soil may go.
x[] = {-2, 0, 1};
y[] = {-0.4, 0, 1, 1.1};
For j In {0:3}
  For i In {0:2}
    Point(1 + i + 3 * j) = {x[i], y[j], 0};
  EndFor
EndFor
// Horizontal lines 20 + i + 2 j, vertical lines 40 + i + 3 j.
For j In {0:3}
  For i In {0:1}
    Line(20 + i + 2 * j) = {1 + i + 3 * j, 2 + i + 3 * j};
    Transfinite Line {20 + i + 2 * j} = Round((x[i + 1] - x[i]) * n) + 1;
  EndFor
EndFor
For j In {0:2}
  For i In {0:2}
    Line(40 + i + 3 * j) = {1 + i + 3 * j, 4 + i + 3 * j};
    Transfinite Line {40 + i + 3 * j} = Round((y[j + 1] - y[j]) * n) + 1;
  EndFor
EndFor
For j In {0:2}
  For i In {0:1}
    k = i + 2 * j;
    Curve Loop(60 + k) = {20 + k, 41 + i + 3 * j, -(22 + k), -(40 + i + 3 * j)};
    Plane Surface(60 + k) = {60 + k};
    Transfinite Surface {60 + k} Alternate;
  EndFor
EndFor
Physical Surface("soil") = {60, 61, 62};
Physical Surface("air") = {63, 64, 65};
Physical Curve("bottom") = {20, 21};
Physical Curve("left") = {40, 43, 46};
Physical Curve("right") = {42, 45, 48};
