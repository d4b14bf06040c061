// SPDX-License-Identifier: BSD-3-Clause
#include "element/run_test.hpp"

#include "element/course.hpp"
#include "material/principal_axes.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::element {
namespace {

std::string words_of_failure(const TestRecord& record)
{
  const Real strain = driven_strain(record.settings, record.rows.back());
  const bool shears = std::holds_alternative<SimpleShear>(record.settings.kind);
  return fmt::format("the specimen failed at {} strain {:.4g} %: beyond it the law has no state at the prescribed stress",
                     shears ? "shear" : "axial", 100 * strain);
}

}  // namespace

TestRecord run_test(const TestSettings& settings, const material::Material& material)
{
  TestRecord record{settings, material, {}, ""};
  Course course(settings, material);
  const auto note = [&](int leg) {
    const Specimen& specimen = course.specimen();
    record.rows.push_back({leg, specimen.time(), specimen.strain(), specimen.stress(), specimen.state()});
  };
  note(0);
  const bool by_stress = !stress_path_of(settings.kind).empty();
  const std::vector<Real>& points = by_stress ? stress_path_of(settings.kind) : settings.strain_path;
  const Real kept = course.held_stress();
  Real from = by_stress ? start_of(settings.kind).vertical() : 0;
  int leg = 0;
  for (int cycle = 0; cycle < settings.cycles; ++cycle) {
    if (cycle > 0 && reconsolidated(settings.kind)) {
      const Real pressure = start_of(settings.kind).vertical();
      for (int phase = 0; phase < 2; ++phase)
        for (int left = settings.steps; left > 0; --left) {
          if (phase == 0 ? !course.unload(Real(1) / left) : !course.consolidate(pressure, Real(1) / left)) {
            record.failure = words_of_failure(record);
            return record;
          }
          note(leg);
        }
      from = 0;
      ++leg;
    }
    for (const Real to : points) {
      for (int n = 1; n <= settings.steps && to != from; ++n) {
        const Real way = (to - from) / settings.steps;
        if (by_stress ? !course.step(0, -(from + n * way)) : !course.step(way, kept)) {
          record.failure = words_of_failure(record);
          return record;
        }
        note(leg);
      }
      from = to;
      ++leg;
    }
  }
  return record;
}

int legs_of_cycle(const TestSettings& settings)
{
  const std::vector<Real>& by_stress = stress_path_of(settings.kind);
  const std::size_t points = by_stress.empty() ? settings.strain_path.size() : by_stress.size();
  return int(points) + (reconsolidated(settings.kind) ? 1 : 0);
}

Real driven_strain(const TestSettings& settings, const TestRow& row)
{
  return std::holds_alternative<SimpleShear>(settings.kind) ? 2 * row.strain[shear]
                                                            : 0 - sense(settings.kind) * row.strain[vertical];  // no -0
}

Real volumetric_strain(const TestRow& row)
{
  return 0 - trace(row.strain);
}

Real vertical_stress(const TestRow& row)
{
  return -row.stress[vertical];
}

Real lateral_stress(const TestRow& row)
{
  return -row.stress[lateral];
}

Real shear_stress(const TestRow& row)
{
  return row.stress[shear];
}

Real mean_stress(const TestRow& row)
{
  return -trace(row.stress) / 3;
}

Real deviator_stress(const TestRow& row)
{
  return vertical_stress(row) - lateral_stress(row);
}

Real middle_stress(const TestRow& row)
{
  const auto axes = material::principal_axes(row.stress);
  return -(axes.value[0] + axes.value[2]) / 2;
}

Real max_shear_stress(const TestRow& row)
{
  const auto axes = material::principal_axes(row.stress);
  return (axes.value[0] - axes.value[2]) / 2;
}

Real mobilised_friction_angle(const TestRow& row)
{
  const Real s = middle_stress(row);
  return s > 0 ? std::asin(std::min(Real(1), max_shear_stress(row) / s)) : 0;
}

std::optional<Real> strength(const TestRecord& record, const TestRow& row)
{
  return material::shear_strength(record.material, -middle_stress(row), row.state.data());
}

std::optional<Real> excess_pore_pressure(const TestRecord& record, const TestRow& row)
{
  if (drained(record.settings.kind) || !shows_effective_stress(record)) return {};
  const int held = std::holds_alternative<SimpleShear>(record.settings.kind) ? vertical : lateral;
  return row.stress[held] - record.rows.front().stress[held];
}

bool shows_effective_stress(const TestRecord& record)
{
  return !knows_total_stress_alone(record.material);
}

}  // namespace berm::element
