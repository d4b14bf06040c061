// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/pipe/published_test.cpp
#include "structures/pipe/pipe_case.hpp"

#include "bodies/rigid/rigid_body.hpp"

#include <Eigen/Core>

namespace berm::pipe {

PipeStages pipe_stages(const problem::Case& c)
{
  PipeStages stages;
  for (const problem::StageSettings& stage : c.stage) {
    if (stage.kind == problem::StageKind::push) stages.push.push_back(stage.name);
    if (stage.kind == problem::StageKind::drag) stages.drag.push_back(stage.name);
  }
  return stages;
}

const contact::ContactSettings* contact_of_pipe(const problem::Case& c)
{
  const Index rigid = main_rigid(c);
  const contact::ContactSettings* found = nullptr;
  for (const auto& [name, contact] : c.contact)
    if (rigid != none && contact.rigid == c.rigid[rigid].first) found = &contact;
  return found;
}

const material::Material* touched_material(const problem::Case& c)
{
  const contact::ContactSettings* contact = contact_of_pipe(c);
  const Index body = contact == nullptr ? none : problem::place_of(c.body, contact->body);
  const Index material = body == none ? none : problem::place_of(c.material, c.body[body].second.material);
  return material == none ? nullptr : &c.material[material].second;
}

PipeScale pipe_scale(const problem::Case& c)
{
  const Real gravity = Eigen::Map<const Eigen::VectorXd>(c.gravity.data(), static_cast<Eigen::Index>(c.gravity.size())).norm();
  PipeScale scale{0, 0, gravity / standard_gravity, c.method == problem::Method::mpm, c.dimension};
  const Index rigid = main_rigid(c);
  if (rigid == none) return scale;
  const bodies::RigidShapeSettings& shape = c.rigid[rigid].second.shape;
  const PipeStages stages = pipe_stages(c);
  if (!stages.push.empty() || !stages.drag.empty())
    scale.diameter = c.dimension == 2 ? width_of<2>(make_shape<2>(shape)) : width_of<3>(make_shape<3>(shape));
  if (const material::Material* material = touched_material(c)) scale.unit_weight = density(*material) * gravity;
  return scale;
}

}  // namespace berm::pipe
