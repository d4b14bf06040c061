// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "commands/case_options.hpp"
#include "commands/command.hpp"

namespace berm::commands {

/// A command that makes a page of one input in seconds: NAME INPUT [--set KEY=VALUE] [-o FOLDER] [--force].
struct PageCommand {
  const char* name;
  const char* meaning;
  const char* input;  ///< what the input is
  const char* page;   ///< the page's file in the folder

  /// Reads the input and computes, then writes the folder; the text of the input comes with what --set changes as comments. Gives what is printed.
  std::string (*make)(const CaseOptions& options, const std::string& text, const std::filesystem::path& folder);
};

Command add_page_command(CLI::App& program, const PageCommand& command);

}  // namespace berm::commands
