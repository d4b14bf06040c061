// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_test.cpp
#include "commands/commands.hpp"

#include "commands/command.hpp"
#include "core/error.hpp"
#include "io/atomic_file.hpp"

#include <cstdio>
#include <fmt/format.h>
#include <new>

namespace berm::commands {
namespace {

/// All commands, in the order in which --help lists them.
constexpr Command (*all_commands[])(CLI::App&) = {add_run,    add_check, add_params,   add_bench,
                                                  add_verify, add_study, add_envelope, add_report};

int dispatch(int argc, char** argv)
{
  CLI::App app("berm pushes a pipe or cable into the seabed, drags it sideways, and says how the soil answers.", "berm");
  app.set_version_flag("--version", "berm " BERM_VERSION);
  app.require_subcommand(1);
  std::vector<Command> commands;
  for (const auto add : all_commands) commands.push_back(add(app));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  for (const Command& command : commands)
    if (command.app->parsed()) return command.act();
  return 2;
}

}  // namespace

int run_commands(int argc, char** argv)
{
  try {
    const int status = dispatch(argc, argv);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) io::throw_errno("cannot write to the standard output");
    return status;
  } catch (const InputError& error) {
    fmt::print(stderr, "berm: {}\n", error.what());
    return 2;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "berm: the machine has no more memory for this; berm check CASE prints how much a run needs\n");
    return 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "berm: {}\n", error.what());
    return 1;
  }
}

}  // namespace berm::commands
