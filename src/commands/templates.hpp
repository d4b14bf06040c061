// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/new_test.cpp
#pragma once

#include <string>
#include <vector>

namespace berm::commands {

/// A case that `berm new` writes: its kind, as the command takes it, and the text of the file.
struct CaseTemplate {
  std::string kind, text;
};

/// Those of examples/start, by name.
const std::vector<CaseTemplate>& case_templates();

}  // namespace berm::commands
