// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/shown.hpp"

namespace berm {

/// What a run's pipe did and met, in a few sentences, HTML without the run's name.
std::string results_in_words(const RunRecord& run, const Shown& shown);

}  // namespace berm
