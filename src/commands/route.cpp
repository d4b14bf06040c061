// SPDX-License-Identifier: BSD-3-Clause
#include "commands/page_command.hpp"
#include "os/error.hpp"
#include "route/route_report.hpp"
#include "springs/design.hpp"

#include <chrono>
#include <fmt/format.h>

namespace berm::commands {
namespace {

/// The springs of a run; low and high of a study with a sample. Without them all three are the best.
route::Resistances springs_from(const std::filesystem::path& folder, const route::Pipe& pipe)
{
  if (!std::filesystem::is_directory(folder)) throw InputError(fmt::format("run: there is no folder {}", folder.string()));
  const springs::Design design = springs::designs_in(folder).front();
  const springs::Springs &best = design.best, &low = design.low ? *design.low : best, &high = design.high ? *design.high : best;
  constexpr Real same = 0.01;
  if (std::abs(best.diameter - pipe.diameter) > same * pipe.diameter)
    throw InputError(fmt::format("run: the pipe of {} has a diameter of {:.4g} m, that of the route {:.4g} m", folder.string(),
                                 best.diameter, pipe.diameter));
  const auto bounds = [&](const auto& of) { return route::Bounds{of(low), of(best), of(high)}; };
  const auto lateral = [](Real springs::Lateral::*number) {
    return [number](const springs::Springs& s) { return s.lateral.empty() ? nan : s.lateral.front().*number; };
  };
  route::Resistances found;
  found.V = best.V;
  found.embedment = bounds([](const springs::Springs& s) { return s.embedment; });
  found.stiffness = bounds([](const springs::Springs& s) { return s.V / s.embedment; });
  found.lateral_breakout = bounds(lateral(&springs::Lateral::peak));
  found.lateral_residual = bounds(lateral(&springs::Lateral::residual));
  found.axial_breakout = bounds([](const springs::Springs& s) { return s.axial.cyclic().best; });
  found.axial_breakout.high = std::max(found.axial_breakout.high, best.axial.cyclic().high);
  found.axial_residual = bounds([](const springs::Springs& s) { return s.axial.residual; });
  found.axial_residual.high = std::max(found.axial_residual.high, best.axial.cyclic().high);
  found.source = fmt::format("run {}, state {}{}", folder.string(), best.state,
                             best.lateral.empty() ? ", without a lateral spring" : ", " + best.lateral.front().stage);
  if (std::isnan(found.lateral_residual.best)) found.doubts.emplace_back("the run has no lateral residual: no buckle is computed with it");
  if (std::abs(best.V - pipe.operation) > same * pipe.operation)
    found.doubts.push_back(fmt::format("V of the run is {:.4g} N/m, the weight in operation {:.4g} N/m", best.V, pipe.operation));
  return found;
}

std::string along_route(const CaseOptions& options, const std::string& text, const std::filesystem::path& folder)
{
  const auto begin = std::chrono::steady_clock::now();
  route::RouteResults results{.settings = route::read_route_case(options.files.front(), options.overrides), .input = text, .answer = {}};
  results.answer = route::answer_of(results.settings, springs_from);
  results.wall_s = std::chrono::duration<Real>(std::chrono::steady_clock::now() - begin).count();
  route::write_results(results, folder);
  return route::words_of_results(results);
}

}  // namespace

Command add_route(CLI::App& program)
{
  return add_page_command(program, {.name = "route",
                                    .meaning = "springs of a pipeline by KP, and screening for lateral and upheaval buckling",
                                    .input = "an input FILE.toml: pipe, operation and the soils along the route",
                                    .page = route::page_file,
                                    .make = along_route});
}

}  // namespace berm::commands
