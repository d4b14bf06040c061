// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/element/run_test_test.cpp
#include "element/specimen.hpp"

#include "material/laws.hpp"

namespace berm::element {
namespace {

/// The state of a law at the start, under this stress.
std::vector<Real> state_at_start(const material::Material& material, const SymTensor<3>& stress)
{
  std::vector<Real> state(static_cast<std::size_t>(material::state_size(material)), 0.);
  material::initial_state(material, stress, state.data());
  return state;
}

}  // namespace

Specimen::Specimen(const material::Material& material, const SymTensor<3>& stress)
    : law_(std::make_shared<material::PreparedMaterial>(material::prepare(material))),
      stress_(stress),
      state_(state_at_start(material, stress))
{
}

void Specimen::update(SymTensor<3>& stress, const SymTensor<3>& strain, Real dt, std::vector<Real>& state) const
{
  const material::Increment<3, Real> increment{strain, dt, time_};
  std::visit([&](const auto& law) { material::update(law, stress, increment, state.data()); }, *law_);
}

SymTensor<3> Specimen::stress_after(const SymTensor<3>& strain, Real dt) const
{
  SymTensor<3> stress = stress_;
  std::vector<Real> state = state_;
  update(stress, strain, dt, state);
  return stress;
}

void Specimen::deform(const SymTensor<3>& strain, Real dt)
{
  update(stress_, strain, dt, state_);
  for (int k = 0; k < tensor_size<3>; ++k) strain_[k] += strain[k];
  time_ += dt;
}

}  // namespace berm::element
