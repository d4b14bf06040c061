// SPDX-License-Identifier: BSD-3-Clause
#include "springs/written_springs.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm::springs {
namespace {

/// A string of Python: those of JSON in plain letters are.
std::string quoted(const std::string& text)
{
  return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

std::string list_of(const Points& points, Real Point::*number)
{
  std::string text;
  for (const Point& p : points) text += fmt::format("{}{:.6g}", text.empty() ? "" : ", ", p.*number);
  return "[" + text + "]";
}

/// The material goes on with the last slope.
Points opensees_points(const WrittenSpring& spring, Real diameter)
{
  if (spring.direction == Direction::vertical) return upwards_positive(from_rest(spring.points), diameter);
  return both_ways(spring.direction == Direction::axial ? spring.points : level_beyond(spring.points, diameter));
}

std::string opensees_name(const WrittenSpring& spring)
{
  switch (spring.direction) {
  case Direction::axial:
    return "axial";
  case Direction::lateral:
    return "lateral " + spring.travel;
  default:
    return "vertical";
  }
}

constexpr const char* functions = R"(

def material(ops, name, tag, length):
    """The uniaxial material of a spring of SPRINGS for this length of pipe, m."""
    spring = SPRINGS[name]
    ops.uniaxialMaterial("ElasticMultiLinear", tag, 0.0, "-strain", *spring["u"], "-stress", *[F * length for F in spring["F"]])


def element(ops, name, tag, ground, node, direction, length):
    """A zeroLength element from a fixed node to one of the pipe at the same place, with the material of the same tag; direction is 1 to 3 for the
    element's x, y, z."""
    material(ops, name, tag, length)
    ops.element("zeroLength", tag, ground, node, "-mat", tag, "-dir", direction)
)";

}  // namespace

ExportFiles opensees_files(const Design& design)
{
  return by_estimate(design, "py", [&](const std::string& set, const Springs& s) {
    std::string text = comments(
        design, "# ",
        {"N and m: forces per length of pipe against displacements, in both directions. Vertical: upwards positive. " + rest_words(s),
         "Not run in OpenSees: by the reference of OpenSeesPy for ElasticMultiLinear and zeroLength.",
         "ElasticMultiLinear unloads along its loading curve: for monotonic motion of the pipe, not for cycles. There are no data beyond "
         "the ends; lateral and axial springs are constant there, the vertical one continues with its last slope.",
         "import springs_" + set + ", then springs_" + set +
             ".element(ops, \"axial\", tag, ground, node, direction, length) for each node; ops is openseespy.opensees."});
    text += "SPRINGS = {\n";
    for (const WrittenSpring& spring : springs_to_write(s)) {
      const Points points = opensees_points(spring, s.diameter);
      text += fmt::format("    {}: {{\n        \"origin\": {},\n        \"u\": {},\n        \"F\": {},\n    }},\n",
                          quoted(opensees_name(spring)), quoted(spring.origin), list_of(points, &Point::x), list_of(points, &Point::F));
    }
    return text + "}\n" + functions;
  });
}

}  // namespace berm::springs
