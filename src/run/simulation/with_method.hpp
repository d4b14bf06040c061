// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_test.cpp
#pragma once

#include "core/ranks.hpp"
#include "os/error.hpp"
#include "simulation/fem_method.hpp"
#include "simulation/mpm_method.hpp"
#include "simulation/pipeline_method.hpp"
#include "simulation/space_fem_method.hpp"
#include "user_law/load.hpp"

#include <fmt/format.h>
#include <type_traits>

namespace berm::simulation {

/// Loads the user's own laws and returns act(std::type_identity<Method>, request) for the method that the case names. An error that names a key gets the line
/// where that was written.
template <class Act>
auto with_method(RunRequest request, const Act& act)
{
  try {
    user_law::load(request.settings, request.laws);
    if (request.settings.method == settings::Method::fem && Ranks::of_run().count() > 1)
      throw InputError(
          fmt::format("{}: method = \"fem\" is for one process: start it without the MPI launcher", request.case_file.string()));
    if (request.settings.method == settings::Method::fem)
      return request.settings.dimension() == 2 ? act(std::type_identity<FemMethod>(), request)
                                               : act(std::type_identity<SpaceFemMethod>(), request);
    if (request.settings.pipeline) return act(std::type_identity<PipelineMethod>(), request);
    return request.settings.dimension() == 2 ? act(std::type_identity<MpmMethod<2>>(), request)
                                             : act(std::type_identity<MpmMethod<3>>(), request);
  } catch (const KeyError& error) {
    throw input::LocatedError(request.places.located(error));
  }
}

}  // namespace berm::simulation
