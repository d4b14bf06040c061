// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/structures_test.cpp
#include "structures/base/soil_words.hpp"
#include "structures/driven/driven.hpp"
#include "structures/pipe/axial_results.hpp"
#include "structures/pipe/pipe_report.hpp"
#include "structures/pipe/published.hpp"

namespace berm::pipe {

/// A pipe on or in the bed. Bodies of other shapes that nothing else is known of are read by the same numbers, without the formulas, which are those of a circle.
base::Structure pipe()
{
  using Run = const record::RunRecord&;
  using driven::driven_runs;
  base::Reading travels = driven::reading();
  travels.headline = headline;
  return {"pipe",
          {{.charts = base::dissipation_charts,
            .words = [](Run run, const base::DisplayUnits& shown) { return consolidation_words(driven::DrivenRun(run), shown); }},
           travels,
           {.answers = [](Run run, const std::vector<Real>&) { return axial_quantities(run); },
            .names = axial_names,
            .key_results = [](const base::Runs& runs, const base::DisplayUnits& shown) { return axial_table(driven_runs(runs), shown); },
            .published = [](const base::Runs& runs, const base::DisplayUnits& shown) { return published_values(driven_runs(runs), shown); },
            .embedded = embedded_pipe,
            .published_envelope = pipe_envelope}}};
}

}  // namespace berm::pipe
