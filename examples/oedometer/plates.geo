// SPDX-License-Identifier: BSD-3-Clause
// Soil of 0.5 m x 1 m in two halves, between two bands of free space; n cells along 0.5 m; drawn out to a
// depth where there is one. The file that names n includes this one.
h = 0.5/n;
front[] = {};  volume[] = {};  right[] = {};  left[] = {};
y[] = {-h, 0, 0.5, 1, 1 + h};
rows[] = {1, n, n, 1};
For k In {0:4}
  Point(2*k + 1) = {0, y[k], 0};
  Point(2*k + 2) = {0.5, y[k], 0};
  Line(k + 1) = {2*k + 1, 2*k + 2};
  Transfinite Curve {k + 1} = n + 1;
EndFor
For k In {0:3}
  Line(11 + k) = {2*k + 1, 2*k + 3};
  Line(21 + k) = {2*k + 2, 2*k + 4};
  Transfinite Curve {11 + k, 21 + k} = rows[k] + 1;
  Curve Loop(k + 1) = {k + 1, 21 + k, -(k + 2), -(11 + k)};
  Plane Surface(k + 1) = {k + 1};
  Transfinite Surface {k + 1} Alternate;
EndFor
If (Exists(depth))
  For k In {1:4}
    drawn[] = Extrude {0, 0, depth} { Surface{k}; Layers{Round(depth/h)}; };
    front[] += drawn[0];
    volume[] += drawn[1];
    right[] += drawn[3];
    left[] += drawn[5];
  EndFor
  Coherence;
  Physical Volume("lower") = {volume[1]};
  Physical Volume("upper") = {volume[2]};
  Physical Volume("space") = {volume[0], volume[3]};
  Physical Surface("back") = {1:4};
  Physical Surface("front") = {front[]};
  Physical Surface("right") = {right[]};
  Physical Surface("left") = {left[]};
Else
  Physical Surface("lower") = {2};
  Physical Surface("upper") = {3};
  Physical Surface("space") = {1, 4};
  Physical Curve("left") = {11:14};
  Physical Curve("right") = {21:24};
EndIf
