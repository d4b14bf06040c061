// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_test.cpp
#include "simulation/simulate.hpp"

#include "core/error.hpp"
#include "io/tell.hpp"
#include "simulation/good_sense.hpp"
#include "simulation/open_run.hpp"
#include "simulation/with_method.hpp"
#include "structures/base/soil_words.hpp"

#include <fmt/format.h>

namespace berm::simulation {
bool run_case(const RunRequest& request, Context& context)
{
  return std::visit([](const auto& run) { return run->to_the_end(); }, open_run(request, context));
}

void check_buildable(const RunRequest& to_build)
{
  with_method(to_build, [&](auto of, const RunRequest& request) {
    const io::ScratchFolder scratch;
    typename decltype(of)::type method(request, scratch);
    warnings_of(method.scene(request, 1));
  });
}

void check_case(const RunRequest& to_check, Context& context)
{
  with_method(to_check, [&](auto of, const RunRequest& request) {
    const io::ScratchFolder scratch;
    typename decltype(of)::type method(request, scratch);
    const sanity::Scene scene = method.scene(request, context.threads());
    const std::vector<std::string> warnings = warnings_of(scene);
    for (const std::string& warning : warnings) io::tell("berm: warning: {}\n", warning);
    fmt::print("{}\n", request.case_file.string());
    for (const std::string& line : base::soil_words(request.settings)) fmt::print("  {}\n", line);
    for (const std::string& line : base::k0_words(request.settings)) fmt::print("  {}\n", line);
    for (const std::string& line : base::drainage_words(request.settings)) fmt::print("  {}\n", line);
    for (const std::string& line : motion_words(scene)) fmt::print("  {}\n", line);
    try {
      method.print_check(context);
    } catch (const RunError& error) {
      throw InputError(fmt::format("{}: its first steps fail: {}", request.case_file.string(), error.what()));
    }
    fmt::print("  disk         about {} in {}\n", sanity::words_of_bytes(disk_of(scene)), request.folder.string());
  });
}

Real expected_wall_time(const RunRequest& to_measure)
{
  Context context(1);
  return with_method(to_measure, [&](auto of, const RunRequest& request) {
    const io::ScratchFolder scratch;
    typename decltype(of)::type method(request, scratch);
    return method.expected_wall_time();
  });
}

}  // namespace berm::simulation
