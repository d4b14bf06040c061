// SPDX-License-Identifier: BSD-3-Clause
#include "samples/program.hpp"

#include <fstream>
#include <gtest/gtest.h>

namespace berm::commands::this_file {
namespace {

TEST(Params, have_the_keys_of_a_case_and_of_element_tests)
{
  const std::string table = run_program(BERM_SOURCE_DIR, {"params"}).out;
  for (const char* part :
       {"[[stage]]", "[material.NAME]", "Element tests", "[[test]]", "materials_from", "with kind = \"oedometer\":", "stress_path"})
    EXPECT_NE(table.find(part), std::string::npos) << part;
}

TEST(Params, page_in_the_manual_is_up_to_date)
{
  std::ifstream file(std::filesystem::path(BERM_SOURCE_DIR) / "docs" / "parameters.md");
  std::stringstream page(run_program(BERM_SOURCE_DIR, {"params", "--markdown"}).out);
  std::string in_manual, declared;
  for (int line = 1; std::getline(page, declared); ++line) {
    std::getline(file, in_manual);
    ASSERT_EQ(in_manual, declared) << "at line " << line << "; write it again: berm params --markdown > docs/parameters.md";
  }
  EXPECT_FALSE(std::getline(file, in_manual)) << "docs/parameters.md has lines that are no longer written";
}

}  // namespace
}  // namespace berm::commands::this_file
