// SPDX-License-Identifier: BSD-3-Clause
#include "springs/formats.hpp"

#include "os/error.hpp"
#include "os/text_of_list.hpp"
#include "springs/written_springs.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::springs {
namespace {

bool has_friction(const Lateral& l)
{
  return l.V > 0 && l.peak > 0;
}

}  // namespace

bool takes_numbers(const Springs& s)
{
  const auto is_known = [](const Unloading& u) { return is_stiffness(u.stiffness); };
  return takes_points(s) || (!(s.V <= 0) && std::ranges::any_of(s.vertical.unloading, is_known));
}

bool takes_points(const Springs& s)
{
  return !springs_to_write(s).empty();
}

bool takes_profiles(const Springs& s)
{
  return std::ranges::any_of(springs_to_write(s),
                             [](const WrittenSpring& spring) { return spring.direction == Direction::vertical || spring.V > 0; });
}

bool takes_coefficients(const Springs& s)
{
  return std::ranges::any_of(s.lateral, has_friction) || (!axial_spring(s).empty() && axial_V(s) > 0);
}

bool takes_components(const Springs& s)
{
  return std::ranges::any_of(s.lateral, [](const Lateral& l) { return has_friction(l) && is_stiffness(l.stiffness()); });
}

bool takes_options(const Springs& s)
{
  return std::ranges::any_of(s.lateral, has_friction) || (s.lateral.empty() && takes_numbers(s) && !std::isnan(normal_stiffness(s).value));
}

void check_taken(const Design& design, const Format& format)
{
  if (format.takes(design.best)) return;
  std::vector<std::string> why = design.best.missing;
  for (const Lateral& l : design.best.lateral)
    if (!(l.V > 0)) why.push_back(without_friction(l.stage));
  throw RunError(fmt::format("{}: state {} has no spring that --to {} can write{}{}", design.name, design.best.state, format.name,
                             why.empty() ? "" : ": ", text_of_list(why, "; ")));
}

}  // namespace berm::springs
