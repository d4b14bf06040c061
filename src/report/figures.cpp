// SPDX-License-Identifier: BSD-3-Clause
#include "report/figures.hpp"

namespace berm {

std::vector<std::string> draw_report_figures(const std::vector<RunRecord>&, const std::filesystem::path&)
{
  return {};
}

}  // namespace berm
