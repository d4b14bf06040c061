// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/simulation/watch_point_test.cpp
#include "simulation/watch_point.hpp"

#include "core/ranks.hpp"
#include "os/error.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace berm::simulation {
namespace {

/// A particle that moves a watched point, as a rank tells the others of it.
template <int dim>
struct Mover {
  std::int32_t id;
  Index cell;
  Vec<dim> x, v;
};

/// Volume integrals over the particles of a cell.
template <int dim>
struct CellSums {
  Index cell = none;
  Real volume = 0;
  Vec<dim> moment = Vec<dim>::Zero();
  SymTensor<dim> stress{};
  Real pressure = 0;

  void add(const CellSums& other)
  {
    volume += other.volume;
    moment += other.moment;
    for (int k = 0; k < tensor_size<dim>; ++k) stress.c[k] += other.stress.c[k];
    pressure += other.pressure;
  }
};

template <int dim>
CellSums<dim> sums_in(const bodies::Particles<dim>& particles, Index cell, int pressure_place)
{
  CellSums<dim> sums{.cell = cell};
  for (Index k = 0; k < particles.count_in(cell); ++k) {
    const bodies::Particle<dim> p = particles.read_at(cell, k);
    CellSums<dim> of_particle{.volume = p.volume, .moment = p.volume * p.x};
    for (int c = 0; c < tensor_size<dim>; ++c) of_particle.stress.c[c] = p.volume * p.stress.c[c];
    if (pressure_place != none) of_particle.pressure = p.volume * p.extra[pressure_place];
    sums.add(of_particle);
  }
  return sums;
}

/// The first cell of the patch of a cell and of each patch that shares a node with it, ascending.
template <int dim>
std::vector<Index> patches_around(const problem::Model<dim>& model, Index cell)
{
  std::vector<Index> firsts;
  mesh::for_each_in_patch(model.patches, cell, [&](Index c) {
    for (const Index node : model.mesh.nodes[c])
      for (Index e = model.mesh.first_entry[node]; e < model.mesh.first_entry[node + 1]; ++e) {
        Index first = model.mesh.entries[e] / (dim + 1);
        mesh::for_each_in_patch(model.patches, first, [&](Index other) { first = std::min(first, other); });
        firsts.push_back(first);
      }
  });
  std::sort(firsts.begin(), firsts.end());
  firsts.erase(std::unique(firsts.begin(), firsts.end()), firsts.end());
  return firsts;
}

/// Lengths to units in which the neighbours of a patch are about 2 away, whatever its shape: the inverse of the root of the second moment of its corners.
template <int dim>
Matrix<dim> units_of_patch(const problem::Model<dim>& model, Index cell)
{
  std::vector<Index> nodes;
  mesh::for_each_in_patch(model.patches, cell,
                          [&](Index c) { nodes.insert(nodes.end(), model.mesh.nodes[c].begin(), model.mesh.nodes[c].end()); });
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  Vec<dim> center = Vec<dim>::Zero();
  for (const Index node : nodes) center += (model.mesh.position[node] - model.mesh.position[nodes[0]]) / static_cast<Real>(nodes.size());
  Matrix<dim> squares = Matrix<dim>::Zero();
  for (const Index node : nodes) {
    const Vec<dim> d = model.mesh.position[node] - model.mesh.position[nodes[0]] - center;
    squares += d * d.transpose() / static_cast<Real>(nodes.size());
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Real, dim, dim>>(squares).operatorInverseSqrt();
}

}  // namespace

template <int dim>
std::vector<Real> linear_fit_at_origin(const std::vector<Vec<dim>>& places, const std::vector<Real>& sizes)
{
  constexpr Real near_square = 0.04, min_variance = 0.1;
  const std::size_t count = places.size();
  Real size = 0, sum = 0;
  Vec<dim> middle = Vec<dim>::Zero(), center = Vec<dim>::Zero();
  std::vector<Real> parts(count);
  for (std::size_t k = 0; k < count; ++k) {
    parts[k] = sizes[k] / std::pow(places[k].squaredNorm() + near_square, 2);
    size += sizes[k];
    sum += parts[k];
    middle += sizes[k] * places[k];
    center += parts[k] * places[k];
  }
  middle /= size;
  center /= sum;
  Matrix<dim> spread = Matrix<dim>::Zero(), squares = Matrix<dim>::Zero();
  for (std::size_t k = 0; k < count; ++k) {
    spread += sizes[k] / size * (places[k] - middle) * (places[k] - middle).transpose();
    squares += parts[k] / sum * (places[k] - center) * (places[k] - center).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Real, dim, dim>> axes(spread);
  const int known = static_cast<int>((axes.eigenvalues().array() > min_variance).count());  // the last ones: they ascend
  Vec<dim> slope = Vec<dim>::Zero();
  if (known > 0) {
    const auto along = axes.eigenvectors().rightCols(known);
    slope = along * (along.transpose() * squares * along).ldlt().solve(along.transpose() * -center);
  }
  for (std::size_t k = 0; k < count; ++k) parts[k] *= (1 + slope.dot(places[k] - center)) / sum;
  return parts;
}

template <int dim>
WatchPoint<dim>::WatchPoint(const problem::Model<dim>& model, const bodies::Particles<dim>& start, const problem::Watch& watch,
                            const std::vector<Real>& point)
    : body_(watch.body),
      nearest_(watch.id)
{
  // In widths of a particle. In the corner of a triangle or tetrahedron the nearest one may be 1.7 away.
  constexpr Real beside = 2, around = 3;
  for (int d = 0; d < dim; ++d) place_[d] = point[d];
  Real width = 0;
  Vec<dim> nearest = Vec<dim>::Zero();
  start.visit([&](Index, Index b, int l) {
    if (start.block(b).id[l] != watch.id) return;
    const bodies::Particle<dim> p = start.read(b, l);
    nearest = p.x;
    width = std::pow(mesh::section_of(model.mesh.metric, p.volume, p.x), 1. / dim);
  });
  if ((nearest - place_).norm() > beside * width) place_ = nearest;
  std::vector<Vec<dim>> places;
  start.visit([&](Index, Index b, int l) {
    Vec<dim> x;
    for (int d = 0; d < dim; ++d) x[d] = start.block(b).x[d][l];
    if ((x - place_).norm() < around * width) neighbours_.push_back({start.block(b).id[l], 0, x});
  });
  std::sort(neighbours_.begin(), neighbours_.end(), [](const Neighbour& a, const Neighbour& b) { return a.id < b.id; });
  for (const Neighbour& n : neighbours_) places.push_back(2 / width * (n.first - place_));
  const std::vector<Real> parts = linear_fit_at_origin<dim>(places, std::vector<Real>(places.size(), 1));
  for (std::size_t k = 0; k < parts.size(); ++k) neighbours_[k].part = parts[k];
}

template <int dim>
Watched<dim> WatchPoint<dim>::read(const problem::Model<dim>& model, const bodies::Particles<dim>& particles) const
{
  std::vector<Mover<dim>> found, movers;
  particles.visit([&](Index cell, Index b, int l) {
    const bodies::Block<dim>& block = particles.block(b);
    const std::int32_t id = block.id[l];
    if (!std::binary_search(neighbours_.begin(), neighbours_.end(), Neighbour{id, 0, {}},
                            [](const Neighbour& x, const Neighbour& y) { return x.id < y.id; }))
      return;
    Mover<dim> mover{id, cell, {}, {}};
    for (int d = 0; d < dim; ++d) mover.x[d] = block.x[d][l], mover.v[d] = block.v[d][l];
    found.push_back(mover);
  });
  Ranks& ranks = Ranks::of_run();
  ranks.gather(found, movers);
  std::sort(movers.begin(), movers.end(), [](const Mover<dim>& a, const Mover<dim>& b) { return a.id < b.id; });
  if (movers.size() != neighbours_.size()) {
    if (model.earthworks.empty()) throw RunError(fmt::format("particles around particle {} are gone", nearest_));
    SymTensor<dim> no_stress;
    std::fill_n(no_stress.c, tensor_size<dim>, nan);
    return {Vec<dim>::Constant(nan), Vec<dim>::Constant(nan), no_stress, nan};  // taken out
  }

  Watched<dim> now{Vec<dim>::Zero(), Vec<dim>::Zero(), {}, 0};
  Index cell = none;
  for (std::size_t k = 0; k < movers.size(); ++k) {
    now.displacement += neighbours_[k].part * (movers[k].x - neighbours_[k].first);
    now.velocity += neighbours_[k].part * movers[k].v;
    if (movers[k].id == nearest_) cell = movers[k].cell;
  }

  const int pressure_place = pore_pressure_index(model.bodies[body_].soil.materials.front());
  const std::vector<Index> firsts = patches_around(model, cell);
  std::vector<CellSums<dim>> own, all;
  for (const Index first : firsts)
    mesh::for_each_in_patch(model.patches, first, [&](Index c) {
      if (ranks.owns_cell(c) && particles.count_in(c) > 0) own.push_back(sums_in(particles, c, pressure_place));
    });
  ranks.gather(own, all);
  std::sort(all.begin(), all.end(), [](const CellSums<dim>& a, const CellSums<dim>& b) { return a.cell < b.cell; });

  const Matrix<dim> units = units_of_patch(model, cell);
  std::vector<CellSums<dim>> means;
  std::vector<Vec<dim>> places;
  std::vector<Real> volumes;
  for (const Index first : firsts) {
    CellSums<dim> patch;
    mesh::for_each_in_patch(model.patches, first, [&](Index c) {
      const auto at =
          std::lower_bound(all.begin(), all.end(), c, [](const CellSums<dim>& sums, Index wanted) { return sums.cell < wanted; });
      if (at != all.end() && at->cell == c) patch.add(*at);
    });
    if (!(patch.volume > 0)) continue;
    means.push_back(patch);
    volumes.push_back(patch.volume);
    places.push_back(units * (patch.moment / patch.volume - place_ - now.displacement));
  }
  const std::vector<Real> parts = linear_fit_at_origin<dim>(places, volumes);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Real part = parts[k] / volumes[k];
    for (int c = 0; c < tensor_size<dim>; ++c) now.stress.c[c] += part * means[k].stress.c[c];
    now.pore_pressure += part * means[k].pressure;
  }
  return now;
}

template std::vector<Real> linear_fit_at_origin<2>(const std::vector<Vec<2>>&, const std::vector<Real>&);
template std::vector<Real> linear_fit_at_origin<3>(const std::vector<Vec<3>>&, const std::vector<Real>&);
template class WatchPoint<2>;
template class WatchPoint<3>;

}  // namespace berm::simulation
