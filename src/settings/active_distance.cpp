// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/read_case_active_distance_test.cpp
#include "settings/stage_checks.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::settings {

void check_active_distance(Describe& d, const Case& c)
{
  if (!c.mpm.active_distance) return;
  const std::string key = "mpm.active_distance";
  const auto bounded = [](const bodies::RigidShapeSettings& shape) { return bodies::is_bounded(bodies::make_shape<2>(shape)); };
  d.check(c.method == Method::mpm, key, "is for method = \"mpm\"");
  d.check(c.geometry != Geometry::axisymmetric, key, "is for a body that travels along the ground: it cannot be combined with axisymmetry");
  d.check(std::any_of(c.rigid.begin(), c.rigid.end(), [&](const auto& rigid) { return bounded(rigid.second.shape); }), key,
          "needs a rigid body with bounds, from which the distance of soil can be measured");
  for (const StageSettings& stage : c.stage) {
    const Index rigid = stage.rigid.empty() ? 0 : index_of(c.rigid, stage.rigid);
    d.check(!drives(stage.kind) || rigid == none || c.rigid.empty() || bounded(c.rigid[static_cast<std::size_t>(rigid)].second.shape), key,
            fmt::format("stage \"{}\" drives a half-plane, which has no bounds", stage.name));
  }
  d.check(c.gravity_ramp == 0, key, "cannot be combined with gravity_ramp: inactive soil would not get its weight");
  d.check(c.traction.empty(), key, "cannot be combined with tractions, which load inactive soil");
  for (const auto& [name, contact] : c.contact) {
    d.check(contact.other_body.empty(), key, fmt::format("cannot be combined with [contact.{}] between two deformable bodies", name));
    d.check(!rules_of(contact.scheme).stress_first, key,
            fmt::format("cannot be combined with scheme = \"{}\"", rules_of(contact.scheme).word));
  }
  for (const auto& [name, body] : c.body)
    d.check(body.initial_velocity.empty() && body.initial_angular_velocity == 0, key,
            fmt::format("cannot be combined with a velocity of [body.{}] at the start", name));
  for (const auto& [name, material] : c.material)
    d.check(!hydraulics(material), key,
            fmt::format("cannot be combined with water that flows in [material.{}]: excess pore pressure spreads far from the body, too",
                        name));
}

}  // namespace berm::settings
