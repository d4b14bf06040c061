// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/ranks/run
#include "simulation/context.hpp"

#include "core/ranks.hpp"

#include <fmt/format.h>

namespace berm::simulation {

std::string words_of_workers(const Context& context)
{
  const int ranks = Ranks::of_run().count(), threads = context.threads();
  const std::string words = fmt::format("{} thread{}", threads, threads == 1 ? "" : "s");
  return ranks == 1 ? words : fmt::format("{} ranks of {}", ranks, words);
}

}  // namespace berm::simulation
