// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/tensor.hpp"
#include "element/element_settings.hpp"

namespace berm::element {

/// A specimen at one moment. Tensors as in the engine: tension positive, y upwards.
struct TestRow {
  int leg = 0;    ///< of the path, over all cycles, from 0; a reconsolidation is one more of each cycle (legs_of_cycle)
  Real time = 0;  ///< s; 0 where no rate is defined
  SymTensor<3> strain, stress;
  std::vector<Real> state;
};

/// What came of a test.
struct TestRecord {
  TestSettings settings;
  material::Material material;  ///< at the depth of the specimen
  std::vector<TestRow> rows;    ///< the first is the start
  std::string failure;          ///< why it ended before its end; "": it did not
};

/// Runs a test: strains are prescribed, and the one that is free in a drained test is that at which the stress that is held stays (specimen.hpp). Where the law
/// has no such state the record ends before that step, and says so.
TestRecord run_test(const TestSettings& settings, const material::Material& material);

/// Number of legs of one cycle.
int legs_of_cycle(const TestSettings& settings);

// What a row shows. Compression is positive here, as in a laboratory; stresses in Pa.

/// The strain that is prescribed: axial (in extension tension is positive), in simple shear the engineering shear strain.
Real driven_strain(const TestSettings& settings, const TestRow& row);
Real volumetric_strain(const TestRow& row);
Real vertical_stress(const TestRow& row);
Real lateral_stress(const TestRow& row);
Real shear_stress(const TestRow& row);
/// Mean stress p and deviator stress q = vertical less lateral stress.
Real mean_stress(const TestRow& row);
Real deviator_stress(const TestRow& row);
/// s = (s1 + s3)/2 and t = (s1 - s3)/2 of the largest and the smallest principal stress.
Real middle_stress(const TestRow& row);
Real max_shear_stress(const TestRow& row);
/// asin(t / s), rad; 0 without pressure.
Real mobilised_friction_angle(const TestRow& row);
/// The largest t that the law allows at the row's s and state; empty where it defines none.
std::optional<Real> strength(const TestRecord& record, const TestRow& row);
/// Of an undrained test of a law of effective stresses: the total stress that the device holds (lateral; in simple shear vertical) less the effective one.
/// Empty of the others.
std::optional<Real> excess_pore_pressure(const TestRecord& record, const TestRow& row);
/// Whether the stresses of a test are effective ones.
bool shows_effective_stress(const TestRecord& record);

}  // namespace berm::element
