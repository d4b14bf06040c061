// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_test.cpp
#include "simulation/simulate.hpp"

#include "core/error.hpp"
#include "core/ranks.hpp"
#include "simulation/fem_method.hpp"
#include "simulation/good_sense.hpp"
#include "simulation/mpm_method.hpp"
#include "simulation/run.hpp"
#include "simulation/with_run_folder.hpp"
#include "structures/base/soil_words.hpp"
#include "user_law/load.hpp"

#include <fmt/format.h>

namespace berm::simulation {
namespace {

/// Loads the user's own laws, builds the problem by the method that the case names, and does something with it. An error that names a key gets the line where that was written.
template <class Act>
auto with_method(RunRequest request, const Act& act)
{
  const io::ScratchFolder scratch;
  const auto with = [&](auto method) { return act(request, method, scratch); };
  try {
    user_law::load(request.settings);
    if (request.settings.method == problem::Method::fem && Ranks::of_run().count() > 1)
      throw InputError(
          fmt::format("{}: method = \"fem\" is for one process: start it without the MPI launcher", request.case_file.string()));
    if (request.settings.method == problem::Method::fem) return with(FemMethod(request, scratch));
    return request.settings.dimension == 2 ? with(MpmMethod<2>(request, scratch)) : with(MpmMethod<3>(request, scratch));
  } catch (const KeyError& error) {
    throw InputError(request.places.located(error.what()));
  }
}

}  // namespace

bool run_case(const RunRequest& to_run, Context& context)
{
  return with_method(to_run, [&](const RunRequest& request, auto& method, const io::ScratchFolder& scratch) {
    const std::vector<std::string> warnings =
        request.resume ? noted_warnings(request.folder) : warnings_of(method.scene(request, context.threads()));
    const std::string what = fmt::format("{}, {}", method.size_words(), words_of_workers(context));
    return with_run_folder(request, context, scratch, what, warnings, [&](const run_folder::RunFolder& folder, run_folder::RunLog& log) {
      return Run(request, context, method, folder, log, warnings).to_the_end();
    });
  });
}

void try_to_build(const RunRequest& to_build)
{
  with_method(to_build, [&](const RunRequest& request, auto& method, const io::ScratchFolder&) { warnings_of(method.scene(request, 1)); });
}

void check_case(const RunRequest& to_check, Context& context)
{
  with_method(to_check, [&](const RunRequest& request, auto& method, const io::ScratchFolder&) {
    const sanity::Scene scene = method.scene(request, context.threads());
    const std::vector<std::string> warnings = warnings_of(scene);
    for (const std::string& warning : warnings) fmt::print(stderr, "berm: warning: {}\n", warning);
    fmt::print("{}\n", request.case_file.string());
    for (const std::string& line : base::soil_words(request.settings)) fmt::print("  {}\n", line);
    method.print_check(context);
    fmt::print("  disk         about {} in {}\n", sanity::words_of_bytes(disk_of(scene)), request.folder.string());
  });
}

}  // namespace berm::simulation
