// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/option_values_test.cpp
// What values an option takes, said in the words in which the input files say it.
#pragma once

#include "core/describe.hpp"

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace berm::commands {

/// A number, whole where the option's is, from one to another: "50 is not allowed: from 5 to 30".
CLI::Validator number_within(const Range& range);
CLI::Validator whole_number_within(int least, int most);

/// One of some words: "kulhawy" is not known; did you mean "kulhawy-mayne"?
CLI::Validator one_of(const std::vector<std::string>& words);

/// Help with the values that an option takes, <a number from 5 to 30> or {quick,normal,fine}, and what it cannot be combined with.
class Help : public CLI::Formatter {
public:
  std::string make_option_opts(const CLI::Option* option) const override;
};

/// What the parser of the command line says, as other messages say it: "--resume: cannot be combined with --set".
std::string in_words(const CLI::ParseError& error);

}  // namespace berm::commands
