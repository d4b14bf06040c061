// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/quality/quality_section_test.cpp
#include "report/quality/judgement.hpp"

#include "os/text_of_list.hpp"
#include "structures/base/general_measures.hpp"
#include "structures/structures.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

using text::Standing;
using Words = std::vector<std::string>;

constexpr Real max_work_of_contact = 0.01;   // of all work: round-off and the contact's springs give less
constexpr std::size_t max_log_warnings = 5;  // of a run; a finite element run may warn at every increment

bool holds(const Words& words, const std::string& one)
{
  return std::find(words.begin(), words.end(), one) != words.end();
}

std::vector<JudgedMeasure> judged_measures(const record::RunRecord& run)
{
  std::vector<JudgedMeasure> judged;
  for (base::TrustMeasure& measure : structures::structure_of(run.settings).measures(run.settings)) {
    if (!measure.applies(run)) continue;
    const Real value = measure.value(run);
    const Standing standing = std::isnan(value)          ? Standing::unknown
                              : measure.limit == nullptr ? Standing::good
                                                         : judge(*measure.limit, value);
    judged.push_back({std::move(measure), value, standing});
  }
  return judged;
}

/// That some measures which are not good make the resistance too large and others too small; "" where all go one way.
std::string opposite_words(const std::vector<JudgedMeasure>& measures)
{
  const auto named = [&](base::Sense sense) {
    Words names;
    for (const auto& [measure, value, standing] : measures)
      if ((standing == Standing::fair || standing == Standing::bad) && measure.limit->sense == sense) names.push_back(measure.what);
    return names;
  };
  const Words large = named(base::Sense::too_large), small = named(base::Sense::too_small);
  if (large.empty() || small.empty()) return "";
  return fmt::format("The measures that are not good have opposite effects, and the sign of their sum is not known. Resistance is too "
                     "large because of: {}. Too small because of: {}. Improve them one at a time, and compare.",
                     text_of_list(large, "; "), text_of_list(small, "; "));
}

/// Why the measures of a run are not good, except what makes it invalid; a measure that is bad makes the run bad.
void add_measures(Judgement& all, const record::RunRecord& run, const Words& invalid)
{
  Words not_known;
  for (const auto& [measure, value, standing] : all.measures) {
    if (standing == Standing::unknown) not_known.push_back(measure.what);
    if (standing == Standing::bad) all.standing = Standing::bad;
    if (standing == Standing::unknown || standing == Standing::good) continue;
    const std::string warning = measure.warning_of(run, value);
    if (!holds(invalid, warning)) all.warnings.push_back(warning + ".");
  }
  if (const std::string opposite = opposite_words(all.measures); !opposite.empty()) all.warnings.push_back(opposite);
  if (run.settings.method == settings::Method::mpm && !run.settings.mpm.volumetric_projection)
    all.warnings.emplace_back("plain triangles lock: mpm.volumetric_projection is off, and resistance is too large.");
  if (const Real given = base::work_of_contact(run); given > max_work_of_contact)
    all.warnings.push_back(fmt::format("contact added energy, {:.2g} % of the work, instead of dissipating it.", 100 * given));
  if (!run.summary && !not_known.empty())
    all.warnings.push_back(fmt::format("the run has no summary, so this is not known: {}.", text_of_list(not_known, "; ")));
}

/// What the case and the log warn of.
void add_warnings(Judgement& all, const record::RunRecord& run)
{
  const Words of_the_case = run.summary ? run.summary->warnings : Words();
  for (const std::string& warning : of_the_case) all.warnings.push_back("the case is doubtful: " + warning);
  std::size_t in_log = 0;
  for (const std::string& warning : run.warnings)
    if (!warning.starts_with("the answer is invalid: ") && !holds(of_the_case, warning) && ++in_log <= max_log_warnings)
      all.warnings.push_back("run.log: " + warning);
  if (in_log > max_log_warnings) all.warnings.push_back(fmt::format("run.log has {} more warnings.", in_log - max_log_warnings));
}

}  // namespace

Judgement judgement_of(const record::RunRecord& run)
{
  const Words invalid = run.summary ? run.summary->invalid : Words();
  Judgement all{invalid.empty() ? Standing::good : Standing::bad, judged_measures(run), {}};
  for (const std::string& why : invalid)
    all.warnings.push_back("the answer is invalid, and its numbers, marked (!), must not be used: " + why + ".");
  add_measures(all, run, invalid);
  add_warnings(all, run);
  if (all.standing == Standing::good && !all.warnings.empty()) all.standing = Standing::fair;
  return all;
}

std::vector<Judgement> judgements_of(const std::vector<record::RunRecord>& runs)
{
  std::vector<Judgement> all;
  for (const record::RunRecord& run : runs) all.push_back(judgement_of(run));
  return all;
}

}  // namespace berm::report
