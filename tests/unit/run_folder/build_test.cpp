// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/build.hpp"

#include <gtest/gtest.h>

namespace berm::run_folder::this_file {
namespace {

RunSummary summary_of_this()
{
  RunSummary summary;
  summary.text["version"] = BERM_VERSION;
  for (const auto& [name, words] : this_build()) summary.text[name] = words;
  return summary;
}

bool fits_with(const char* entry, const std::string& words, settings::Method method)
{
  RunSummary summary = summary_of_this();
  summary.text[entry] = words;
  return by_this_build(summary, method);
}

TEST(Build, knows_a_summary_of_its_own_by_version_and_build_ids)
{
  for (const settings::Method method : {settings::Method::mpm, settings::Method::fem}) {
    EXPECT_TRUE(by_this_build(summary_of_this(), method));
    EXPECT_FALSE(by_this_build({}, method)) << "of an earlier version, which said less";
    EXPECT_FALSE(fits_with("version", "0.0.1", method));
    EXPECT_FALSE(fits_with("engine_build", "0123456789abcdef", method));
    EXPECT_FALSE(fits_with("engine_build", "", method));
    EXPECT_FALSE(fits_with("vector_unit", "x86-64-v9", method)) << "there is no such engine";
    EXPECT_FALSE(fits_with("vector_unit", "../../bin", method));
  }
}

// The material point method is in the engine alone.
TEST(Build, of_the_executable_matters_to_finite_elements_alone)
{
  EXPECT_TRUE(fits_with("program_build", "0123456789abcdef", settings::Method::mpm));
  EXPECT_FALSE(fits_with("program_build", "0123456789abcdef", settings::Method::fem));
}

}  // namespace
}  // namespace berm::run_folder::this_file
