// SPDX-License-Identifier: BSD-3-Clause
#include "report/page/page.hpp"

#include "structures/base/driven_body.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>

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
std::string soil_of_case(const problem::Case& c)
{
  const std::optional<problem::BodySoil> soil = base::touched_soil(c);
  if (!soil) return "";
  std::string words = with_spaces(soil->names.front());
  for (const problem::SoilLayer& layer : soil->layers) words += " over " + with_spaces(soil->names[layer.material]);
  const base::BodyScale scale = base::body_scale(c);
  if (!soil->layers.empty() || !(scale.strength > 0)) return words;
  words += fmt::format(" with s_u = {} kPa", text::short_number(scale.strength / 1e3));
  return scale.strength_depth > 0 ? words + fmt::format(" at {}", short_length(scale.strength_depth)) : words;
}

std::string verb_of(const problem::StageSettings& stage)
{
  using enum problem::StageKind;
  if (stage.kind == push) return stage.velocity && *stage.velocity < 0 ? "lift" : "push";
  if (!stage.loads.empty() || !stage.load_times.empty()) return "load history";
  if (stage.kind == drag || stage.kind == sweep) return "drag";
  return stage.kind == free ? "rest" : with_spaces(stage.name);
}

/// " to w = 0.2 m", " 1.5 m": until when it lasts, where it has one limit that is not a time.
std::string limit_of(const problem::StageSettings& stage, int dimension)
{
  const problem::Until& until = stage.until;
  if (until.embedment) return fmt::format(" to w = {}", short_length(*until.embedment));
  if (until.displacement) return " " + short_length(*until.displacement);
  if (until.force)
    return fmt::format(" to {} = {}", stage.kind == problem::StageKind::drag ? "H" : "V", text::force_words(*until.force, dimension));
  if (until.consolidation) return fmt::format(" to U = {}", text::percent_words(*until.consolidation));
  return "";
}

/// "push to w = 0.2 m, 5 drags": stages of one kind behind one another count together.
std::string stages_of_case(const problem::Case& c)
{
  struct Group {
    std::string verb, limit;
    int count;
  };
  std::vector<Group> groups;
  for (const problem::StageSettings& stage : c.stage) {
    if (stage.kind == problem::StageKind::geostatic || (c.pipeline && stage.kind != problem::StageKind::pipeline)) continue;
    const std::string verb = verb_of(stage);
    if (!groups.empty() && groups.back().verb == verb)
      ++groups.back().count;
    else
      groups.push_back({verb, limit_of(stage, c.force_dimension()), 1});
  }
  std::vector<std::string> words;
  for (const auto& [verb, limit, count] : groups)
    if (words.size() < max_groups) words.push_back(count == 1 ? verb + limit : fmt::format("{} {}s", count, verb));
  return fmt::format("{}{}", fmt::join(words, ", "), groups.size() > max_groups ? " and so on" : "");
}

Question question_of_case(const problem::Case& c)
{
  const Real width = base::body_scale(c).width;
  if (!(width > 0)) return {};
  return {c.pipeline ? "pipeline" : base::body_word(c), short_length(width), soil_of_case(c), stages_of_case(c)};
}

void keep_common(std::string& part, const std::string& other)
{
  if (part != other) part.clear();
}

}  // namespace

std::string question_of(const std::vector<record::RunRecord>& runs)
{
  Question common = question_of_case(runs.front().settings);
  for (const record::RunRecord& run : runs) {
    const Question other = question_of_case(run.settings);
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
