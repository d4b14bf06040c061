// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/linear_elastic.hpp"
#include "problem/model.hpp"
#include "problem/stages.hpp"

namespace berm::problem {

inline settings::StageSettings stage_of(settings::StageKind kind, const char* name = "stage")
{
  settings::StageSettings stage;
  stage.name = name;
  stage.kind = kind;
  stage.until.time = 1e9;
  return stage;
}

/// An elastic box of 2 m x 1 m with a pipe of 0.4 m, 2 kg/m, whose invert is 0.1 m above the surface y = 1 m.
inline settings::Case pipe_over_box(std::vector<settings::StageSettings> stages)
{
  settings::Case c;
  mesh::BoxMesh box;
  box.size = {2, 2};
  box.cells = {4, 4};
  c.mesh = box;
  c.surface = 1;
  material::LinearElastic law;
  law.density = 1000;
  law.young_modulus = 1e6;
  c.material = {{"solid", law}};
  bodies::BodySettings body;
  body.material = "solid";
  body.regions = {"box"};
  c.body = {{"bed", body}};
  bodies::RigidSettings pipe;
  pipe.shape = bodies::CircleSettings{{1, 1.3}, 0.4};
  pipe.mass = 2;
  c.rigid = {{"pipe", pipe}};
  c.stage = std::move(stages);
  return c;
}

}  // namespace berm::problem
