// SPDX-License-Identifier: BSD-3-Clause
#include "structures/structures.hpp"

#include "io/atomic_file.hpp"
#include "structures/anchor/anchor.hpp"
#include "structures/depth/profile_page.hpp"
#include "structures/driven/run_charts.hpp"
#include "structures/generic/generic.hpp"
#include "structures/lateral/shaft.hpp"
#include "structures/line/line.hpp"
#include "structures/penetration/penetration.hpp"
#include "structures/penetration/penetrometers.hpp"
#include "structures/pipe/pipe.hpp"

#include <algorithm>

namespace berm::structures {

const std::vector<base::Structure>& all_structures()
{
  static const std::vector<base::Structure> all = [] {
    std::vector<base::Structure> list = {
        penetration::pushed_down(penetration::cone()),
        penetration::pushed_down(penetration::ball()),
        penetration::pushed_down(penetration::t_bar()),
        lateral::shaft(lateral::pile()),
        lateral::shaft(lateral::skirt()),
        penetration::pushed_down(penetration::footing()),
        anchor::anchor(),
        line::pipeline(),
        pipe::pipe(),
        generic::other(),
    };
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
  if (!run.summary && run.history.rows() > 0) run.quantities = structure_of(run.settings).quantities(run, {});
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
