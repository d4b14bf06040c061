// SPDX-License-Identifier: BSD-3-Clause
// Three layers, a metre each; squares of 0.25 m halved.
For k In {0:3}
  Point(2 * k + 1) = {0, -k, 0};
  Point(2 * k + 2) = {4, -k, 0};
  Line(k + 1) = {2 * k + 1, 2 * k + 2};
EndFor
For k In {0:2}
  Line(10 + k) = {2 * k + 1, 2 * k + 3};
  Line(20 + k) = {2 * k + 2, 2 * k + 4};
  Curve Loop(k + 1) = {10 + k, k + 2, -(20 + k), -(k + 1)};
  Plane Surface(k + 1) = {k + 1};
EndFor
Transfinite Curve {1:4} = 17;
Transfinite Curve {10:12, 20:22} = 5;
Transfinite Surface {1:3};
Physical Surface("top") = {1};
Physical Surface("middle") = {2};
Physical Surface("lower") = {3};
Physical Curve("left") = {10:12};
Physical Curve("right") = {20:22};
Physical Curve("bottom") = {4};
