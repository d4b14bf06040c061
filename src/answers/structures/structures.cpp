// SPDX-License-Identifier: BSD-3-Clause
#include "structures/structures.hpp"

#include "input/structure_words.hpp"
#include "io/atomic_file.hpp"
#include "structures/depth/profile_page.hpp"
#include "structures/driven/run_charts.hpp"
#include "structures/lateral/shaft.hpp"
#include "structures/other_bodies.hpp"
#include "structures/penetration/penetration.hpp"
#include "structures/penetration/penetrometers.hpp"

#include <algorithm>

#define BERM_NOT_HERE(...)
#define BERM_DECLARE(room, word, geometry)                                                                                                 \
  namespace berm::room {                                                                                                                   \
  base::Structure word();                                                                                                                  \
  }
BERM_STRUCTURES(BERM_NOT_HERE, BERM_NOT_HERE, BERM_DECLARE)

namespace berm::structures {

const std::vector<base::Structure>& all_structures()
{
#define BERM_PENETROMETER(word, geometry) penetration::pushed_down(penetration::word()),
#define BERM_SHAFT(word, geometry) lateral::shaft(lateral::word()),
#define BERM_STRUCTURE(room, word, geometry) room::word(),
  static const std::vector<base::Structure> all = [] {
    std::vector<base::Structure> list = {BERM_STRUCTURES(BERM_PENETROMETER, BERM_SHAFT, BERM_STRUCTURE)};
    for (base::Structure& structure : list) structure.readings.push_back(depth::reading());
    return list;
  }();
  return all;
}

const base::Structure& structure_of(const settings::Case& c)
{
  return *std::ranges::find_if(all_structures(), [&](const base::Structure& structure) { return structure.applies_to(c); });
}

base::Runs runs_of(const base::Structure& structure, const std::vector<record::RunRecord>& runs)
{
  base::Runs found;
  for (std::size_t number = 0; number < runs.size(); ++number)
    if (&structure_of(runs[number].settings) == &structure) found.push_back({&runs[number], number});
  return found;
}

record::RunRecord read_run(const std::filesystem::path& folder)
{
  record::RunRecord run = record::read_run(folder);
  if (!run.summary && run.history.rows() > 0) run.quantities = quantities_of(run, {});
  return run;
}

std::string curves_json(const record::RunRecord& run)
{
  base::Charts charts = structure_of(run.settings).charts(run);
  const run_folder::History& history = run.history;
  const bool is_driven = history.has("u_m") && history.has("w_m") && history.has_label("H") && history.has_label("V");
  if (is_driven && std::ranges::find(charts, "H_u", &base::Chart::id) == charts.end())
    for (base::Chart& chart : driven::run_charts(history, base::body_scale(run), driven::stages_of(run.settings)))
      charts.push_back(std::move(chart));
  const bool has_bands = run.summary && run.summary->uncertainty;
  return json_text(charts, history.rows(), has_bands ? run.summary->uncertainty->curves : std::vector<run_folder::CurveBand>{});
}

void write_curves(const run_folder::RunFolder& folder, const record::RunRecord& run)
{
  io::write_atomically(folder.file("curves.json"), curves_json(run));
}

}  // namespace berm::structures
