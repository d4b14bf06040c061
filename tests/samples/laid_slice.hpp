// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/pipeline_case.hpp"
#include "samples/temporary_folder.hpp"

#include "mpm/step.hpp"
#include "problem/stages.hpp"

namespace berm::test {

/// Its mesh is made in a folder of its own: tests run side by side.
inline problem::Problem<2> built_slice(const settings::Case& c)
{
  const TemporaryFolder folder;
  return problem::build<2>(c, ".", folder.path().string());
}

/// A slice in which the pipe is laid, where its last stage begins.
struct LaidSlice {
  explicit LaidSlice(const settings::Case& c) : problem(built_slice(c)), workspace(problem.model, problem.state)
  {
    while (problem.state.stage.index + 1 < static_cast<Index>(problem.model.stages.size())) {
      mpm::step(problem.model, problem.state, workspace);
      if (!stage_ended(problem.model, problem.state)) continue;
      ++problem.state.stage.index;
      begin_stage(problem.model, problem.state);
    }
  }

  problem::Problem<2> problem;
  mpm::Workspace<2> workspace;
};

}  // namespace berm::test
