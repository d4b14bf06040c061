// SPDX-License-Identifier: BSD-3-Clause
#include "report/animation/film_choice.hpp"

#include <fmt/format.h>

namespace berm::report {

std::vector<Index> kept_frames(const std::vector<std::string>& stages, Index step)
{
  std::vector<Index> kept;
  const Index count = static_cast<Index>(stages.size());
  for (Index k = 0; k < count; ++k)
    if (k % step == 0 || k + 1 == count || stages[k] != stages[k + 1]) kept.push_back(k);
  return kept;
}

std::string kept_words(Index step)
{
  if (step == 1) return "";
  const bool teen = step / 10 % 10 == 1;
  const char* ending = teen ? "th" : step % 10 == 1 ? "st" : step % 10 == 2 ? "nd" : step % 10 == 3 ? "rd" : "th";
  return fmt::format("every {}{} frame", step, ending);
}

}  // namespace berm::report
