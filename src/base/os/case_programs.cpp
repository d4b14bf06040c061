// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_sandbox_test.cpp
#include "os/case_programs.hpp"

#include <utility>

namespace berm {
namespace {

CaseProgramRules& rules()
{
  static CaseProgramRules all;
  return all;
}

}  // namespace

void set_case_program_rules(CaseProgramRules given)
{
  rules() = std::move(given);
}

std::vector<std::string> contained(const std::vector<std::string>& words, const std::string& folder)
{
  return rules().contained ? rules().contained(words, folder) : words;
}

void ask_to_load(const std::string& library)
{
  if (rules().ask_to_load) rules().ask_to_load(library);
}

}  // namespace berm
