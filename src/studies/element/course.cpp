// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/element/run_test_test.cpp
#include "element/course.hpp"

#include <algorithm>

namespace berm::element {
namespace {

constexpr Real accuracy = 1e-10;  // of the stress that is held
constexpr Real jump = 1e-3;       // of laws that divide an increment, where the number of its pieces changes

Real size_of(const SymTensor<3>& stress)
{
  Real size = 0;
  for (int k = 0; k < tensor_size<3>; ++k) size = std::max(size, std::abs(stress[k]));
  return size;
}

SymTensor<3> stress_at_start(const TestSettings& settings)
{
  const StartStress& start = start_of(settings.kind);
  return {{-start.horizontal(), -start.vertical(), -start.horizontal()}};
}

}  // namespace

Course::Device Course::device_of(const TestKind& kind)
{
  if (const auto* triaxial = std::get_if<Triaxial>(&kind)) {
    if (triaxial->drained) return {[](Real a, Real b) { return SymTensor<3>{{b, -a, b}}; }, lateral};
    return {[](Real a, Real) { return SymTensor<3>{{a / 2, -a, a / 2}}; }, {}};
  }
  if (const auto* biaxial = std::get_if<Biaxial>(&kind)) {
    if (biaxial->drained) return {[](Real a, Real b) { return SymTensor<3>{{b, -a, 0}}; }, lateral};
    return {[](Real a, Real) { return SymTensor<3>{{a, -a, 0}}; }, {}};
  }
  if (const auto* simple = std::get_if<SimpleShear>(&kind)) {
    if (simple->drained) return {[](Real a, Real b) { return SymTensor<3>{{0, b, 0, a / 2}}; }, vertical};
    return {[](Real a, Real) { return SymTensor<3>{{0, 0, 0, a / 2}}; }, {}};
  }
  if (std::holds_alternative<Isotropic>(kind)) return {[](Real, Real b) { return SymTensor<3>{{b, b, b}}; }, vertical};
  if (!std::get<Oedometer>(kind).stress_path.empty()) return {[](Real, Real b) { return SymTensor<3>{{0, b, 0}}; }, vertical};
  return {[](Real a, Real) { return SymTensor<3>{{0, -a, 0}}; }, {}};
}

Course::Course(const TestSettings& settings, const material::Material& material)
    : settings_(settings),
      device_(device_of(settings.kind)),
      modulus_(material::p_wave_modulus(material)),
      specimen_(material, stress_at_start(settings))
{
}

Real Course::held_stress() const
{
  return device_.held ? specimen_.stress()[*device_.held] : 0;
}

bool Course::step(Real along, Real target)
{
  const Real driven = sense(settings_.kind) * along;
  const auto duration = [&](Real freed) {
    const Real way = driven != 0 ? driven : freed;
    return settings_.strain_rate ? std::abs(way) / *settings_.strain_rate : 0;
  };
  Real freed = 0;
  if (device_.held) {
    const auto excess = [&](Real b) { return specimen_.stress_after(device_.strain(driven, b), duration(b))[*device_.held] - target; };
    const Real change = target - specimen_.stress()[*device_.held], guess = driven != 0 ? ratio_ * driven : change / modulus_;
    constexpr Real share = 0.1;
    const Real size = std::max({size_of(specimen_.stress()), std::abs(change), modulus_ * std::abs(driven) * 1e-3});
    const std::optional<Real> found = balance(
        excess, {.guess = guess, .step = share * (std::abs(driven) + std::abs(guess)), .tolerance = accuracy * size, .jump = jump * size});
    if (!found) return false;
    freed = *found;
    if (driven != 0) ratio_ = freed / driven;
  }
  const SymTensor<3> strain = device_.strain(driven, freed);
  if (!device_.held && !std::isfinite(size_of(specimen_.stress_after(strain, duration(freed))))) return false;
  specimen_.deform(strain, duration(freed));
  return true;
}

template <class Strain, class Measure>
bool Course::approach(const Strain& strain, const Measure& measure, Real target)
{
  const Real change = target - measure(specimen_.stress()), guess = change / modulus_;
  const std::optional<Real> found = balance([&](Real x) { return measure(specimen_.stress_after(strain(x), 0)) - target; },
                                            {.guess = guess,
                                             .step = std::abs(guess),
                                             .tolerance = accuracy * size_of(specimen_.stress()),
                                             .jump = jump * size_of(specimen_.stress())});
  if (!found) return false;
  specimen_.deform(strain(*found), 0);
  return true;
}

bool Course::unload(Real share)
{
  const auto q = [](const SymTensor<3>& stress) { return stress[lateral] - stress[vertical]; };
  return approach(
      [](Real x) {
        return SymTensor<3>{{-x / 2, x, -x / 2}};
      },
      [&](const SymTensor<3>& stress) { return -q(stress); }, -(1 - share) * q(specimen_.stress()));
}

bool Course::consolidate(Real p, Real share)
{
  const auto mean = [](const SymTensor<3>& stress) { return trace(stress) / 3; };
  const Real now = mean(specimen_.stress());
  return approach([](Real x) { return SymTensor<3>{{x, x, x}}; }, mean, now + share * (-p - now));
}

}  // namespace berm::element
