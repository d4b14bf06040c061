// SPDX-License-Identifier: BSD-3-Clause
#include "report/paper.hpp"

#include <algorithm>

namespace berm {
namespace {

using Json = nlohmann::ordered_json;

bool near(Real value, Real published)
{
  return std::abs(value - published) <= 2e-3 * std::abs(published);
}

/// The friction angle of the interface with the main rigid body; NaN without a contact.
Real interface_angle(const Case& c)
{
  const Index rigid = main_rigid(c);
  for (const auto& [name, contact] : c.contact)
    if (rigid != none && contact.rigid == c.rigid[rigid].first) return contact.friction_angle;
  return std::numeric_limits<Real>::quiet_NaN();
}

}  // namespace

bool is_of_paper(const RunRecord& run)
{
  const Case& c = run.settings;
  const Material* material = touched_material(c);
  const auto* sand = material == nullptr ? nullptr : std::get_if<MohrCoulomb>(material);
  if (!run.has_pipe() || sand == nullptr) return false;
  const bool pipe = std::holds_alternative<CircleSettings>(c.rigid[main_rigid(c)].second.shape) && near(run.scale.diameter, 0.02) &&
                    near(run.scale.gravity_level, 50);
  const bool soil =
      near(sand->friction_angle, 35 * pi / 180) && sand->cohesion == 0 && near(sand->young_modulus, 7e6) && near(sand->poisson_ratio, 0.25);
  return pipe && soil && near(interface_angle(c), 23.33 * pi / 180);
}

Json paper_points(const std::vector<RunRecord>& runs)
{
  Json points = Json::array();
  if (std::none_of(runs.begin(), runs.end(), is_of_paper)) return points;
  const Real D = 0.02;
  points.push_back({{"chart", "V_w"}, {"x", 0.1 * D}, {"y", 4000.}, {"label", "paper: V = 4 kN at w = 0.1 D"}});
  points.push_back({{"chart", "w_u"}, {"x", 0.3 * D}, {"y", 0.25 * D}, {"label", "paper: w = 0.25 D at u = 0.3 D"}});
  points.push_back({{"chart", "H_u"}, {"x", nullptr}, {"y", 1000.}, {"label", "paper, FEM at 0.1 D: about 1 kN"}});
  points.push_back({{"chart", "H_u"}, {"x", nullptr}, {"y", 2000.}, {"label", "paper, FEM at 0.25 D: about 2 kN"}});
  return points;
}

}  // namespace berm
