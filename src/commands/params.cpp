// SPDX-License-Identifier: BSD-3-Clause
#include "commands/command.hpp"
#include "commands/option_values.hpp"
#include "cyclic/cyclic_settings.hpp"
#include "element/element_settings.hpp"
#include "expectations/expectation.hpp"
#include "input/catalogue.hpp"
#include "input/structure_words.hpp"
#include "route/route_settings.hpp"
#include "sea/sea_settings.hpp"
#include "soil_fit/fit_settings.hpp"
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
                              {"fit", "A fit of berm", soil_fit::fit_catalogue},
                              {"cyclic", "A storm on contours, of berm", cyclic::cyclic_catalogue},
                              {"sea", "A sea state on a pipe, of berm", sea::sea_catalogue},
                              {"route", "A pipeline along a route, of berm", route::route_catalogue},
                              {"study", "A study of berm", study::study_catalogue},
                              {"expected", "Expected values of runs of berm", expectations::expected_catalogue}};

int print_schema(const std::string& of)
{
  for (const auto& [word, title, catalogue] : schemas)
    if (word == of) fmt::print("{}", input::json_schema(catalogue(), title));
  return 0;
}

int print_list(bool markdown)
{
  const auto without_material = [](input::Listed all) {  // it is listed with the case
    std::erase_if(all.children, [](const input::Listed& entry) { return entry.key == "material"; });
    return all;
  };
  const std::vector<input::OtherInput> others = {
      {"Element tests, the input of berm element (beside the materials, as in a case)", without_material(element::element_catalogue())},
      {"Fits, the input of berm fit (beside the material, as in a case)", without_material(soil_fit::fit_catalogue())},
      {"Storms on contours, the input of berm cyclic (beside the material, as in a case)", without_material(cyclic::cyclic_catalogue())},
      {"Sea states on a pipe, the input of berm sea", sea::sea_catalogue()},
      {"Lines along a route, the input of berm route", route::route_catalogue()}};
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
  CLI::App* app =
      program.add_subcommand("params", "list all parameters of a case, of element tests, of fits, of storms, of sea states and of routes");
  CLI::Option* markdown = app->add_flag("--markdown", options->markdown, "as Markdown");
  app->add_option(
         "--json-schema", options->schema_of,
         "as JSON Schema (draft 4), for editors: of a case, element tests, a fit, a storm, a sea state, a route, a study, or expected.toml")
      ->check(one_of({"case", "element", "fit", "cyclic", "sea", "route", "study", "expected"}))
      ->excludes(markdown);
  return {app, [options] { return options->schema_of.empty() ? print_list(options->markdown) : print_schema(options->schema_of); }};
}

}  // namespace berm::commands
