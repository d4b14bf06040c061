// SPDX-License-Identifier: BSD-3-Clause
#include "commands/command.hpp"
#include "commands/option_values.hpp"
#include "element/element_settings.hpp"
#include "expectations/expectation.hpp"
#include "input/catalogue.hpp"
#include "input/structure_words.hpp"
#include "study/study_settings.hpp"

#include <fmt/format.h>

namespace berm::commands {
namespace {

struct Schema {
  const char *word, *title;
  input::Listed (*catalogue)();
};

constexpr Schema schemas[] = {{"case", "A case of berm", input::case_catalogue},
                              {"element", "Element tests of berm", element::element_catalogue},
                              {"study", "A study of berm", study::study_catalogue},
                              {"expected", "Numbers that runs of berm are expected to give", expectations::expected_catalogue}};

int print_schema(const std::string& of)
{
  for (const auto& [word, title, catalogue] : schemas)
    if (word == of) fmt::print("{}", input::json_schema(catalogue(), title));
  return 0;
}

int print_list(bool markdown)
{
  input::Listed of_elements = element::element_catalogue();
  std::erase_if(of_elements.children, [](const input::Listed& entry) { return entry.key == "material"; });  // listed with the case
  const std::vector<input::OtherInput> others = {
      {"Element tests, the input of berm element (beside the materials, as in a case)", of_elements}};
  const input::Listed of_case = input::case_catalogue();
  fmt::print("{}", markdown ? input::parameter_page(of_case, others) : input::parameter_table(of_case, others));
  return 0;
}

}  // namespace

Command add_params(CLI::App& program)
{
  struct Options {
    bool markdown = false;
    std::string schema_of;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* app = program.add_subcommand("params", "list all parameters of a case, and of element tests");
  CLI::Option* markdown = app->add_flag("--markdown", options->markdown, "as Markdown");
  app->add_option("--json-schema", options->schema_of,
                  "as JSON Schema (draft 4), for editors: of a case, element tests, a study, or expected.toml")
      ->check(one_of({"case", "element", "study", "expected"}))
      ->excludes(markdown);
  return {app, [options] { return options->schema_of.empty() ? print_list(options->markdown) : print_schema(options->schema_of); }};
}

}  // namespace berm::commands
