// SPDX-License-Identifier: BSD-3-Clause
#include "structures/structures.hpp"

#include "structures/anchor/anchor.hpp"
#include "structures/generic/generic.hpp"
#include "structures/lateral/pile.hpp"
#include "structures/lateral/shaft.hpp"
#include "structures/lateral/skirt.hpp"
#include "structures/line/line.hpp"
#include "structures/penetration/footing.hpp"
#include "structures/penetration/readings.hpp"
#include "structures/pipe/pipe.hpp"

#include <algorithm>

namespace berm::structures {

const std::vector<const base::Structure*>& all_structures()
{
  static const penetration::Penetration cone(penetration::cone_reading()), ball(penetration::ball_reading()),
      t_bar(penetration::t_bar_reading());
  static const lateral::Shaft pile(lateral::pile_reading());
  static const lateral::Skirt skirt;
  static const penetration::Footing footing;
  static const anchor::Anchor anchor;
  static const pipe::Pipe pipe;
  static const line::Line line;
  static const generic::Generic generic;
  static const std::vector<const base::Structure*> all = {&cone, &ball, &t_bar, &pile, &skirt, &footing, &anchor, &line, &pipe, &generic};
  return all;
}

const base::Structure& structure_of(const problem::Case& c)
{
  const std::vector<const base::Structure*>& all = all_structures();
  return **std::find_if(all.begin(), all.end(), [&](const base::Structure* structure) { return structure->applies_to(c); });
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

}  // namespace berm::structures
