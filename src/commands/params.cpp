// SPDX-License-Identifier: BSD-3-Clause
#include "commands/command.hpp"
#include "element/element_settings.hpp"
#include "input/catalogue.hpp"
#include "structures/structures.hpp"

#include <fmt/format.h>

namespace berm::commands {

Command add_params(CLI::App& program)
{
  const auto markdown = std::make_shared<bool>(false);
  CLI::App* app = program.add_subcommand("params", "list all parameters of a case, and of element tests");
  app->add_flag("--markdown", *markdown, "as Markdown");
  return {app, [markdown] {
            const std::vector<input::OtherInput> others = {
                {"Element tests, the input of berm element (beside the materials, as in a case)", element::element_catalogue()}};
            const input::Listed of_case = structures::case_catalogue();
            fmt::print("{}", *markdown ? input::parameter_page(of_case, others) : input::parameter_table(of_case, others));
            return 0;
          }};
}

}  // namespace berm::commands
