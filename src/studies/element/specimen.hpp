// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/material.hpp"

#include <memory>

namespace berm::element {

/// A piece of soil of uniform stress: what a law makes of strains. Tensors as in the engine: tension positive, y upwards.
class Specimen {
public:
  Specimen(const material::Material& material, const SymTensor<3>& stress);

  /// The stress after an increment of strain that takes dt, s (0: no rate is defined), without taking it.
  SymTensor<3> stress_after(const SymTensor<3>& strain, Real dt) const;
  /// Takes the increment.
  void deform(const SymTensor<3>& strain, Real dt);

  const SymTensor<3>& stress() const { return stress_; }
  const SymTensor<3>& strain() const { return strain_; }
  const std::vector<Real>& state() const { return state_; }  ///< of the law
  Real time() const { return time_; }                        ///< s

private:
  void update(SymTensor<3>& stress, const SymTensor<3>& strain, Real dt, std::vector<Real>& state) const;

  std::shared_ptr<const material::PreparedMaterial> law_;
  SymTensor<3> stress_, strain_;
  std::vector<Real> state_;
  Real time_ = 0;
};

}  // namespace berm::element
