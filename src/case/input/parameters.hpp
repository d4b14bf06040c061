// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/catalogue.hpp"

namespace berm::input {

/// The parameters of another kind of input than a case.
struct OtherInput {
  std::string heading;  ///< of its keys outside of tables
  Listed keys;
};

/// All parameters of a case, then those of other inputs, as aligned plain text, for `berm params`.
std::string parameter_table(const Listed& of_case, const std::vector<OtherInput>& others = {});

/// The same as Markdown: docs/parameters.md, for `berm params --markdown`.
std::string parameter_page(const Listed& of_case, const std::vector<OtherInput>& others = {});

}  // namespace berm::input
