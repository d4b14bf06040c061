// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/sample_case.hpp"

namespace berm::problem {

constexpr Real dt = 1e-3;  // s

/// The rigid body of a problem alone: the soil's force on it is whatever the test says.
struct Driver {
  Problem<2> problem;
  bodies::RigidState<2>& pipe;

  explicit Driver(std::vector<settings::StageSettings> stages)
      : problem(build<2>(pipe_over_box(std::move(stages)), ".", ".")),
        pipe(problem.state.rigid_bodies[0])
  {
  }
  void soil_pushes(const Vec<2>& force)
  {
    pipe.reaction = force;
    pipe.recent = bodies::RecentReaction<2>::steady(force, 0);
  }
  void step()
  {
    drive_rigids(problem.model, problem.state, dt);
    pipe.displacement += dt * pipe.velocity;
    problem.state.time += dt;
  }
  void next_stage()
  {
    ++problem.state.stage.index;
    begin_stage(problem.model, problem.state);
  }
  bool ended() const { return stage_ended(problem.model, problem.state); }
  Real w() const { return travel_of(problem.model, problem.state, 0).w; }
};

inline settings::StageSettings push(Real velocity, Real ramp = 0)
{
  settings::StageSettings stage = stage_of(settings::StageKind::push, "push");
  stage.velocity = velocity;
  stage.ramp = ramp;
  return stage;
}
inline settings::StageSettings drag(Real velocity, Real ramp = 0)
{
  settings::StageSettings stage = stage_of(settings::StageKind::drag, "drag");
  stage.velocity = velocity;
  stage.ramp = ramp;
  return stage;
}

}  // namespace berm::problem
