// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/pipe/published/published_test.cpp
#include "structures/pipe/results/pipe_run.hpp"

namespace berm::pipe {

PipeRun::PipeRun(const record::RunRecord& run, std::size_t number_on_page)
    : record(run),
      name(run.name),
      settings(run.settings),
      history(run.history),
      quantities(run.quantities),
      end(run.end),
      scale(base::body_scale(run)),
      stages(pipe_stages(run.settings)),
      number(number_on_page)
{
}

}  // namespace berm::pipe
