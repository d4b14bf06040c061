// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/simulation/run_test.cpp
#include "fem/fem_problem.hpp"

#include "problem/archive_state.hpp"

namespace berm::fem {
namespace {

/// One list of the numbers of all points of integration, or of all contact points.
template <class Points, class Visit>
void archive_numbers(Archive& k, const std::string& name, Points& points, const Visit& visit)
{
  std::vector<Real> numbers;
  for (auto& point : points) visit(point, [&](Real& number) { numbers.push_back(number); });
  k.fixed(name, numbers);
  auto next = numbers.begin();
  for (auto& point : points) visit(point, [&](Real& number) { number = *next++; });
}

}  // namespace

// The sizes reveal a member that is not archived yet.
void archive(Archive& k, const FemModel& model, FemState& state)
{
  static_assert(sizeof(SoilPoint) == (tensor_size<2> + material::max_state + 2) * sizeof(Real));
  static_assert(sizeof(FemContactState) == 5 * sizeof(Real));
  static_assert(sizeof(FemState) == sizeof(problem::State<2>) + 5 * sizeof(std::vector<Real>) + sizeof(Vec<2>) + 3 * sizeof(Real));
  k.table("state", [&] { problem::archive(k, model.model, state.state); });
  k.fixed("displacement", state.displacement);
  archive_numbers(k, "points", state.points, [](std::array<SoilPoint, triangle_points>& of_cell, const auto& number) {
    for (SoilPoint& point : of_cell) {
      for (int c = 0; c < tensor_size<2>; ++c) number(point.stress[c]);
      for (Real& of_law : point.law_state) number(of_law);
      number(point.deviatoric_strain);
      number(point.overstress);
    }
  });
  archive_numbers(k, "contact", state.contact, [](FemContactState& point, const auto& number) {
    number(point.gap);
    for (Real& component : point.traction) number(component);
    number(point.slip);
    number(point.parted);
  });
  for (std::size_t s = 0; s < state.support_forces.size(); ++s) k(fmt::format("support_force_{}", s), state.support_forces[s]);
  k("gravity", state.gravity);
  k("tractions", state.tractions);
  if (state.tractions.size() != model.model.tractions.size()) k.refuse("it has other tractions");
  k("initial_imbalance_factor", state.initial_imbalance_factor);
  k("unbalanced", state.unbalanced);
  k("overstress", state.overstress);
}

}  // namespace berm::fem
