// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/macro_element_fit/files_test.cpp
#include "commands/case_options.hpp"
#include "commands/command.hpp"
#include "commands/option_values.hpp"
#include "io/log.hpp"
#include "macro_element_fit/files.hpp"
#include "os/error.hpp"

#include <fmt/format.h>

namespace berm::commands {

Command add_macro_element(CLI::App& program)
{
  struct Options {
    std::vector<std::string> fit, check;
    std::string output = "out/macro_element";
    std::optional<Real> axial_friction;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* app = program.add_subcommand("macro-element", "fit a macro-element of a pipe to runs, and write it as C code and JSON");
  app->add_option("RUN", options->fit, "run folders, or outputs of berm study, that it is fitted to")->required();
  app->add_option("--check", options->check, "runs that it is compared with but not fitted to");
  app->add_option("--axial-friction", options->axial_friction,
                  "axial friction coefficient (default: that of the runs' contact, the tangent of its friction angle)")
      ->check(number_within(not_negative));
  app->add_option("-o,--output", options->output, "folder for the files (default: out/macro_element)");
  return {app, [options] {
            messages_to_stderr();
            namespace macro = macro_element_fit;
            std::vector<macro::Path> fitted = macro::paths_in(options->fit), others = macro::paths_in(options->check);
            for (const macro::Path& other : others)
              for (const macro::Path& path : fitted)
                if (std::filesystem::equivalent(other.run, path.run))
                  throw InputError(fmt::format("{} is fitted to, so it cannot be a check", other.run.string()));
            macro::Parameters parameters = macro::fit(fitted);
            if (options->axial_friction) parameters.axial_friction = *options->axial_friction;
            if (parameters.axial_friction == 0) io::warn("there is no axial resistance: give a coefficient to --axial-friction");
            std::vector<macro::Comparison> comparisons;
            for (macro::Path& path : fitted) comparisons.push_back(macro::compare(parameters, std::move(path), true));
            for (macro::Path& path : others) comparisons.push_back(macro::compare(parameters, std::move(path), false));
            if (others.empty()) io::warn("no run checks the fit: give runs that are not fitted to --check");
            for (const std::string& name : macro::write_files(options->output, parameters, comparisons))
              fmt::print("{}\n", (std::filesystem::path(options->output) / name).string());
            fmt::print("\n{}", macro::table_of(comparisons));
            return 0;
          }};
}

}  // namespace berm::commands
