// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "study/estimates.hpp"

namespace berm::study {

/// Draws FOLDER/NAME.png: a bar for each parameter, the widest at the top, from the measure with all at their medians to that with this parameter at its 5 % and 95 % value; below them what
/// the sample spans. Where there are no such runs the bars are rank correlations. False where it could not be drawn (plot::draw), or nothing is known.
bool draw_tornado(const std::filesystem::path& folder, const std::string& name, const StudyPlan& plan, const Estimate& estimate);

/// A number in the unit that suits: "4.2 kPa".
std::string parameter_words(Real value, const AxisParameter& parameter);

}  // namespace berm::study
