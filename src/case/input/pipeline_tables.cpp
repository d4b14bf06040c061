// SPDX-License-Identifier: BSD-3-Clause
#include "input/pipeline_tables.hpp"

#include "input/table_file.hpp"

#include <fmt/format.h>

namespace berm::input {
namespace {

/// fault(x, y) is what else is wrong with a row, or "".
template <class Fault>
void read_points(const std::string& key, const std::filesystem::path& folder, const TableForm& form, const Fault& fault,
                 settings::GivenPoints& points)
{
  if (points.table.empty()) return;
  read_table(key + ".table", folder / points.table, form, [&](Real x, const std::vector<std::size_t>&, const std::vector<Real>& values) {
    if (!points.x.empty() && !(x > points.x.back()))
      return fmt::format("{:.6g} m follows {:.6g} m: the first column must ascend", x, points.x.back());
    points.x.push_back(x);
    points.y.push_back(values.front());
    return std::string(fault(x, values.front()));
  });
  points.table.clear();
}

}  // namespace

void read_pipeline_tables(settings::PipelineSettings& pipeline, const std::filesystem::path& folder)
{
  settings::Route& route = pipeline.route;
  read_points(
      "pipeline.route", folder, {"this route", {{"y", "m"}}, false, "x_m,y_m", {"x", "m"}, "the position along the line"},
      [&](Real, Real) { return route.x.front() == 0 ? "" : "a route must begin at x = 0"; }, route);
  read_points(
      "pipeline.far_soil.lateral", folder, {"this curve", {{"H", "N/m"}}, false, "u_m,H_N_m", {"u", "m"}, "the displacement"},
      [](Real u, Real H) {
        if (!(u > 0)) return "the point 0, 0 of a curve is implied: its displacements must be more than 0";
        return H > 0 ? "" : "a resistance must be more than 0";
      },
      pipeline.far_soil.lateral);
}

}  // namespace berm::input
