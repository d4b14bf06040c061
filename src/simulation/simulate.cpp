// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_test.cpp
#include "simulation/simulate.hpp"

#include "simulation/fem_method.hpp"
#include "simulation/mpm_method.hpp"
#include "simulation/run.hpp"
#include "simulation/with_run_folder.hpp"
#include "structures/base/soil_words.hpp"

#include <fmt/format.h>

namespace berm::simulation {
namespace {

/// Builds the problem by the method that the case names, and does something with it.
template <class Act>
auto with_method(const RunRequest& request, const Act& act)
{
  const ScratchFolder scratch;
  const auto with = [&](auto method) { return act(method, scratch); };
  if (request.settings.method == problem::Method::fem) return with(FemMethod(request, scratch));
  return request.settings.dimension == 2 ? with(MpmMethod<2>(request, scratch)) : with(MpmMethod<3>(request, scratch));
}

}  // namespace

bool run_case(const RunRequest& request, Context& context)
{
  return with_method(request, [&](auto& method, const ScratchFolder& scratch) {
    const std::string what = fmt::format("{}, {} threads", method.size_words(), context.threads());
    return with_run_folder(request, context, scratch, what, [&](const run_folder::RunFolder& folder, run_folder::RunLog& log) {
      return Run(request, context, method, folder, log).to_the_end();
    });
  });
}

void try_to_build(const RunRequest& request)
{
  with_method(request, [](auto&, const ScratchFolder&) {});
}

void check_case(const RunRequest& request, Context& context)
{
  with_method(request, [&](auto& method, const ScratchFolder&) {
    fmt::print("{}\n", request.case_file.string());
    for (const std::string& line : base::soil_words(request.settings)) fmt::print("  {}\n", line);
    method.print_check(context);
  });
}

}  // namespace berm::simulation
