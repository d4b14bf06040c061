// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/results/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::driven {
namespace {

using problem::StageKind;
using problem::StageSettings;

/// A stage ends after the step that reaches its limit.
bool meets(Real value, const std::optional<Real>& limit)
{
  constexpr Real step = 0.01;
  return limit && std::abs(value - *limit) <= step * std::abs(*limit);
}

/// Whether a push that came to this embedment was ended or driven by a force.
bool is_by_force(const StageSettings& push, Real w)
{
  return push.force || (push.until.force && !meets(w, push.until.embedment));
}

/// A key result's name in its parts: STAGE.NAME, or NAME alone, of the pushes before the first drag and of that drag.
struct ResultName {
  std::string stage, name;

  explicit ResultName(const std::string& whole)
  {
    const std::size_t dot = whole.rfind('.', whole.find("_at_"));
    if (dot != std::string::npos) stage = whole.substr(0, dot);
    name = dot == std::string::npos ? whole : whole.substr(dot + 1);
  }
  std::string beside(const std::string& other) const { return stage.empty() ? other : fmt::format("{}.{}", stage, other); }
};

/// The stages of a kind that a key result is of.
std::vector<StageSettings> stages_of(const ResultName& result, StageKind kind, const std::vector<StageSettings>& stages)
{
  const auto first_drag = std::find_if(stages.begin(), stages.end(),
                                       [](const StageSettings& s) { return s.kind == StageKind::drag && s.velocity.value_or(1) != 0; });
  auto from = stages.begin(), to = stages.end();
  if (result.stage.empty()) {
    from = kind == StageKind::push ? from : first_drag;
    to = kind == StageKind::push || first_drag == to ? first_drag : first_drag + 1;
  }
  std::vector<StageSettings> found;
  std::copy_if(from, to, std::back_inserter(found),
               [&](const StageSettings& s) { return s.kind == kind && (result.stage.empty() || s.name == result.stage); });
  return found;
}

}  // namespace

bool is_prescribed(const record::RunRecord& run, const run_folder::Quantity& quantity)
{
  const ResultName result(quantity.name);
  const std::string& name = result.name;
  const auto any = [&](StageKind kind, const auto& condition) {
    const std::vector<StageSettings> found = stages_of(result, kind, run.settings.stage);
    return std::any_of(found.begin(), found.end(), condition);
  };
  if (name == "w_end_of_push" || name == "w_end")
    return any(StageKind::push, [&](const StageSettings& s) { return meets(quantity.value, s.until.embedment); });
  if (name == "V_end_of_push" || name == "V_end") {
    const run_folder::Quantity* w = run.quantity(result.beside(name == "V_end" ? "w_end" : "w_end_of_push"));
    return any(StageKind::push, [&](const StageSettings& s) { return is_by_force(s, w == nullptr ? nan : w->value); });
  }
  if (name == "u_end_of_drag")
    return any(StageKind::drag, [&](const StageSettings& s) { return meets(quantity.value, s.until.displacement); });
  if (name == "V_end_of_drag" || name == "V_in_drag") return any(StageKind::drag, [](const StageSettings& s) { return s.vertical_force; });
  if (name == "w_end_of_drag" || name.starts_with("w_at_u"))
    return any(StageKind::drag, [](const StageSettings& s) { return s.vertical == problem::Vertical::fixed && !s.vertical_velocity; });
  return false;
}

}  // namespace berm::driven
