// SPDX-License-Identifier: BSD-3-Clause
#include "element/run_test.hpp"

#include "element/specimen.hpp"
#include "material/principal_axes.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::element {
namespace {

enum Component { lateral, vertical, out_of_plane, shear };

/// How a test deforms its specimen. Strains tension positive, as in the engine.
struct Device {
  /// The strain increment by the prescribed part (compression positive; in simple shear the engineering shear strain) and the free one (tension positive).
  SymTensor<3> (*strain)(Real driven, Real freed);
  std::optional<Component> held;  ///< the stress that the free strain keeps; none where all strains are prescribed
};

Device device_of(const Triaxial& kind)
{
  if (kind.drained) return {[](Real a, Real b) { return SymTensor<3>{{b, -a, b}}; }, lateral};
  return {[](Real a, Real) { return SymTensor<3>{{a / 2, -a, a / 2}}; }, {}};
}
Device device_of(const Biaxial& kind)
{
  if (kind.drained) return {[](Real a, Real b) { return SymTensor<3>{{b, -a, 0}}; }, lateral};
  return {[](Real a, Real) { return SymTensor<3>{{a, -a, 0}}; }, {}};
}
Device device_of(const SimpleShear& kind)
{
  if (kind.drained) return {[](Real a, Real b) { return SymTensor<3>{{0, b, 0, a / 2}}; }, vertical};
  return {[](Real a, Real) { return SymTensor<3>{{0, 0, 0, a / 2}}; }, {}};
}
Device device_of(const Oedometer& kind)
{
  if (!kind.stress_path.empty()) return {[](Real, Real b) { return SymTensor<3>{{0, b, 0}}; }, vertical};
  return {[](Real a, Real) { return SymTensor<3>{{0, -a, 0}}; }, {}};
}

Real size_of(const SymTensor<3>& stress)
{
  Real size = 0;
  for (int k = 0; k < tensor_size<3>; ++k) size = std::max(size, std::abs(stress[k]));
  return size;
}

Real sign_of(const TestSettings& settings)
{
  const auto extends = [](const auto& kind) {
    if constexpr (requires { kind.direction; }) return kind.direction == Direction::extension;
    return false;
  };
  return std::visit(extends, settings.kind) ? -1 : 1;
}

/// A test on its way.
class Course {
public:
  Course(const TestSettings& settings, const material::Material& material)
      : settings_(settings),
        device_(std::visit([](const auto& kind) { return device_of(kind); }, settings.kind)),
        modulus_(material::p_wave_modulus(material)),
        specimen_(material, stress_at_start(settings))
  {
  }

  const Specimen& specimen() const { return specimen_; }

  /// One step; false where the law has no state with the stress that is held: then nothing changed. Target: of the held stress, tension positive.
  bool step(Real driven, Real target)
  {
    const auto duration = [&](Real freed) {
      const Real way = driven != 0 ? driven : freed;
      return settings_.strain_rate ? std::abs(way) / *settings_.strain_rate : 0;
    };
    Real freed = 0;
    if (device_.held) {
      const auto excess = [&](Real b) { return specimen_.stress_after(device_.strain(driven, b), duration(b))[*device_.held] - target; };
      const Real change = target - specimen_.stress()[*device_.held], guess = driven != 0 ? ratio_ * driven : change / modulus_;
      constexpr Real share = 0.1, accuracy = 1e-10;
      const Real size = std::max({size_of(specimen_.stress()), std::abs(change), modulus_ * std::abs(driven) * 1e-3});
      const std::optional<Real> found =
          balance(excess, {.guess = guess, .step = share * (std::abs(driven) + std::abs(guess)), .tolerance = accuracy * size});
      if (!found) return false;
      freed = *found;
      if (driven != 0) ratio_ = freed / driven;
    }
    const SymTensor<3> strain = device_.strain(driven, freed);
    if (!std::isfinite(size_of(specimen_.stress_after(strain, duration(freed))))) return false;
    specimen_.deform(strain, duration(freed));
    return true;
  }

  /// One step undrained towards q = 0, by this share of the q that is left; false where the law has no such state.
  bool unload(Real share)
  {
    const auto q = [](const SymTensor<3>& stress) { return stress[lateral] - stress[vertical]; };
    return approach(
        [](Real x) {
          return SymTensor<3>{{-x / 2, x, -x / 2}};
        },
        [&](const SymTensor<3>& stress) { return -q(stress); }, -(1 - share) * q(specimen_.stress()));
  }

  /// One step drained, isotropic, towards the mean stress p, by this share of what is left; false where the law has no such state.
  bool consolidate(Real p, Real share)
  {
    const auto mean = [](const SymTensor<3>& stress) { return trace(stress) / 3; };
    const Real now = mean(specimen_.stress());
    return approach([](Real x) { return SymTensor<3>{{x, x, x}}; }, mean, now + share * (-p - now));
  }

  /// Where the held stress is, tension positive.
  Real held_stress() const { return device_.held ? specimen_.stress()[*device_.held] : 0; }

private:
  /// Takes the strain at which a measure of the stress is the target; the measure grows with x.
  template <class Strain, class Measure>
  bool approach(const Strain& strain, const Measure& measure, Real target)
  {
    const Real change = target - measure(specimen_.stress()), guess = change / modulus_;
    constexpr Real accuracy = 1e-10;
    const std::optional<Real> found =
        balance([&](Real x) { return measure(specimen_.stress_after(strain(x), 0)) - target; },
                {.guess = guess, .step = std::abs(guess), .tolerance = accuracy * size_of(specimen_.stress())});
    if (!found) return false;
    specimen_.deform(strain(*found), 0);
    return true;
  }

  static SymTensor<3> stress_at_start(const TestSettings& settings)
  {
    const StartStress& start = start_of(settings.kind);
    return {{-start.horizontal(), -start.vertical(), -start.horizontal()}};
  }

  const TestSettings& settings_;
  Device device_;
  Real modulus_;
  Specimen specimen_;
  Real ratio_ = 0;  ///< free strain over driven strain of the step before
};

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
  const auto* oedometer = std::get_if<Oedometer>(&settings.kind);
  const bool by_stress = oedometer != nullptr && !oedometer->stress_path.empty();
  const std::vector<Real>& points = by_stress ? oedometer->stress_path : settings.strain_path;
  const Real kept = course.held_stress();
  Real from = by_stress ? oedometer->start.vertical() : 0;
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
        if (by_stress ? !course.step(0, -(from + n * way)) : !course.step(sign_of(settings) * way, kept)) {
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
  const auto* oedometer = std::get_if<Oedometer>(&settings.kind);
  const std::size_t points =
      oedometer != nullptr && !oedometer->stress_path.empty() ? oedometer->stress_path.size() : settings.strain_path.size();
  return int(points) + (reconsolidated(settings.kind) ? 1 : 0);
}

Real driven_strain(const TestSettings& settings, const TestRow& row)
{
  return std::holds_alternative<SimpleShear>(settings.kind) ? 2 * row.strain[shear]
                                                            : 0 - sign_of(settings) * row.strain[vertical];  // no -0
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
