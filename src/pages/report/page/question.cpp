// SPDX-License-Identifier: BSD-3-Clause
#include "os/text_of_list.hpp"
#include "report/page/page.hpp"

#include "structures/base/driven_body.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace berm::report {
namespace {

constexpr std::size_t max_groups = 4;  // of stages

/// What a run asks, part by part; "" where that is not known.
struct Question {
  std::string body, size, soil, stages;
};

std::string with_spaces(std::string name)
{
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

/// "0.5 m", "20 mm".
std::string short_length(Real metres)
{
  constexpr Real least_in_metres = 0.1;
  return std::abs(metres) < least_in_metres ? text::short_number(metres * 1000) + " mm" : text::short_number(metres) + " m";
}

/// "clay with s_u = 5 kPa", of a strength that varies "clay with s_u = 5 kPa at 0.2 m", that depth; "sand over clay".
std::string soil_of(const record::RunRecord& run)
{
  const settings::Case& c = run.settings;
  const std::optional<settings::BodySoil> soil = base::touched_soil(c);
  if (!soil) return "";
  std::string words = with_spaces(soil->names.front());
  for (const settings::SoilLayer& layer : soil->layers) words += " over " + with_spaces(soil->names[layer.material]);
  const base::BodyScale scale = base::body_scale(run);
  if (!soil->layers.empty() || !(scale.strength > 0)) return words;
  words += fmt::format(" with s_u = {} kPa", text::short_number(scale.strength / 1e3));
  return scale.strength_depth > 0 ? words + fmt::format(" at {}", short_length(scale.strength_depth)) : words;
}

std::string verb_of(const settings::StageSettings& stage)
{
  using enum settings::StageKind;
  if (stage.kind == push) return stage.velocity && *stage.velocity < 0 ? "lift" : "push";
  if (!stage.loads.empty() || !stage.load_times.empty()) return "load history";
  if (stage.kind == drag || stage.kind == sweep) return "drag";
  return stage.kind == free ? "dwell" : with_spaces(stage.name);
}

/// A length that a run came to along a limit of it, m: the limit where it was reached.
Real reached_of(Real came_to, Real limit)
{
  constexpr Real short_of_it = 0.01;
  return std::abs(came_to - limit) < short_of_it * std::abs(limit) ? limit : came_to;
}

/// The row before a stage, where its way begins.
Index first_row(const run_folder::History& h, const std::string& stage)
{
  const auto first = std::find(h.stage.begin(), h.stage.end(), stage);
  return std::max<Index>(0, static_cast<Index>(first - h.stage.begin()) - 1);
}

/// The last row of a stage in the history of a run; none where it did not begin.
Index last_row(const run_folder::History& h, const std::string& stage)
{
  const auto last = std::find(h.stage.rbegin(), h.stage.rend(), stage);
  return last == h.stage.rend() ? none : static_cast<Index>(h.stage.rend() - last - 1);
}

/// Whether the last row of a stage has a value that is within a tenth of a limit of force.
bool came_to_force(const record::RunRecord& run, const settings::StageSettings& stage, Index row)
{
  constexpr Real noise = 0.1;
  const char* label = stage.kind == settings::StageKind::drag ? "H" : "V";
  return run.history.has_label(label) && std::abs(std::abs(run.history.by_label(label)[row] / *stage.until.force) - 1) < noise;
}

/// " to w = 0.2 m", " 1.5 m": until when it lasted, where that is not a time: of limits the one that the run came to, and where it ended before how far it came.
std::string limit_of(const record::RunRecord& run, const settings::StageSettings& stage)
{
  const settings::Until& until = stage.until;
  const run_folder::History& h = run.history;
  const Index row = last_row(h, stage.name);
  const bool knows = row != none && h.has("w_m") && h.has("u_m");
  const std::string force = until.force ? fmt::format(" to {} = {}", stage.kind == settings::StageKind::drag ? "H" : "V",
                                                      text::force_words(*until.force, run.settings.force_dimension()))
                                        : "";
  const bool by_force = until.force && knows && came_to_force(run, stage, row);
  if (until.embedment) {
    const Real w = knows ? reached_of(h["w_m"][row], *until.embedment) : *until.embedment;
    return by_force && w != *until.embedment ? force : fmt::format(" to w = {}", short_length(w));
  }
  if (until.displacement) {
    const bool along_x = knows && stage.kind == settings::StageKind::drag;
    const Real u =
        along_x ? reached_of(std::abs(h["u_m"][row] - h["u_m"][first_row(h, stage.name)]), *until.displacement) : *until.displacement;
    return by_force && (!along_x || u != *until.displacement) ? force : " " + short_length(u);
  }
  if (until.force) return !knows || by_force ? force : "";
  if (until.consolidation) return fmt::format(" to U = {}", text::percent_words(*until.consolidation));
  return "";
}

/// "3 pushes", "2 load histories".
std::string counted(int count, std::string verb)
{
  if (verb.ends_with("sh"))
    verb += 'e';
  else if (verb.ends_with("y"))
    verb.replace(verb.size() - 1, 1, "ie");
  return fmt::format("{} {}s", count, verb);
}

/// "push to w = 0.2 m, 5 drags": stages of one kind behind one another count together.
std::string stages_of(const record::RunRecord& run)
{
  const settings::Case& c = run.settings;
  struct Group {
    std::string verb, limit;
    int count;
  };
  std::vector<Group> groups;
  for (const settings::StageSettings& stage : c.stage) {
    if (stage.kind == settings::StageKind::geostatic || (c.pipeline && stage.kind != settings::StageKind::pipeline)) continue;
    const std::string verb = verb_of(stage);
    if (!groups.empty() && groups.back().verb == verb)
      ++groups.back().count;
    else
      groups.push_back({verb, limit_of(run, stage), 1});
  }
  std::vector<std::string> words;
  for (const auto& [verb, limit, count] : groups)
    if (words.size() < max_groups) words.push_back(count == 1 ? verb + limit : counted(count, verb));
  return fmt::format("{}{}", text_of_list(words, ", "), groups.size() > max_groups ? " and so on" : "");
}

Question question_of_run(const record::RunRecord& run)
{
  const settings::Case& c = run.settings;
  const Real width = base::body_scale(c).width;
  if (!(width > 0)) return {};
  return {c.pipeline ? "pipeline" : base::body_word(c), short_length(width), soil_of(run), stages_of(run)};
}

void keep_common(std::string& part, const std::string& other)
{
  if (part != other) part.clear();
}

}  // namespace

std::string question_of(const std::vector<record::RunRecord>& runs)
{
  Question common = question_of_run(runs.front());
  for (const record::RunRecord& run : runs) {
    const Question other = question_of_run(run);
    keep_common(common.body, other.body);
    keep_common(common.size, other.size);
    keep_common(common.soil, other.soil);
    keep_common(common.stages, other.stages);
  }
  if (common.body.empty()) return "";
  std::string words = common.body;
  words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  if (!common.size.empty()) words += " of " + common.size;
  if (!common.soil.empty()) words += " in " + common.soil;
  return common.stages.empty() ? words : words + ": " + common.stages;
}

}  // namespace berm::report
