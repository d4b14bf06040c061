// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/pipe/display_units.hpp"

namespace berm::report {

/// What a run's pipe did and met, in a few sentences, HTML without the run's name.
std::string results_in_words(const pipe::RunRecord& run, const pipe::DisplayUnits& shown);

/// Which of the measures of trust are bad, in a sentence with a link to them, HTML; "" where none is.
std::string doubts_in_words(const pipe::RunRecord& run);

}  // namespace berm::report
