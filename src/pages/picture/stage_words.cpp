// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/setup/setup_section_test.cpp
#include "picture/stage_words.hpp"

#include "os/text_of_list.hpp"
#include "settings/drainage.hpp"
#include "text/quantity_words.hpp"

#include <array>
#include <fmt/format.h>

namespace berm::picture {
namespace {

std::string vertical_words(const settings::StageSettings& stage, int dimension)
{
  if (stage.kind != settings::StageKind::drag) return "";
  if (stage.vertical == settings::Vertical::fixed) return ", w fixed";
  if (stage.loads.drives(settings::LoadAlong::downwards)) return "";
  if (stage.vertical_velocity) return fmt::format(", {} down", text::speed_words(*stage.vertical_velocity));
  if (stage.vertical_force) return fmt::format(", V = {}", text::force_words(*stage.vertical_force, dimension));
  return ", V held";
}

/// "H and V of a load history".
std::string load_words(const settings::LoadSettings& loads)
{
  std::vector<std::string> names;
  for (std::size_t k = 0; k < settings::load_columns.size(); ++k)
    if (!loads.columns[k].empty()) names.emplace_back(settings::load_columns[k].name);
  return names.empty() ? "" : fmt::format("{} of a load history", text_of_list(names, " and "));
}

std::string rate_words(const settings::StageSettings& stage, int dimension)
{
  const std::string words = stage.velocity ? text::speed_words(*stage.velocity)
                            : stage.force  ? text::force_words(*stage.force, dimension)
                                           : "";
  return words + (words.empty() || stage.loads.empty() ? "" : ", ") + load_words(stage.loads);
}

/// "x 10 mm/s, y held, rotation 0.5 rad/s".
std::string freedom_words(const settings::DriveSettings& drive, int dimension)
{
  std::vector<std::string> words;
  const auto add = [&](const char* name, const settings::FreedomSettings& f) {
    if (f.velocity) words.push_back(fmt::format("{} {}", name, text::speed_words(*f.velocity)));
    if (f.force) words.push_back(fmt::format("{} {}", name, text::force_words(*f.force, dimension)));
    if (f.hold) words.push_back(fmt::format("{} held", name));
    if (f.free) words.push_back(fmt::format("{} free", name));
    if (f.spring) words.push_back(fmt::format("{} on a spring of {:.4g} N/m{}", name, *f.spring, dimension == 2 ? "2" : ""));
  };
  const auto add_turn = [&](const char* name, const settings::TurnSettings& f) {
    if (f.velocity) words.push_back(fmt::format("{} {:.4g} rad/s", name, *f.velocity));
    if (f.moment) words.push_back(fmt::format("{} by {:.4g} N{}", name, *f.moment, dimension == 2 ? "" : " m"));
    if (f.fixed) words.push_back(fmt::format("{} fixed", name));
    if (f.free) words.push_back(fmt::format("{} free", name));
    if (f.spring) words.push_back(fmt::format("{} on a spring of {:.4g} N{}/rad", name, *f.spring, dimension == 2 ? "" : " m"));
  };
  add("x", drive.x);
  add("y", drive.y);
  add("z", drive.z);
  if (!drive.point.empty()) words.push_back(fmt::format("at ({}) m", text_of_list(drive.point, ", ", "{:.4g}")));
  add_turn("rotation", drive.rotation);
  add_turn("rotation about x", drive.rotation_x);
  add_turn("rotation about y", drive.rotation_y);
  add_turn("rotation about z", drive.rotation_z);
  return text_of_list(words, ", ");
}

/// Of a stage of kind drive.
std::string drive_kind_words(const settings::StageSettings& stage, int dimension)
{
  const std::string words = freedom_words(stage.drive, dimension), loads = load_words(stage.loads);
  return words + (words.empty() || loads.empty() ? "" : ", ") + loads;
}

/// ", rotation about z on a spring of 3e+05 N m/rad" of a push or a drag.
std::string turn_words(const settings::StageSettings& stage, int dimension)
{
  if (stage.kind != settings::StageKind::push && stage.kind != settings::StageKind::drag) return "";
  const std::string words = freedom_words(stage.drive, dimension);
  return words.empty() ? "" : ", " + words;
}

}  // namespace

std::string motion_words(const boundary::SupportSettings& support)
{
  if (!support.motion) return "";
  std::vector<std::string> axes;
  for (std::size_t d = 0; d < support.motion->velocity.size(); ++d)
    if (!support.motion->velocity[d].empty()) axes.emplace_back(boundary::motion_axes[d]);
  return fmt::format(", {} along {} in {}", support.absorbs ? "waves come in" : "moves", text_of_list(axes, " and "),
                     text_of_list(support.motion->stages, ", "));
}

std::string held_words(const settings::Case& c, const boundary::SupportSettings& support)
{
  std::string words = fmt::format("{} fixed", text_of_list(support.fixed, ", "));
  if (!support.stages.empty()) words += fmt::format(" in {}", text_of_list(support.stages, ", "));
  if (support.absorbs) words += " at rest, then absorbs waves";
  if (settings::has_flowing_water(c)) words += support.drained ? ", drained" : ", no flow";
  return words;
}

std::string until_words(const settings::StageSettings& stage, int dimension, Real scale)
{
  const settings::Until& until = stage.until;
  std::vector<std::string> limits;
  if (until.embedment) limits.push_back("w = " + text::length_words(scale * *until.embedment));
  if (until.displacement) limits.push_back(text::length_words(scale * *until.displacement));
  if (until.force)
    limits.push_back(
        fmt::format("{} = {}", stage.kind == settings::StageKind::drag ? "H" : "V", text::force_words(scale * *until.force, dimension)));
  if (until.consolidation) limits.push_back(fmt::format("U = {:.3g} %", 100 * *until.consolidation));
  if (ends_at_equilibrium(stage)) limits.emplace_back("equilibrium");
  constexpr Real day = 86400;  // s
  if (until.time)
    limits.push_back(text::time_words(*until.time) + (stage.time_scale == 1 ? "" : " of the run") +
                     (until.real_time ? fmt::format(", which are {:.4g} days of the soil", *until.real_time / day) : ""));
  return text_of_list(limits, " or ");
}

/// "to 80 K, 10 MPa", "through temperature and pressure of a load history"; "" where the loads stay.
std::string pipeline_words(const settings::StageSettings& stage)
{
  constexpr Real megapascal = 1e6;
  std::vector<std::string> loads;
  const settings::PipelineLoads& to = stage.pipeline;
  if (to.temperature) loads.push_back(fmt::format("{:.4g} K", *to.temperature));
  if (to.pressure) loads.push_back(fmt::format("{:.4g} MPa", *to.pressure / megapascal));
  if (to.weight) loads.push_back(fmt::format("{:.4g} N/m of weight", *to.weight));
  if (to.lateral) loads.push_back(fmt::format("{:.4g} N/m lateral", *to.lateral));
  if (!stage.loads.empty()) return "through " + load_words(stage.loads);
  return loads.empty() ? "" : fmt::format("to {}", text_of_list(loads, ", "));
}

std::string drive_words(const settings::StageSettings& stage, int dimension)
{
  switch (stage.kind) {
  case settings::StageKind::geostatic:
    return "the soil reaches equilibrium";
  case settings::StageKind::free:
    return "time passes";
  case settings::StageKind::pipeline:
    return pipeline_words(stage).empty() ? "the pipeline rests under its loads" : "the pipeline is brought " + pipeline_words(stage);
  case settings::StageKind::push:
    return rate_words(stage, dimension) + " down" + turn_words(stage, dimension);
  case settings::StageKind::drive:
    return drive_kind_words(stage, dimension);
  case settings::StageKind::drag:
  case settings::StageKind::sweep:
    return rate_words(stage, dimension) + " along x" + vertical_words(stage, dimension) + turn_words(stage, dimension);
  }
  return "";
}

std::string stage_words(const settings::StageSettings& stage, int dimension)
{
  constexpr std::array kinds{"geostatic", "push", "drag", "free", "drive", "sweep", "pipeline"};
  const std::string kind = kinds[static_cast<std::size_t>(stage.kind)];
  // The user's own name says more than the kind only where it is another word.
  const std::string called = stage.name == kind ? kind : fmt::format("{} ({})", kind, stage.name);
  const std::string rate = stage.kind == settings::StageKind::drive      ? drive_kind_words(stage, dimension)
                           : stage.kind == settings::StageKind::pipeline ? pipeline_words(stage)
                                                                         : rate_words(stage, dimension),
                    vertical = vertical_words(stage, dimension) + turn_words(stage, dimension);
  const bool to_a_level = stage.until.embedment.has_value();
  return fmt::format("{}{}{}{}{}", called, rate.empty() ? "" : " " + rate, vertical, to_a_level ? " to " : ", ",
                     until_words(stage, dimension));
}

}  // namespace berm::picture
