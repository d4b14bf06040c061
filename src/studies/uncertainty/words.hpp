// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/case.hpp"
#include "run_folder/uncertainty.hpp"

namespace berm::uncertainty {

/// The bands as a table for people: the run's number, the converged one with its half width, and the parts of that; below it what has no band, and why.
std::string words_of(const run_folder::Uncertainty& uncertainty, problem::Method method);

}  // namespace berm::uncertainty
