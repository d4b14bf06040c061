// SPDX-License-Identifier: BSD-3-Clause
#include "fem/side_loads.hpp"

namespace berm::fem {
namespace {

/// Coordinate in 0 ... 1, and weight.
const std::array<std::pair<Real, Real>, 3> gauss_points{
    std::pair<Real, Real>{0.5 - std::sqrt(0.15), 5. / 18}, {0.5, 8. / 18}, {0.5 + std::sqrt(0.15), 5. / 18}};

}  // namespace

std::vector<NodalLoad> side_loads(const QuadraticMesh& mesh, const std::vector<BoundarySide>& sides, const std::string& name,
                                  const boundary::TractionSettings& traction, mesh::Metric metric)
{
  std::vector<NodalLoad> loads;
  for (const BoundarySide& side : sides) {
    const std::array<Index, 3> nodes = {side.from, side.middle, side.to};
    const boundary::LoadedRange range = loaded_range(traction, mesh.position[side.from], mesh.position[side.to]);
    const Real loaded = range.to - range.from;
    if (!(loaded > 0)) continue;
    std::array<NodalLoad, 3> of_side;
    for (int k = 0; k < 3; ++k) of_side[k] = {nodes[k], Vec<2>::Zero(), 0};
    for (const auto& [coordinate, weight] : gauss_points) {
      const Real s = range.from + loaded * coordinate;
      const std::array<Real, 3> value = {(1 - s) * (1 - 2 * s), 4 * s * (1 - s), s * (2 * s - 1)},
                                slope = {4 * s - 3, 4 - 8 * s, 4 * s - 1};
      Vec<2> along = Vec<2>::Zero();
      for (int k = 1; k < 3; ++k) along += slope[k] * (mesh.position[nodes[k]] - mesh.position[nodes[0]]);  // slopes have no sum
      const Vec<2> outwards = Vec<2>(along[1], -along[0]).normalized();                                     // the soil is on the left
      Vec<2> x = Vec<2>::Zero();
      for (int k = 0; k < 3; ++k) x += value[k] * mesh.position[nodes[k]];
      const Real length = weight * loaded * along.norm() * weight_at(metric, x);
      for (int k = 0; k < 3; ++k) {
        of_side[k].force += value[k] * length * stress_on<2>(traction, outwards, x);
        of_side[k].area += value[k] * length;
      }
    }
    loads.insert(loads.end(), of_side.begin(), of_side.end());
  }
  if (loads.empty()) refuse_without_soil(name, traction);
  return loads;
}

}  // namespace berm::fem
