// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <string>

namespace berm::commands {

/// A command of the program: its part of the command line, and what it does once that is read.
struct Command {
  CLI::App* app;
  std::function<int()> act;  ///< gives the exit status; throws InputError and RunError
};

/// Each adds its name, its options and their meaning to the program.
Command add_new(CLI::App& program);
Command add_draw(CLI::App& program);
Command add_run(CLI::App& program);
Command add_check(CLI::App& program);
Command add_report(CLI::App& program);
Command add_export(CLI::App& program);
Command add_fmu(CLI::App& program);
Command add_macro_element(CLI::App& program);
Command add_study(CLI::App& program);
Command add_envelope(CLI::App& program);
Command add_safety(CLI::App& program);
Command add_element(CLI::App& program);
Command add_fit(CLI::App& program);
Command add_cyclic(CLI::App& program);
Command add_cpt(CLI::App& program);
Command add_sea(CLI::App& program);
Command add_route(CLI::App& program);
Command add_desk(CLI::App& program);
Command add_verify(CLI::App& program);
Command add_params(CLI::App& program);
Command add_completion(CLI::App& program);
Command add_man(CLI::App& program);

// Manual pages and completion of the command line, from the commands themselves.

/// A page for each command, berm-run.1 ..., and berm.1, by the names of their files, in the language of man.
std::map<std::string, std::string> manual_pages(const CLI::App& program);

/// Scripts that complete commands, options, words that an option takes, and files.
std::string bash_completion(const CLI::App& program);
std::string zsh_completion(const CLI::App& program);
std::string fish_completion(const CLI::App& program);

}  // namespace berm::commands
