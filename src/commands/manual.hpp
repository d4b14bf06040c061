// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>

// Manual pages and completion of the command line, from the commands themselves.
namespace berm::commands {

/// A page for each command, berm-run.1 ..., and berm.1, by the names of their files, in the language of man.
std::map<std::string, std::string> manual_pages(const CLI::App& program);

/// Scripts that complete commands, options, words that an option takes, and files.
std::string bash_completion(const CLI::App& program);
std::string zsh_completion(const CLI::App& program);
std::string fish_completion(const CLI::App& program);

}  // namespace berm::commands
