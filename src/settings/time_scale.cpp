// SPDX-License-Identifier: BSD-3-Clause
#include "settings/time_scale.hpp"

#include "bodies/rigid/shape.hpp"
#include "settings/body_soil.hpp"
#include "settings/drainage.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::settings {
namespace {

/// The shortest time between turning points of a column that are a part of its range apart; the whole duration where it has none.
Real half_wave_of(const std::vector<Real>& times, const std::vector<Real>& values)
{
  constexpr Real part = 0.2;
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  const Real swing = part * (*max - *min);
  Real shortest = times.back() - times.front();
  if (!(swing > 0)) return shortest;
  std::size_t turn = 0, extreme = 0;  // the last turning point, and the farthest value behind it
  int direction = 0;
  bool turned = false;  // before the first turning point lies a part of a wave
  for (std::size_t k = 1; k < values.size(); ++k) {
    if (direction == 0) {
      if (std::abs(values[k] - values[0]) >= swing) direction = values[k] > values[0] ? 1 : -1, extreme = k;
    } else if (direction * (values[k] - values[extreme]) >= 0) {
      extreme = k;
    } else if (direction * (values[extreme] - values[k]) >= swing) {
      if (turned && times[extreme] > times[turn]) shortest = std::min(shortest, times[extreme] - times[turn]);  // a jump is no wave
      turned = true;
      turn = extreme;
      extreme = k;
      direction = -direction;
    }
  }
  return shortest;
}

Real width_of_body(const Case& c, const bodies::RigidSettings& rigid)
{
  const Real width = c.dimension() == 2 ? width_of<2>(bodies::make_shape<2>(rigid.shape)) : width_of<3>(bodies::make_shape<3>(rigid.shape));
  return width < infinity ? width : 0;
}

/// The soil that a rigid body touches; null where it touches none.
const bodies::BodySettings* touched_by(const Case& c, const std::string& rigid)
{
  for (const auto& [name, contact] : c.contact)
    if (contact.rigid == rigid)
      for (const auto& [body, settings] : c.body)
        if (body == contact.body) return &settings;
  return nullptr;
}

/// Half wave and largest force of all columns; the force of factors is that of the stage.
struct Record {
  Real half_wave = infinity, force = 0;
};
std::optional<Record> record_of_forces(const StageSettings& stage)
{
  if (stage.load_times.empty() || stage.velocity) return {};
  Record record;
  if (stage.loads.empty()) {
    if (!stage.force) return {};
    return Record{half_wave_of(stage.load_times, stage.load_factors), std::abs(*stage.force) * max_load_factor(stage)};
  }
  for (std::size_t k = 0; k < load_columns.size(); ++k) {
    const std::vector<Real>& column = stage.loads.columns[k];
    if (column.empty()) continue;
    if (load_columns[k].quantity != LoadQuantity::force) return {};
    record.half_wave = std::min(record.half_wave, half_wave_of(stage.load_times, column));
    if (load_columns[k].along <= LoadAlong::z) record.force = std::max(record.force, max_load(stage, k));
  }
  return record;
}

Real rounded_up_to_two_digits(Real value)
{
  const Real unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::ceil(value / unit - 1e-9) * unit;
}

}  // namespace

std::optional<TimeScale> time_scale_of(const Case& c, const StageSettings& stage)
{
  constexpr Real part_of_width = 0.1, part_of_force = 0.03, crossings = 20;
  const std::optional<Record> record = record_of_forces(stage);
  if (!record || !(record->half_wave > 0) || c.rigid.empty()) return {};
  const auto& [name, rigid] = c.rigid[stage.rigid.empty() ? 0 : index_of(c.rigid, stage.rigid)];
  const bodies::BodySettings* body = touched_by(c, name);
  const Real width = width_of_body(c, rigid), way = part_of_width * width;
  if (body == nullptr || !(width > 0)) return {};
  Real gravity = 0;
  for (const Real g : c.gravity) gravity = std::hypot(gravity, g);
  const BodySoil soil = soil_of(c, *body);
  const material::Material there = soil.at("", width);
  const Real strength = strength_under(there, 0, gravity * soil.mass_above("", width)).value_or(0), density = inertia_density(there);

  TimeScale found{.half_wave = record->half_wave};
  const auto ask = [&](Real time, TimeScale::Reason reason) {
    if (time > found.shortest) found.shortest = time, found.reason = reason;
  };
  if (strength > 0) ask(way / std::sqrt(small_inertia * strength / density), TimeScale::Reason::soil);
  if (record->force > 0) ask(std::sqrt(4 * rigid.mass * way / (part_of_force * record->force)), TimeScale::Reason::mass);
  ask(crossings * width / waves_of(there).fastest, TimeScale::Reason::waves);
  found.scale = std::min(Real(1), rounded_up_to_two_digits(found.shortest / found.half_wave));
  return found;
}

std::string time_scale_words(const StageSettings& stage)
{
  const Real record = stage.load_times.back();
  return fmt::format("a record of {:.4g} s in {:.4g} s of the run, time_scale = {:.3g}", record, stage.time_scale * record,
                     stage.time_scale);
}

const char* words_of(TimeScale::Reason reason)
{
  switch (reason) {
  case TimeScale::Reason::soil:
    return "the inertia of the soil";
  case TimeScale::Reason::mass:
    return "the inertia of the body";
  case TimeScale::Reason::waves:
    return "the travel time of waves across the body";
  }
  return "";
}

}  // namespace berm::settings
