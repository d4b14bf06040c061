// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "soil_fit/measured.hpp"

namespace berm::soil_fit {

/// What the law makes of a test: a value for each curve and row, as in MeasuredTest::curves; NaN from the row on that it has no state for. Strains from row to row are those of
/// the test, in steps of `largest_step` at most, and so is the stress that its device held.
std::vector<std::vector<Real>> simulate(const MeasuredTest& test, const material::Material& material, Real largest_step);

}  // namespace berm::soil_fit
