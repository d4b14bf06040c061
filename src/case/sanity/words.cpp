// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "sanity/words.hpp"

#include "problem/drainage.hpp"

#include <fmt/format.h>

namespace berm::sanity {

std::string words_of(Real value, const char* unit)
{
  const bool small = std::abs(value) < 0.1 && value != 0;
  if (small && (std::string(unit) == "m" || std::string(unit) == "s" || std::string(unit) == "m/s"))
    return fmt::format("{:.3g} m{}", 1000 * value, unit);
  return fmt::format("{:.3g} {}", value, unit);
}

std::string place_words(Real metres)
{
  const bool far = std::abs(metres) >= 1000;
  return fmt::format("{:.{}g} m", metres, far ? 4 + static_cast<int>(std::log10(std::abs(metres))) : 4);
}

std::string stage_key(std::size_t stage, const std::string& key)
{
  return fmt::format("stage[{}]{}{}", stage, key.empty() ? "" : ".", key);
}

Real rounded_down(Real value)
{
  const Real ten = std::pow(10, std::floor(std::log10(value) + 1e-12));
  return std::floor(value / ten + 1e-9) * ten;
}

Real rounded_up(Real value)
{
  const Real ten = std::pow(10, std::floor(std::log10(value) + 1e-12));
  return std::ceil(value / ten - 1e-9) * ten;
}

Real unit_weight_of(const Scene& s, Index body)
{
  return density(s.material_of(body)) * s.gravity;
}

std::optional<Real> strength_at_depth_of(const Scene& s, Index body, Real width)
{
  return problem::strength_under(s.material_at(body, width), width, s.weight_above(body, width));
}

std::string strength_key(const material::Material& material)
{
  const std::vector<FieldInfo> own = local_fields(material);
  return own.size() > 1 ? own.front().name : "cohesion";
}

bool is_by_force(const problem::StageSettings& stage)
{
  using problem::StageKind;
  const problem::DriveSettings& d = stage.drive;
  if (stage.kind == StageKind::drive) return d.x.force || d.y.force || d.z.force || d.x.hold || d.y.hold || d.z.hold;
  const bool holds = stage.kind == StageKind::drag && stage.vertical == problem::Vertical::hold && !stage.vertical_velocity;
  return drives(stage.kind) && (stage.force || holds);
}

}  // namespace berm::sanity
