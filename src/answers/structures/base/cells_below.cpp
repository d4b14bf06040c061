// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/base/cells_below_test.cpp
#include "structures/base/cells_below.hpp"

#include "mesh/seabed.hpp"
#include "problem/cells_at_body.hpp"
#include "settings/drainage.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/base/kind.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::base {
namespace {

inline constexpr Limit limit = too_large({50, 10, Effect::cells,
                                          "the resistance of a smooth circle on clay with k D/s_u0 = 6 is 7 % too large with cells of D/23 "
                                          "below its centre and D/125 at its edge, and less with finer cells there",
                                          true});

/// Of undisturbed soil below the body, Pa; 0 where none is known.
Real strength_at(const settings::BodySoil& soil, Real depth)
{
  return settings::strength_under(soil.at("", depth), 0, soil.vertical_stress("", depth)).value_or(0);
}

bool strengthens_below(const settings::Case& c)
{
  constexpr Real a_quarter = 0.25;
  const std::optional<settings::BodySoil> soil = touched_soil(c);
  if (!soil) return false;
  const Real depth = std::max(Real(0), soil_depth(c, problem::ground_of(c), reference_depth(c)));
  const Real below = strength_at(*soil, depth + a_quarter * body_scale(c).width);
  return below > 0 && below >= (1 + a_quarter) * strength_at(*soil, depth);
}

}  // namespace

Real largest_cell_below(const settings::Case& c)
{
  const Index rigid = main_rigid(c);
  const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh);
  if (rigid == none || bed == nullptr || bed->in_space()) return nan;
  const std::optional<BodyProfile> body = body_profile(c.rigid[rigid].second.shape);
  if (!body || body->disk || body->shoulder > 0) return nan;
  const Real from = c.geometry == settings::Geometry::axisymmetric ? body->bore : body->left;
  const Real away = std::max({Real(0), bed->near_left - from, body->right - bed->near_right});
  return std::min(layout_of(*bed).far_size, bed->near_size + bed->growth * away);
}

TrustMeasure cells_below(const std::string& body)
{
  return {"largest cells below the base of the " + body,
          &limit,
          [](const record::RunRecord& run) {
            return largest_cell_below(run.settings) > problem::coarser_cells * near_cell_size(run.settings) &&
                   strengthens_below(run.settings);
          },
          [](const record::RunRecord& run) { return body_scale(run.settings).width / largest_cell_below(run.settings); },
          [](const record::RunRecord& run, Real value) {
            return fmt::format("D/{:.3g} ({})", value, text::length_words(largest_cell_below(run.settings)));
          },
          [body](const record::RunRecord&, Real value) {
            return fmt::format("cells grow to D/{:.3g} below the base of the {}, in soil whose strength grows with depth: its resistance "
                               "is too large. Extend the fine zone below the whole base",
                               value, body);
          },
          [](Real value) { return fmt::format("D/{:g}", value); }};
}

}  // namespace berm::base
