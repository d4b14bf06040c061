// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "element/run_test.hpp"

namespace berm::element {

/// Draws FOLDER/KIND_WHAT.png with the curves of all tests of a kind over one another: stress over strain; the effective stress path with the strength of the
/// law; volumetric strain of drained and excess pore pressure of undrained tests; of oedometers the compression curve over the logarithm of the stress. Gives the
/// names of those that were drawn, without ".png".
std::vector<std::string> draw_figures(const std::vector<TestRecord>& records, const std::filesystem::path& folder);

/// The deviator stress q at which a law yields in the triaxial test at a mean stress p, Pa, compression positive; negative in extension. Empty where the law has
/// no strength of that form.
std::optional<Real> triaxial_strength(const TestRecord& record, Real p, Direction direction);

}  // namespace berm::element
