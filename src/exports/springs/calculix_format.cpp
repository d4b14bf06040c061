// SPDX-License-Identifier: BSD-3-Clause
#include "record/run_record.hpp"
#include "springs/written_springs.hpp"

#include <fmt/format.h>

namespace berm::springs {
namespace {

/// Degrees of freedom are told from forces by their having no decimal point. SPRING2, as 2.20 takes no nonlinear SPRING1 in a model without elements of more constants.
std::string spring_lines(const char* set, int freedom, const Points& points)
{
  std::string text = fmt::format("*SPRING, ELSET={}, NONLINEAR\n{}, {}\n", set, freedom, freedom);
  for (const Point& p : points) text += fmt::format("{:.6e}, {:.6e}\n", p.F, p.x);
  return text;
}

/// A node at the end of two points has the stiffness of those behind it: one at the surface would have none, and the first step no solution.
Points from_above_the_surface(Points upwards, Real diameter)
{
  for (Point& p : upwards)
    if (p.x == 0) p.x = 1e-6 * diameter;
  return upwards;
}

/// What of a spring its file has: set, freedom, points.
std::string calculix_lines(const WrittenSpring& spring, Real diameter)
{
  switch (spring.direction) {
  case Direction::axial:
    return spring_lines("BERM_AXIAL", 1, both_ways(spring.points));
  case Direction::lateral:
    return spring_lines("BERM_LATERAL", 2, both_ways(spring.points));
  default:
    return spring_lines("BERM_VERTICAL", 3, from_above_the_surface(upwards_positive(from_rest(spring.points), diameter), diameter));
  }
}

std::string calculix_name(const WrittenSpring& spring)
{
  switch (spring.direction) {
  case Direction::axial:
    return "axial";
  case Direction::lateral:
    return "lateral_" + record::file_name_of(spring.travel);
  default:
    return "vertical";
  }
}

}  // namespace

ExportFiles calculix_files(const Design& design)
{
  ExportFiles files;
  for (const auto& [set, springs] : sets_of(design))
    for (const WrittenSpring& spring : springs_to_write(*springs)) {
      std::string text =
          comments(design, "** ",
                   {"N and m: SPRING2 elements from a node of the pipe to a fixed one, for 1 m of pipe, force before displacement. "
                    "Multiply the forces by another length that a node stands for.",
                    "To be included behind the elements of the set, before the first step. The numbers below *SPRING are "
                    "the freedom: here x lies along the pipe, y across it, z points up.",
                    "Take *STEP, NLGEOM: without it CalculiX 2.20 continues with the first slope, without a message.",
                    "Beyond its ends the force is constant. The vertical spring starts a millionth of D above the pipe without load.",
                    spring.direction == Direction::vertical ? rest_words(*springs) : ""});
      text += remark("** ", fmt::format("{} estimate: {}", set, spring.origin)) + calculix_lines(spring, springs->diameter);
      files.push_back({fmt::format("springs_{}_{}.inp", set, calculix_name(spring)), std::move(text)});
    }
  return files;
}

}  // namespace berm::springs
