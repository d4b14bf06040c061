// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/start/kinds_test.cpp
#pragma once

#include <string>
#include <vector>

namespace berm::start {

/// A case of examples/start: the name of its file, with - for _, and its text.
struct CaseTemplate {
  std::string kind, text;
};

/// Those of examples/start, by name.
const std::vector<CaseTemplate>& case_templates();

}  // namespace berm::start
