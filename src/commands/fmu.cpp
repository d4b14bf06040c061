// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fmu/slice_unit_test.cpp
#include "fmu/slice_unit.hpp"

#include "commands/case_options.hpp"
#include "commands/command.hpp"
#include "io/atomic_file.hpp"
#include "os/error.hpp"

#include <fmt/format.h>

namespace berm::commands {
namespace {

namespace fs = std::filesystem;

void write_units(const simulation::RunRequest& request)
{
  if (brings_programs(request))
    throw InputError(fmt::format("{}: a unit brings no programs: give mesh.file a mesh (.msh), and materials a law of berm",
                                 request.case_file.string()));
  simulation::check_buildable(request);
  for (const int version : {2, 3}) try {
      const fs::path file = request.folder.string() + fmt::format(".fmi{}.fmu", version);
      const std::string unit = fmu::fmu_of_slice(request.settings, request.case_file.parent_path(), version);
      if (file.has_parent_path()) io::make_folder(file.parent_path());
      io::write_atomically(file, unit);
      fmt::print("{}\n", file.string());
    } catch (const fmu::NoDrive& error) {
      throw InputError(fmt::format("{}:\n\n{}", request.places.located(error).text(), error.stage));
    } catch (const KeyError& error) {
      throw input::LocatedError(request.places.located(error));
    }
}

}  // namespace

Command add_fmu(CLI::App& program)
{
  const auto options = std::make_shared<CaseOptions>();
  CLI::App* app = program.add_subcommand(
      "fmu",
      "write the soil slice of a case as functional mock-up units, FMI 2.0 and 3.0, whose pipe a co-simulation moves in the last stage");
  options->take_cases(*app);
  app->add_option("-o,--output", options->output,
                  "NAME of NAME.fmi2.fmu and NAME.fmi3.fmu; of several cases: the folder that theirs go into (default: out/FOLDER/NAME "
                  "of FOLDER/NAME.toml)");
  return {app, [options] {
            messages_to_stderr();
            for (const simulation::RunRequest& request : requests(*options)) write_units(request);
            return 0;
          }};
}

}  // namespace berm::commands
