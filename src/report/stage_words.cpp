// SPDX-License-Identifier: BSD-3-Clause
#include "report/stage_words.hpp"

#include "report/quantity_words.hpp"

#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace berm {
namespace {

std::string vertical_words(const StageSettings& stage)
{
  if (stage.kind != StageKind::drag) return "";
  if (stage.vertical == Vertical::fixed) return ", w fixed";
  if (stage.vertical_velocity) return fmt::format(", {} down", speed_words(*stage.vertical_velocity));
  if (stage.vertical_force) return fmt::format(", V = {}", line_load_words(*stage.vertical_force));
  return ", V held";
}

std::string rate_words(const StageSettings& stage)
{
  return stage.velocity ? speed_words(*stage.velocity) : stage.force ? line_load_words(*stage.force) : "";
}

}  // namespace

std::string until_words(const StageSettings& stage, Real scale)
{
  const Until& until = stage.until;
  std::vector<std::string> limits;
  if (until.embedment) limits.push_back("w = " + length_words(scale * *until.embedment));
  if (until.displacement) limits.push_back(length_words(scale * *until.displacement));
  if (until.force)
    limits.push_back(fmt::format("{} = {}", stage.kind == StageKind::drag ? "H" : "V", line_load_words(scale * *until.force)));
  if (until.time) limits.push_back(time_words(*until.time));
  return fmt::format("{}", fmt::join(limits, " or "));
}

std::string drive_words(const StageSettings& stage)
{
  switch (stage.kind) {
  case StageKind::geostatic:
    return "the soil finds its equilibrium";
  case StageKind::free:
    return "time goes on";
  case StageKind::push:
    return rate_words(stage) + " down";
  case StageKind::drag:
    return rate_words(stage) + " along x" + vertical_words(stage);
  }
  return "";
}

std::string stage_words(const StageSettings& stage)
{
  constexpr std::array kinds{"geostatic", "push", "drag", "free"};
  const std::string kind = kinds[static_cast<std::size_t>(stage.kind)];
  // The user's own name says more than the kind only where it is another word.
  const std::string called = stage.name == kind ? kind : fmt::format("{} ({})", kind, stage.name);
  const std::string rate = rate_words(stage), vertical = vertical_words(stage);
  const bool to_a_level = stage.until.embedment.has_value();
  return fmt::format("{}{}{}{}{}", called, rate.empty() ? "" : " " + rate, vertical, to_a_level ? " to " : ", ", until_words(stage));
}

}  // namespace berm
