// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_test.cpp
#include "commands/command.hpp"
#include "input/parameters.hpp"

#include <fmt/format.h>

namespace berm::commands {

Command add_params(CLI::App& program)
{
  const auto markdown = std::make_shared<bool>(false);
  CLI::App* app = program.add_subcommand("params", "list all parameters of a case file");
  app->add_flag("--markdown", *markdown, "as Markdown");
  return {app, [markdown] {
            fmt::print("{}", *markdown ? input::parameter_page() : input::parameter_table());
            return 0;
          }};
}

}  // namespace berm::commands
