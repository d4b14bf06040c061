// SPDX-License-Identifier: BSD-3-Clause
// Cells of 0.1 m: a base of 10 m by 0.2 m, the column of 1 m by 2 m on its left end, air beside and above it. All squares are cut along the same diagonal.
X[] = {0, 1, 10};
Y[] = {0, 0.2, 2.2, 2.3};
across[] = {10, 90};
up[] = {2, 20, 1};
For j In {0:3}
  For i In {0:2}
    Point(1 + i + 3*j) = {X[i], Y[j], 0};
  EndFor
EndFor
For j In {0:3}
  For i In {0:1}
    Line(100 + i + 2*j) = {1 + i + 3*j, 2 + i + 3*j};
    Transfinite Line{100 + i + 2*j} = across[i] + 1;
  EndFor
EndFor
For j In {0:2}
  For i In {0:2}
    Line(200 + i + 3*j) = {1 + i + 3*j, 4 + i + 3*j};
    Transfinite Line{200 + i + 3*j} = up[j] + 1;
  EndFor
EndFor
For j In {0:2}
  For i In {0:1}
    Curve Loop(300 + i + 2*j) = {100 + i + 2*j, 201 + i + 3*j, -(102 + i + 2*j), -(200 + i + 3*j)};
    Plane Surface(300 + i + 2*j) = {300 + i + 2*j};
    Transfinite Surface{300 + i + 2*j} Left;
  EndFor
EndFor
Physical Surface("base") = {300, 301};
Physical Surface("column") = {302};
Physical Surface("air") = {303, 304, 305};
Physical Curve("bottom") = {100, 101};
Physical Curve("top") = {106, 107};
Physical Curve("left") = {200, 203, 206};
Physical Curve("gate") = {204};
Physical Curve("right") = {202, 205, 208};
