// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/structures_test.cpp
#include "structures/pipe/pipe.hpp"

#include "structures/pipe/axial_results.hpp"
#include "structures/pipe/pipe_report.hpp"
#include "structures/pipe/published.hpp"

namespace berm::pipe {

std::vector<run_folder::Quantity> Pipe::quantities(const record::RunRecord& run, const std::vector<Real>& held_forces) const
{
  std::vector<run_folder::Quantity> list = Driven::quantities(run, held_forces);
  if (list.empty()) return list;
  for (run_folder::Quantity& axial : axial_quantities(run)) list.push_back(std::move(axial));
  return list;
}

std::vector<std::string> Pipe::quantity_names(const problem::Case& c) const
{
  std::vector<std::string> names = Driven::quantity_names(c);
  if (names.empty()) return names;
  for (const problem::StageSettings& stage : c.stage)
    for (const char* begin : {"wedging_of_", "axial_friction_of_", "axial_gain_of_"}) names.push_back(begin + stage.name);
  return names;
}

std::string Pipe::in_words(const record::RunRecord& run, const base::DisplayUnits& shown) const
{
  return consolidation_words(driven::DrivenRun(run), shown) + Driven::in_words(run, shown);
}

std::string Pipe::key_results(const base::Runs& runs, const base::DisplayUnits& shown) const
{
  return Driven::key_results(runs, shown) + axial_table(driven::driven_runs(runs), shown);
}

std::string Pipe::published_values(const base::Runs& runs, const base::DisplayUnits& shown) const
{
  return pipe::published_values(driven::driven_runs(runs), shown);
}

base::EmbeddedBody Pipe::embedded(const problem::Case& c) const
{
  return embedded_pipe(c);
}

base::PublishedEnvelope Pipe::published_envelope(const problem::Case& c, const base::EnvelopeEnds& ends) const
{
  return pipe_envelope(c, ends);
}

}  // namespace berm::pipe
