// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/base/invalid_answer_test.cpp
#include "structures/base/invalid_answer.hpp"

#include "os/text_of_list.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/base/general_measures.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::base {
namespace {

using Run = const record::RunRecord&;

/// What a measure of the page says where it is bad.
void add_bad(const TrustMeasure& measure, Run run, std::vector<std::string>& found)
{
  if (!measure.applies(run)) return;
  const Real value = measure.value(run);
  if (!std::isnan(value) && judge(*measure.limit, value) == text::Standing::bad) found.push_back(measure.warning_of(run, value));
}

void add_no_numbers(Run run, std::vector<std::string>& found)
{
  const run_folder::History& h = run.history;
  for (const char* label : {"u", "w", "H", "V", "external", "internal", "kinetic"}) {
    if (!h.has_label(label)) continue;
    const std::vector<Real>& values = h.by_label(label);
    const auto first = std::find_if(values.begin(), values.end(), [](Real value) { return !std::isfinite(value); });
    if (first == values.end()) continue;
    found.push_back(fmt::format("{} is not a number from t = {} on", label,
                                text::time_words(h["time_s"][static_cast<std::size_t>(first - values.begin())])));
    return;
  }
}

bool goes_through_soil(const settings::StageSettings& stage)
{
  return stage.kind == settings::StageKind::drag ||
         (stage.kind == settings::StageKind::push && !(stage.velocity && *stage.velocity < 0) && !(stage.force && *stage.force < 0));
}

/// Whether soil resisted the drag in one of these rows: it does not resist a gate that is drawn away from it.
bool is_resisted(const run_folder::History& h, Index begin, Index end)
{
  const std::vector<Real>&u = h.by_label("u"), &H = h.by_label("H");
  const Real forwards = u[end - 1] - u[begin];
  return std::any_of(H.begin() + begin, H.begin() + end, [&](Real force) { return force * forwards > 0; });
}

void add_lost_soil(Run run, std::vector<std::string>& found)
{
  constexpr Index least_rows = 10;  // of a stage; its last tenth is looked at
  const run_folder::History& h = run.history;
  if (!drives_a_body(run.settings) || h.rows() == 0 || !h.has_label("V") || !h.has_label("H")) return;
  const auto touches = [&](Index row) { return h.by_label("V")[row] != 0 || h.by_label("H")[row] != 0; };
  bool touched = false;
  for (Index begin = 0, end = 0; begin < h.rows(); begin = end) {
    while (end < h.rows() && h.stage[end] == h.stage[begin]) touched = touches(end++) || touched;
    const auto stage =
        std::find_if(run.settings.stage.begin(), run.settings.stage.end(), [&](const auto& s) { return s.name == h.stage[begin]; });
    if (stage == run.settings.stage.end() || !goes_through_soil(*stage) || !touched || end - begin < least_rows) continue;
    if (stage->kind == settings::StageKind::drag && h.has_label("u") && !is_resisted(h, begin, end)) continue;
    bool at_end = false;
    for (Index row = end - (end - begin) / least_rows; row < end; ++row) at_end = at_end || touches(row);
    if (!at_end) found.push_back(fmt::format("at the end of stage \"{}\" the body no longer touches soil", stage->name));
  }
}

}  // namespace

std::vector<std::string> invalid_because(Run run)
{
  std::vector<std::string> found;
  add_no_numbers(run, found);
  add_bad(energy_balance(run.settings.method), run, found);
  if (run.settings.method == settings::Method::mpm) {
    add_bad(momentum_balance(), run, found);
    add_bad(soil_at_largest_volume(), run, found);
  }
  add_lost_soil(run, found);
  return found;
}

std::string invalid_words(const std::vector<std::string>& invalid)
{
  return text_of_list(invalid, "; ");
}

std::vector<std::string> invalid_lines(const std::string& run, const std::vector<std::string>& invalid, const char* numbers)
{
  std::vector<std::string> lines;
  for (const std::string& why : invalid)
    lines.push_back(fmt::format("{} the answer of {} is invalid, do not use {}: {}", invalid_line_begin, run, numbers, why));
  return lines;
}

const char* invalid_mark(const std::vector<std::string>& invalid)
{
  return invalid.empty() ? "" : " (!)";
}

}  // namespace berm::base
