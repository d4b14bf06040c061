// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "element/element_settings.hpp"
#include "element/specimen.hpp"

namespace berm::element {

/// A test on its way, step by step. `settings` outlives it.
class Course {
public:
  Course(const TestSettings& settings, const material::Material& material);

  const Specimen& specimen() const { return specimen_; }

  /// One step by an increment of the driven strain, positive in the direction of the test, towards a held stress (Pa, tension positive); false where the law has no
  /// such state: then nothing changed. 0 where the test goes by its stress.
  bool step(Real driven, Real target);

  /// One step undrained towards q = 0, by this share of the q that is left; false where the law has no such state.
  bool unload(Real share);

  /// One step drained, isotropic, towards the mean stress p, by this share of what is left; false where the law has no such state.
  bool consolidate(Real p, Real share);

  /// Where the held stress is, Pa, tension positive; 0 where none is.
  Real held_stress() const;

private:
  /// How a test deforms its specimen. Strains tension positive, as in the engine.
  struct Device {
    /// The strain increment by the driven part (compression positive; in simple shear the engineering shear strain) and the free one (tension positive).
    SymTensor<3> (*strain)(Real driven, Real freed);
    std::optional<Component> held;  ///< the stress that the free strain keeps; none where all strains are prescribed
  };
  static Device device_of(const TestKind& kind);

  /// Takes the strain at which a measure of the stress is the target; the measure grows with x.
  template <class Strain, class Measure>
  bool approach(const Strain& strain, const Measure& measure, Real target);

  const TestSettings& settings_;
  Device device_;
  Real modulus_;
  Specimen specimen_;
  Real ratio_ = 0;  ///< free strain over driven strain of the step before
};

}  // namespace berm::element
