// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace berm::base {

/// A number that the page of a run shows large.
struct HeadlineNumber {
  std::string quantity;     ///< its name in summary.json
  std::string label;        ///< HTML: "Breakout resistance"
  std::string beside = {};  ///< what a design code or a formula gives, HTML: "1.2 kN/m by DNV-RP-F114"
};

/// What the job of a run asks for, the first asked first.
using Headline = std::vector<HeadlineNumber>;

}  // namespace berm::base
