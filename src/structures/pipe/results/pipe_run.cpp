// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/pipe/published/published_test.cpp
#include "structures/pipe/results/pipe_run.hpp"

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

PipeRun::PipeRun(const record::RunRecord& run, std::size_t place_on_page)
    : record(run),
      name(run.name),
      settings(run.settings),
      history(run.history),
      quantities(run.quantities),
      end(run.end),
      scale(base::body_scale(run.settings)),
      stages(pipe_stages(run.settings)),
      place(place_on_page)
{
}

}  // namespace berm::pipe
