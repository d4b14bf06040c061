// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_test.cpp
#include "simulation/simulate.hpp"

#include "os/error.hpp"
#include "simulation/good_sense.hpp"
#include "simulation/open_run.hpp"
#include "simulation/with_method.hpp"

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

Checked check_case(const RunRequest& to_check, Context& context)
{
  return with_method(to_check, [&](auto of, const RunRequest& request) {
    const io::ScratchFolder scratch;
    typename decltype(of)::type method(request, scratch);
    const sanity::Scene scene = method.scene(request, context.threads());
    Diagnostics doubts = diagnose(scene);
    Checked checked{std::move(doubts.refusals), std::move(doubts.warnings), {}, {}, {}};
    if (!checked.refusals.empty()) return checked;
    checked.notes = motion_words(scene);
    try {
      checked.estimate = method.estimate(context);
    } catch (const RunError& error) {
      checked.failure = {.file = request.case_file.string(), .message = fmt::format("its first steps fail: {}", error.what())};
      return checked;
    }
    checked.estimate->disk = disk_of(scene);
    checked.estimate->lines.push_back(
        fmt::format("disk         about {} in {}", sanity::words_of_bytes(disk_of(scene)), request.folder.string()));
    return checked;
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
