// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/soil_fit/measured_test.cpp
#pragma once

#include "soil_fit/fit_settings.hpp"

namespace berm::soil_fit {

/// What is compared between a test and the law. Compression is positive; SI.
enum class Compared { q, tau, p, vertical_stress, volumetric_strain, axial_strain, resistance };

/// "p'", "volumetric strain"; and as a part of names: "p", "volumetric_strain".
const char* name_of(Compared what);
const char* word_of(Compared what);
bool is_strain(Compared what);

/// What a test was found to do, over its rows.
struct MeasuredCurve {
  Compared what;
  std::vector<Real> values;  ///< NaN where it was not measured
};

/// Where and with what a penetrometer passed through clay again and again.
struct Passages {
  std::string tool;  ///< its word in the input
  Penetrometer settings;
  Real depth = 0, top = 0, bottom = 0;  ///< m, below the seabed: middle of the interval, whose middle third counts, and its ends
};

/// A test in a file. Strains are natural and from its first row on. The rows of a penetrometer are its passages, the first penetration being 1, the first extraction 2.
struct MeasuredTest {
  std::string name;
  std::optional<Passages> passages;  ///< of a penetrometer, whose settings but the strain rate mean nothing
  element::TestSettings settings;    ///< without a path
  Values specimen;                   ///< keys of the material of this specimen alone
  bool held_out = false;
  Real weight = 1;
  std::vector<Real>
      driven;  ///< strain in the direction of the test; of a test by its stress that stress, Pa; of a penetrometer the number of the passage
  std::vector<Real> held;  ///< stress that the device held, Pa; empty: that of the start
  std::vector<MeasuredCurve> curves;

  std::size_t rows() const { return driven.size(); }
  bool by_stress() const { return element::is_compression(settings.kind); }
};

/// The tests of all files. Throws InputError with file and line where a file is wrong, and where numbers cannot be those of such a test.
std::vector<MeasuredTest> read_measured(const FitCase& c);

/// A natural strain, compression positive, as the length that was lost over that at the start.
Real engineering_strain(Real natural);
/// What drives a test as a laboratory gives it: a stress in Pa, a shear strain, or an axial strain over the length at the start, in extension positive.
Real as_measured(const MeasuredTest& test, Real driven);

}  // namespace berm::soil_fit
