// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/hypoplastic.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace berm::material {

/// The equations of the law as they are printed, on full tensors, by Euler's method with small steps: slow, and written apart from the law. Tension positive.
struct HypoplasticReference {
  using Tensor = Eigen::Matrix3d;

  Hypoplastic law;
  Tensor stress;
  Real void_ratio;
  Tensor grains = Tensor::Zero();

  static Real dot(const Tensor& a, const Tensor& b) { return (a.array() * b.array()).sum(); }

  Real a() const
  {
    const Real sine = std::sin(law.critical_friction_angle);
    return std::sqrt(3.) * (3 - sine) / (2 * std::sqrt(2.) * sine);
  }
  Real shrink() const { return std::exp(-std::pow(-stress.trace() / law.granular_hardness, law.hardness_exponent)); }
  Tensor ratio() const { return stress / stress.trace(); }
  Tensor ratio_deviator() const { return ratio() - Tensor::Identity() / 3; }
  Real strength_factor() const
  {
    const Tensor s = ratio_deviator();
    const Real tangent = std::sqrt(3.) * s.norm();
    const Real lode = s.norm() < 1e-12 ? 1 : -std::sqrt(6.) * (s * s * s).trace() / std::pow(s.norm(), 3);
    return std::sqrt(tangent * tangent / 8 + (2 - tangent * tangent) / (2 + std::sqrt(2.) * tangent * lode)) -
           tangent / (2 * std::sqrt(2.));
  }
  Real density_factor() const
  {
    const Real s = shrink(), dense = law.min_void_ratio * s, critical = law.critical_void_ratio * s;
    return std::pow((void_ratio - dense) / (critical - dense), law.dilatancy_exponent);
  }
  Real stiffness_factor() const
  {
    const Real s = shrink(), n = law.hardness_exponent, beta = law.stiffness_exponent, loose = law.max_void_ratio * s;
    const Real densest = (law.max_void_ratio - law.min_void_ratio) / (law.critical_void_ratio - law.min_void_ratio);
    const Real barotropy = law.granular_hardness / n * std::pow(law.max_void_ratio / law.critical_void_ratio, beta) * (1 + loose) / loose *
                           std::pow(-stress.trace() / law.granular_hardness, 1 - n) /
                           (3 + a() * a() - a() * std::sqrt(3.) * std::pow(densest, law.dilatancy_exponent));
    return barotropy * std::pow(law.critical_void_ratio * s / void_ratio, beta) / dot(ratio(), ratio());
  }
  Tensor linear(const Tensor& strain) const
  {
    const Real f = strength_factor();
    return stiffness_factor() * (f * f * strain + a() * a() * dot(ratio(), strain) * ratio());
  }
  Tensor nonlinear() const { return stiffness_factor() * density_factor() * strength_factor() * a() * (ratio() + ratio_deviator()); }
  Tensor rate(const Tensor& strain) const
  {
    if (law.small_strain == 0) return linear(strain) + nonlinear() * strain.norm();
    const Real size = grains.norm(), mobilised = size / law.small_strain, w = std::pow(mobilised, law.decay_exponent);
    const Tensor direction = size > 0 ? Tensor(grains / size) : Tensor::Zero();
    const Real along = dot(direction, strain);
    const Tensor stiff = (w * law.turn_stiffness + (1 - w) * law.reversal_stiffness) * linear(strain);
    if (along > 0) return stiff + w * (1 - law.turn_stiffness) * along * linear(direction) + w * along * nonlinear();
    return stiff + w * (law.reversal_stiffness - law.turn_stiffness) * along * linear(direction);
  }
  /// A strain in `steps` steps.
  void strain(const Tensor& total, int steps)
  {
    const Tensor part = total / steps;
    for (int k = 0; k < steps; ++k) {
      const Tensor change = rate(part);
      if (law.small_strain > 0) {
        const Real size = grains.norm();
        const Tensor direction = size > 0 ? Tensor(grains / size) : Tensor::Zero();
        const Real along = dot(direction, part);
        grains +=
            part - (along > 0 ? Tensor(direction * along * std::pow(size / law.small_strain, law.evolution_exponent)) : Tensor::Zero());
        if (grains.norm() > law.small_strain) grains *= law.small_strain / grains.norm();
      }
      void_ratio += (1 + void_ratio) * part.trace();
      stress += change;
    }
  }
};

inline Eigen::Matrix3d full(const SymTensor<3>& s)
{
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = s[tensor_index(i, j)];
  return m;
}

}  // namespace berm::material
