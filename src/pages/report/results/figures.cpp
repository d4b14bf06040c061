// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/report_test.cpp
#include "report/results/results_section.hpp"

#include "structures/structures.hpp"

namespace berm::report {

std::vector<std::string> draw_report_figures(const std::vector<record::RunRecord>& runs, const base::PublishedPoints& published,
                                             const std::filesystem::path& folder)
{
  std::vector<std::string> names;
  const auto add = [&](const std::vector<std::string>& drawn) { names.insert(names.end(), drawn.begin(), drawn.end()); };
  const std::vector<base::Structure>& all = structures::all_structures();
  for (const base::Structure& structure : all) add(structure.draw_report_curves(structures::runs_of(structure, runs), published, folder));
  add(draw_time_charts(runs, folder));
  for (const base::Structure& structure : all) add(structure.draw_report_soil(structures::runs_of(structure, runs), folder));
  std::vector<std::string> files;
  for (const std::string& name : names)
    for (const char* ending : {".svg", ".png"}) files.push_back(name + ending);
  return files;
}

}  // namespace berm::report
