// SPDX-License-Identifier: BSD-3-Clause
#include "commands/case_options.hpp"
#include "commands/command.hpp"
#include "element/element_report.hpp"
#include "io/tell.hpp"
#include "os/error.hpp"
#include "user_law/load.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>

namespace berm::commands {
namespace {

namespace fs = std::filesystem;

/// An input of element tests, and where its results go.
struct ElementRequest {
  fs::path file, folder;
  element::ElementCase settings;
};

void load_laws(ElementRequest& request)
{
  try {
    for (auto* materials : {&request.settings.material, &request.settings.borrowed}) user_law::load(*materials, 3);
  } catch (const KeyError& error) {
    throw InputError(fmt::format("{}: {}", request.file.string(), error.what()));
  }
}

bool names_library(const ElementRequest& request)
{
  return user_law::names_library(request.settings.material) || user_law::names_library(request.settings.borrowed);
}

/// All inputs are read before the first test; one goes to `output` itself, several to folders in it that are named like their files.
std::vector<ElementRequest> element_requests(const CaseOptions& options)
{
  std::vector<ElementRequest> all;
  for (const std::string& file : options.files) {
    const fs::path folder = options.output.empty()      ? default_folder(file)
                            : options.files.size() == 1 ? fs::path(options.output)
                                                        : fs::path(options.output) / fs::path(file).stem();
    for (const ElementRequest& other : all)
      if (other.folder == folder)
        throw InputError(fmt::format("{} and {} would both be written to {}", other.file.string(), file, folder.string()));
    all.push_back({file, folder, element::read_element_case(file, options.overrides)});
    if (element::holds_results(folder) && !options.force)
      throw InputError(
          fmt::format("{} holds the results of element tests: replace them with --force, or name another folder with -o", folder.string()));
  }
  std::vector<fs::path> folders;
  for (const ElementRequest& request : all) {
    folders.push_back(request.folder);
    if (!names_library(request)) continue;
    element::refuse_other_files(request.folder);
    options.refuse_links(request.folder);
  }
  options.enter_sandbox(std::any_of(all.begin(), all.end(), names_library), folders);
  for (ElementRequest& request : all) load_laws(request);
  return all;
}

void run_element_tests(const ElementRequest& request)
{
  const auto begin = std::chrono::steady_clock::now();
  element::ElementResults results{request.file, request.settings, {}};
  for (const element::TestSettings& test : request.settings.test)
    results.records.push_back(element::run_test(test, element::material_of(request.settings, test)));
  for (const auto* materials : {&request.settings.material, &request.settings.borrowed}) user_law::throw_failures(*materials);
  results.wall_s = std::chrono::duration<Real>(std::chrono::steady_clock::now() - begin).count();
  element::write_results(results, request.folder);
  fmt::print("{}", element::words_of_results(results.records));
  io::tell("the page is {}\n", (request.folder / "element.html").string());
}

}  // namespace

Command add_element(CLI::App& program)
{
  const auto options = std::make_shared<CaseOptions>();
  CLI::App* app = program.add_subcommand("element", "laboratory tests of soils: triaxial, biaxial, simple shear, oedometer");
  options->take_cases(*app);
  app->add_option(
      "-o,--output", options->output,
      "folder for the results; of several inputs: the folder that theirs go into (default: out/FOLDER/NAME of FOLDER/NAME.toml)");
  app->add_flag("--force", options->force, "replace the results of earlier tests in the folder");
  options->take_sandbox(*app);
  return {app, [options] {
            messages_to_stderr();
            for (const ElementRequest& request : element_requests(*options)) run_element_tests(request);
            return 0;
          }};
}

}  // namespace berm::commands
