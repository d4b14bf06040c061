// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/read_case_wrong_inputs_test.cpp
#include "bodies/rigid_settings.hpp"

#include <algorithm>

namespace berm::bodies {
namespace {

/// Twice the area of the triangle of the corners a, b and c, positive where they go round counter-clockwise.
Real twice_area(const PolygonSettings& p, std::size_t a, std::size_t b, std::size_t c)
{
  return (p.x[b] - p.x[a]) * (p.y[c] - p.y[a]) - (p.y[b] - p.y[a]) * (p.x[c] - p.x[a]);
}

/// Whether corner c, in line with a and b, lies between them.
bool between(const PolygonSettings& p, std::size_t a, std::size_t b, std::size_t c)
{
  return std::min(p.x[a], p.x[b]) <= p.x[c] && p.x[c] <= std::max(p.x[a], p.x[b]) && std::min(p.y[a], p.y[b]) <= p.y[c] &&
         p.y[c] <= std::max(p.y[a], p.y[b]);
}

/// Whether the lines from a to b and from c to d have a point in common.
bool meet(const PolygonSettings& p, std::size_t a, std::size_t b, std::size_t c, std::size_t d)
{
  const Real of_c = twice_area(p, a, b, c), of_d = twice_area(p, a, b, d), of_a = twice_area(p, c, d, a), of_b = twice_area(p, c, d, b);
  if (((of_c > 0 && of_d < 0) || (of_c < 0 && of_d > 0)) && ((of_a > 0 && of_b < 0) || (of_a < 0 && of_b > 0))) return true;
  return (of_c == 0 && between(p, a, b, c)) || (of_d == 0 && between(p, a, b, d)) || (of_a == 0 && between(p, c, d, a)) ||
         (of_b == 0 && between(p, c, d, b));
}

}  // namespace

bool is_simple(const PolygonSettings& p)
{
  const std::size_t n = p.x.size();
  if (n < 3 || p.y.size() != n) return false;
  for (std::size_t a = 0; a < n; ++a) {
    const std::size_t b = (a + 1) % n, c = (a + 2) % n;
    if (p.x[a] == p.x[b] && p.y[a] == p.y[b]) return false;
    // A side may go straight on after a corner, but not back.
    if (twice_area(p, a, b, c) == 0 && (p.x[b] - p.x[a]) * (p.x[c] - p.x[b]) + (p.y[b] - p.y[a]) * (p.y[c] - p.y[b]) <= 0) return false;
    for (std::size_t other = a + 2; other < n; ++other)
      if ((other + 1) % n != a && meet(p, a, b, other, (other + 1) % n)) return false;
  }
  return true;
}

void describe(Describe& d, CircleSettings& circle)
{
  d.value("center", circle.center, {.meaning = "centre of the circle", .unit = "m", .required = true});
  d.value("diameter", circle.diameter, {.meaning = "diameter D of the circle", .unit = "m", .range = positive, .required = true});
}

void describe(Describe& d, HalfPlaneSettings& plane)
{
  d.value("point", plane.point, {.meaning = "a point of the surface", .unit = "m", .required = true});
  d.value("normal", plane.normal, {.meaning = "direction out of the rigid body, of any length", .required = true});
}

void describe(Describe& d, BoxSettings& box)
{
  d.value("center", box.center, {.meaning = "centre of the box", .unit = "m", .required = true});
  d.value("size", box.size, {.meaning = "lengths of its sides", .unit = "m", .range = positive, .required = true});
  d.value("angle", box.angle, {.meaning = "turn of the box, counter-clockwise", .unit = "rad", .range = {-pi, pi}});
}

void describe(Describe& d, PolygonSettings& polygon)
{
  d.value("x", polygon.x, {.meaning = "x of the corners, one after the other, either way round", .unit = "m", .required = true});
  d.value("y", polygon.y, {.meaning = "y of the corners", .unit = "m", .required = true});
}

void describe(Describe& d, RigidSettings& rigid)
{
  d.one_of("shape", rigid.shape, {"circle", "half_plane", "box", "polygon"}, {.meaning = "exact surface of the body", .required = true});
  d.value("mass", rigid.mass,
          {.meaning = "mass per metre run (in space: mass in kg); a direction that a force moves needs it",
           .unit = "kg/m",
           .range = not_negative});
  d.choice("motion", rigid.motion, {"driven", "free"},
           {.meaning = "where no stage drives it: rest, or let gravity and its contacts move it (but not in a geostatic stage)"});
  d.choice("rotation", rigid.rotation, {"fixed", "free"},
           {.meaning = "whether the moment of its contacts turns it about its centre (in space: about z)"});
  d.value(
      "moment_of_inertia", rigid.moment_of_inertia,
      {.meaning = "moment of inertia per metre run about its centre (in space: in kg m2); absent = that of a solid of this shape and mass",
       .unit = "kg m",
       .range = positive});
}

}  // namespace berm::bodies
