// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "expectations/expectation.hpp"

namespace berm::verification {

using expectations::Chapter;
using expectations::Expectation;
using expectations::VerificationRun;

/// An example of the verification book, or the part of it that was asked for.
struct Example {
  std::string name;
  std::filesystem::path folder;
  Chapter chapter = Chapter::other;
  std::vector<std::pair<std::string, VerificationRun>> runs;  ///< its problems: a problem is named NAME/RUN
  std::vector<Expectation> expectations;                      ///< those whose runs are all here
};

/// Which problems are wanted.
struct ProblemChoice {
  std::vector<std::string> names;  ///< examples, problems (EXAMPLE/RUN) or folders that hold an expected.toml; none = all
  std::filesystem::path examples = "examples";
  std::string chapter;     ///< one of expectations::chapter_words; "" = all
  bool fast = false;       ///< fast ones only
  bool with_long = false;  ///< long ones, too, where they are not named
};

/// Reads the expected.toml of what is wanted, by chapter. Throws InputError where a file is wrong, where there is no such problem or chapter (with the nearest
/// name), and where nothing is left.
std::vector<Example> find_problems(const ProblemChoice& choice);

}  // namespace berm::verification
