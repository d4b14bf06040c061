// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace berm {

// Programs that a case brings: a geometry that gmsh runs, a library with a law. Whoever starts one asks here, and nobody starts one elsewhere. Where the engine is a part of another
// program nothing is set, and they have that program's rights.

/// What this program lets them do.
struct CaseProgramRules {
  /// The words that start such a program so that it writes below the folder only (an absolute path).
  std::function<std::vector<std::string>(const std::vector<std::string>& words, const std::string& folder)> contained;
  /// Throws where the library must not become a part of this program.
  std::function<void(const std::string& library)> ask_to_load;
};

void set_case_program_rules(CaseProgramRules rules);

/// The exit status of a contained program that was kept from something; the last line of its messages says from what.
constexpr int stopped_status = 77;

/// The words as the rules have them; the same words where there are none.
std::vector<std::string> contained(const std::vector<std::string>& words, const std::string& folder);

/// Throws where the rules do not let the library become a part of this program.
void ask_to_load(const std::string& library);

}  // namespace berm
