// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/simulation/run_test.cpp
#include "fem/fem_problem.hpp"

#include "problem/archive_state.hpp"

#include <algorithm>

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

void archive_mesh(Archive& k, const settings::Case& c, FemModel& model, FemState& state)
{
  mesh::Mesh<2>& corners = model.model.mesh;
  const auto places = [&](const std::string& name, NodeField<Vec<2>>& field) {
    std::vector<Real> numbers;
    for (const Vec<2>& x : field) numbers.insert(numbers.end(), {x[0], x[1]});
    k(name, numbers);
    field.assign(static_cast<Index>(numbers.size() / 2));
    for (Index node = 0; node < field.size(); ++node) field[node] = {numbers[2 * node], numbers[2 * node + 1]};
  };
  places("corners", corners.position);
  std::vector<Index> triangles, regions(corners.region.begin(), corners.region.end());
  for (const auto& nodes : corners.nodes) triangles.insert(triangles.end(), nodes.begin(), nodes.end());
  k("triangles", triangles);
  k("regions", regions);
  for (std::size_t b = 0; b < corners.boundary_nodes.size(); ++b) k("boundary_" + corners.boundary_names[b], corners.boundary_nodes[b]);
  if (k.reads()) {
    if (triangles.size() != 3 * regions.size()) k.refuse("its triangles have no regions");
    corners.nodes.assign(static_cast<Index>(regions.size()));
    corners.region.assign(static_cast<Index>(regions.size()));
    for (Index cell = 0; cell < corners.nodes.size(); ++cell) {
      corners.region[cell] = regions[cell];
      for (int n = 0; n < 3; ++n) corners.nodes[cell][n] = triangles[3 * cell + n];
    }
    const auto is_beyond = [](const auto& numbers, Index count) {
      return std::any_of(numbers.begin(), numbers.end(), [&](Index number) { return number < 0 || number >= count; });
    };
    bool broken = is_beyond(triangles, corners.position.size()) || is_beyond(regions, static_cast<Index>(corners.region_names.size()));
    for (const std::vector<Index>& nodes : corners.boundary_nodes) broken = broken || is_beyond(nodes, corners.position.size());
    if (broken) k.refuse("its mesh names nodes or regions that it has not");
    corners.complete();
    model.mesh = make_quadratic(corners, c, {});
  }
  const Index nodes = model.mesh.node_count();
  places("nodes", model.mesh.position);
  for (int m = 0; m < moments; ++m) places(fmt::format("was_at_{}", m), state.was_at[static_cast<std::size_t>(m)]);
  for (FemWatch& watch : model.watches)
    k.table("watch_" + watch.name, [&] {
      k("cell", watch.cell);
      k("of_nodes", watch.of_nodes);
      k("of_points", watch.of_points);
      if (watch.cell < 0 || watch.cell >= model.mesh.cell_count()) k.refuse("it is in no element");
    });
  for (std::size_t r = 0; r < state.meshed_at.size(); ++r)
    k.table(fmt::format("meshed_at_{}", r), [&] { problem::archive(k, state.meshed_at[r]); });
  if (!k.reads()) return;
  for (const auto* field : {&model.mesh.position, &state.was_at[0], &state.was_at[1], &state.was_at[2]})
    if (field->size() != nodes) k.refuse("its nodes are of another mesh");
  fit_to_mesh(c, state.place_at(Moment::start), state.meshed_at, model);
  state.displacement.assign(static_cast<std::size_t>(model.unknowns()), 0.);
  state.points.assign(model.mesh.cell_count());
  state.contact.assign(model.contact.size(), {});
}

// The sizes reveal a member that is not archived yet.
void archive(Archive& k, const FemModel& model, FemState& state)
{
  static_assert(sizeof(SoilPoint) == (tensor_size<2> + material::max_state + 2) * sizeof(Real));
  static_assert(sizeof(FemContactState) == 5 * sizeof(Real));
  static_assert(sizeof(FemState) ==
                sizeof(problem::State<2>) + (6 + moments) * sizeof(std::vector<Real>) + sizeof(Vec<2>) + 3 * sizeof(Real));
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
