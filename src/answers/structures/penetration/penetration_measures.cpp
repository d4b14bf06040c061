// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/penetration/penetration_test.cpp
#include "structures/penetration/penetration_page.hpp"

#include "structures/base/general_measures.hpp"
#include "structures/driven/report.hpp"
#include "structures/penetration/penetration_run.hpp"
#include "structures/penetration/soil_profile.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::penetration {
namespace {

using Run = const record::RunRecord&;

namespace limits {

inline constexpr base::Limit steady{LastTravel::max_change, 0.15, base::Effect::short_travel,
                                    "a value that still changes is not a factor of steady penetration"};
inline constexpr base::Limit walls{
    2, 1, base::Effect::walls,
    "around a cylindrical cavity in clay the plastic zone reaches D/2 sqrt(I_r); a wall within it confines the soil", true};
inline constexpr base::Limit below_footing{1, 0.3, base::Effect::walls,
                                           "undrained soil fails down to 0.7 B below a footing; strips and circles on 1 to 1.2 B of soil "
                                           "are right (examples/strip_footing, circular_footing)",
                                           true};
inline constexpr base::Limit below{3, 1, base::Effect::walls,
                                   "the soil yields one to two diameters below a body; a base that near carries part of the load", true};

}  // namespace limits

/// The change over the end of the push, of the factor or else the resistance.
Real change_of(Run run, const Penetrometer& how)
{
  for (const char* symbol : {how.in_clay.plain, how.in_sand.plain, how.resistance.plain})
    if (const Real change = base::quantity_value(run, fmt::format("{}_change", symbol)); std::isfinite(change)) return std::abs(change);
  return nan;
}

/// Distance of the nearest wall that is none of symmetry, m; NaN where it is not known.
Real nearest_wall(const PenetrationRun& pushed)
{
  const Walls walls = walls_of(pushed.record, pushed.body);
  const Real middle = (pushed.body.left + pushed.body.right) / 2;
  Real nearest = walls.right - middle;
  if (walls.left < pushed.body.left - pushed.body.width) nearest = std::min(nearest, middle - walls.left);
  return std::isfinite(nearest) ? nearest : nan;
}

/// The same over the radius of the plastic zone around a cavity.
Real walls_over_plastic(Run run, const Penetrometer& how)
{
  const PenetrationRun pushed(run, how);
  if (pushed.z().empty()) return nan;
  return nearest_wall(pushed) / (pushed.body.width / 2 * std::sqrt(pushed.soil.at(pushed.z_end()).rigidity_index));
}

Real walls_over_D(Run run, const Penetrometer& how)
{
  const PenetrationRun pushed(run, how);
  return pushed.z().empty() ? nan : nearest_wall(pushed) / pushed.whole_width();
}

Real base_over_D(Run run, const Penetrometer& how)
{
  const PenetrationRun pushed(run, how);
  if (pushed.z().empty()) return nan;
  const Real base = walls_of(run, pushed.body).base;
  return std::isfinite(base) ? (run.settings.surface - base - pushed.w_end()) / pushed.body.width : nan;
}

std::string plain_limit(Real value)
{
  return fmt::format("{:g}", value);
}

}  // namespace

base::TrustMeasures penetration_measures(const settings::Case& c, const Penetrometer& how)
{
  const std::string body = base::body_word(c);
  base::TrustMeasures own = {
      {fmt::format("change of {} over the end of the push", how.in_clay.plain), &limits::steady, base::has_soil,
       [&how](Run run) { return change_of(run, how); }, base::in_percent,
       "the resistance still changes by {} over the end of the push: push deeper", text::percent_words},
      how.pushes_aside ? base::TrustMeasure{"nearest wall, over the plastic radius D/2 √I_r", &limits::walls, base::has_soil,
                                            [&how](Run run) { return walls_over_plastic(run, how); }, base::as_number,
                                            "the nearest wall is {} plastic radii away: make the mesh wider", plain_limit}
                       : base::TrustMeasure{"nearest wall from the middle, over D",
                                            nullptr,
                                            base::has_soil,
                                            [&how](Run run) { return walls_over_D(run, how); },
                                            base::as_number,
                                            {},
                                            nullptr},
      {fmt::format("soil below the {} at the end, over D", body), how.keeps_push ? &limits::below_footing : &limits::below, base::has_soil,
       [&how](Run run) { return base_over_D(run, how); }, base::as_number,
       fmt::format("the base is {{}} D below the {}: make the mesh deeper", body), plain_limit}};
  if (how.keeps_push) own.erase(own.begin());  // on its way to failure a footing is not steady
  return base::joined({driven::driven_measures(c, how.cells), own});
}

}  // namespace berm::penetration
