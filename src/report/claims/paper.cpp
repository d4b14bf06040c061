// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/claims/claims_test.cpp
#include "report/claims/paper.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

bool near(Real value, Real published)
{
  return std::abs(value - published) <= 2e-3 * std::abs(published);
}

}  // namespace

bool is_of_paper(const pipe::RunRecord& run)
{
  const problem::Case& c = run.settings;
  const material::Material* material = pipe::touched_material(c);
  const auto* sand = material == nullptr ? nullptr : std::get_if<material::MohrCoulomb>(material);
  if (!run.has_pipe() || sand == nullptr || c.dimension != 2) return false;
  const bool pipe = std::holds_alternative<bodies::CircleSettings>(c.rigid[main_rigid(c)].second.shape) &&
                    near(run.scale.diameter, paper_diameter) && near(run.scale.gravity_level, 50);
  const bool soil =
      near(sand->friction_angle, 35 * pi / 180) && sand->cohesion == 0 && near(sand->young_modulus, 7e6) && near(sand->poisson_ratio, 0.25);
  return pipe && soil && near(pipe::contact_of_pipe(c)->friction_angle, 23.33 * pi / 180);
}

std::vector<PaperPoint> paper_points(const std::vector<pipe::RunRecord>& runs)
{
  if (std::none_of(runs.begin(), runs.end(), is_of_paper)) return {};
  const Real D = paper_diameter;
  std::vector<PaperPoint> points = {
      {"V_w", paper_w_push * D, paper_V_push, fmt::format("paper: V = {:g} kN at w = {:g} D", paper_V_push / 1000, paper_w_push)},
      {"w_u", paper_u_drag * D, paper_w_drag * D, fmt::format("paper: w = {:g} D at u = {:g} D", paper_w_drag, paper_u_drag)}};
  for (const auto& [w, H] : paper_H_fem) points.push_back({"H_u", {}, H, fmt::format("paper, FEM at {:g} D: about {:g} kN", w, H / 1000)});
  return points;
}

}  // namespace berm::report
