// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/site/pore_pressure_test.cpp
#pragma once

#include "site/sounding.hpp"

namespace berm::site {

/// Makes the pore pressures u_2 of a sounding those from the seabed on: takes off that of the water above it where they hold it, and makes NaN of single ones that no soil has; notes
/// both. q_c and u_2 are NaN where a row has none. Throws InputError where most are no pore pressures of soil.
void make_plausible(const std::string& file, const std::vector<Real>& depth, const std::vector<Real>& q_c, Real area_ratio,
                    std::vector<Real>& u_2, std::vector<std::string>& notes);

/// What to say of q_t as a file has it where its u_2, and so its q_t, holds the pressure of the water above the seabed; "" where it does not.
std::string doubt_of_given(const std::vector<Real>& depth, const std::vector<Real>& q_c, const std::vector<Real>& q_t,
                           const std::vector<Real>& u_2);

}  // namespace berm::site
