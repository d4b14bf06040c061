// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"
#include "material/material.hpp"

#include <functional>
#include <memory>
#include <optional>

namespace berm::element {

/// Components of a specimen's tensors.
enum Component { lateral, vertical, out_of_plane, shear };

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

/// A strain that is free, and what is looked for.
struct BalanceRequest {
  Real guess = 0;      ///< of the strain
  Real step = 0;       ///< > 0: how far off the guess may be, roughly
  Real limit = 1;      ///< strains beyond +- this are none
  Real tolerance = 0;  ///< Pa
  Real jump = 0;       ///< Pa, the excess that is taken where the stress jumps over its target
};

/// The strain x at which a stress is what it should be: |excess(x)| <= tolerance, excess the stress less its target, Pa, which grows with x near the
/// solution; at a jump |excess(x)| <= jump. From the guess the interval grows until it holds a change of sign; within it Illinois' false position, with bisection where that stays behind
/// (Dahlquist and Bjorck, Numerical Methods, section 6.4). Empty where no strain within the limit gives the stress, and where excess is not finite.
std::optional<Real> balance(const std::function<Real(Real)>& excess, const BalanceRequest& request);

}  // namespace berm::element
