// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"

namespace berm::settings {

/// The columns (of load_columns) that the load history of a stage may have, by its kind and the geometry.
std::vector<std::size_t> columns_for(const Case& c, const StageSettings& stage);

/// What is wrong with a row of the load history of a stage beside the rows before it: the key below the stage, and the message.
struct RowFault {
  std::string key, message;
};
std::optional<RowFault> fault_of_row(const StageSettings& stage, std::size_t row);

/// What is wrong with the load history of a stage, of which no file is left to read: "KEY: MESSAGE" with the key below the stage ("" = the stage itself); "" where
/// nothing is.
std::string fault_of_loads(const Case& c, const StageSettings& stage);

}  // namespace berm::settings
