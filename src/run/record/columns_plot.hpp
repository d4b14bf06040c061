// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/history.hpp"
#include "run_folder/run_folder.hpp"

namespace berm::record {

/// curves.png of any run: the columns named against time, one panel for each unit. False, with a warning, where it could not be drawn.
bool draw_columns(const run_folder::RunFolder& folder, const run_folder::History& history, const std::vector<std::string>& columns,
                  const std::string& title);

}  // namespace berm::record
