// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <string>
#include <vector>

namespace berm::report {

/// Every `step`th frame, with the first, the last and the last of each stage; `stages` is by frame.
std::vector<Index> kept_frames(const std::vector<std::string>& stages, Index step);

/// "every 2nd frame"; with a step of 1 "".
std::string kept_words(Index step);

}  // namespace berm::report
