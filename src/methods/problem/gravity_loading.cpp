// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/physics/gravity_loading.cpp
#include "bodies/particle_position.hpp"
#include "core/for_each.hpp"
#include "os/error.hpp"
#include "problem/initial_state.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace berm::problem {
namespace {

constexpr Real steepest_isotropic = 0.8;  // k0, beyond which the soil is stiffer along the horizontal
constexpr Real converged = 1e-11;         // of the weight
constexpr int max_iterations = 20000;

/// The soil of one body in one cell.
template <int dim>
struct Element {
  Index cell, body;
  Real volume = 0;
  GroundElasticity ground{};
  mesh::Shape<dim> shape{};
  std::array<Index, dim + 1> nodes{};             ///< numbers among those of the ground
  std::array<Vec<dim>, dim + 1> corner_forces{};  ///< N
};

template <int dim>
using NodalVectors = std::vector<Vec<dim>>;

template <int dim>
Real product(const NodalVectors<dim>& a, const NodalVectors<dim>& b)
{
  return sum_of<Real>("gravity loading", static_cast<Index>(a.size()), [&](Index i) { return a[i].dot(b[i]); });
}

/// The mean over the directions of the mesh: what the volumetric projection averages over a patch.
template <int dim>
Real plane_mean(const SymTensor<dim>& t)
{
  Real sum = 0;
  for (int d = 0; d < dim; ++d) sum += t[d];
  return sum / dim;
}

/// Bodies that move as one, and their equilibrium K u = weight with K = B^T P V D P B: P is the volumetric projection, which forces and strains of a step
/// have, too. K is never made; conjugate gradients need its products only.
template <int dim>
class JoinedBodies {
public:
  JoinedBodies(const settings::Case& c, const Model<dim>& model, std::vector<bodies::Particles<dim>>& particles,
               const std::vector<Index>& bodies)
      : model_(model),
        particles_(particles)
  {
    number_.assign(model.mesh.node_count(), none);
    for (const Index body : bodies) add_body(c, body);
    free_.assign(node_.size(), Vec<dim>::Ones());
    for (std::size_t i = 0; i < node_.size(); ++i)
      free_[i] = boundary::without_fixed<dim>(model.conditions.in_stage(0).held, node_[i], free_[i]);
    list_entries();
    displacement_.assign(node_.size(), Vec<dim>::Zero());
  }

  /// False where the supports do not hold the bodies.
  bool solve()
  {
    NodalVectors<dim> residual = weight(), per_diagonal = diagonal(), step(node_.size()), direction, image(node_.size());
    const auto precondition = [&] {
      for (std::size_t i = 0; i < step.size(); ++i) step[i] = residual[i].cwiseProduct(per_diagonal[i]);
    };
    const Real enough = converged * converged * product<dim>(residual, residual);
    precondition();
    direction = step;
    Real slope = product<dim>(residual, step);
    for (int n = 0; n < max_iterations; ++n) {
      if (product<dim>(residual, residual) <= enough) return true;
      multiply(direction, image);
      const Real stiffness = product<dim>(direction, image), by = slope / stiffness;
      if (!(stiffness > 0) || !std::isfinite(by)) return false;
      for (std::size_t i = 0; i < step.size(); ++i) {
        displacement_[i] += by * direction[i];
        residual[i] -= by * image[i];
      }
      precondition();
      const Real next = product<dim>(residual, step);
      for (std::size_t i = 0; i < step.size(); ++i) direction[i] = step[i] + next / slope * direction[i];
      slope = next;
    }
    return false;
  }

  void give_stress()
  {
    for (Index p = 0; p + 1 < static_cast<Index>(first_of_patch_.size()); ++p) {
      const std::vector<SymTensor<dim>> stress = stresses(p, displacement_);
      for (Index k = first_of_patch_[p]; k < first_of_patch_[p + 1]; ++k) {
        const Element<dim>& element = elements_[in_patches_[k]];
        for_each_particle(element, [&](bodies::Block<dim>& block, int lane) {
          for (int s = 0; s < tensor_size<dim>; ++s) block.stress[s][lane] = stress[k - first_of_patch_[p]][s];
        });
      }
    }
  }

private:
  template <class Visit>
  void for_each_particle(const Element<dim>& element, const Visit& visit) const
  {
    for (const auto& [block, b, count] : particles_[element.body].blocks_in(element.cell))
      for (int l = 0; l < count; ++l) visit(block, l);
  }

  void add_body(const settings::Case& c, Index body)
  {
    const settings::BodySoil& soil = model_.bodies[body].soil;
    const bodies::BodySettings& settings = c.body[body].second;
    const bool differs = varies(soil) || !settings.soil_layer.empty() || settings.at_rest().by_history();
    const GroundElasticity everywhere = ground_elasticity(soil.materials.front(), *settings.k0_at(0, 0));
    CellField<Index> element_in(model_.mesh.cell_count(), none);
    const Index first = static_cast<Index>(elements_.size());
    for (const Index cell : particles_[body].occupied()) {
      Element<dim> element{cell, body};
      element.ground =
          differs ? ground_elasticity(soil_in(soil, cell), *settings.k0_at(depth_of(cell), stress_above(soil, cell))) : everywhere;
      element.shape = model_.mesh.shape(cell);
      for_each_particle(element, [&](const bodies::Block<dim>& block, int lane) { element.volume += block.volume[lane]; });
      for (int k = 0; k <= dim; ++k) {
        Index& number = number_[model_.mesh.nodes[cell][k]];
        if (number == none) {
          number = static_cast<Index>(node_.size());
          node_.push_back(model_.mesh.nodes[cell][k]);
        }
        element.nodes[k] = number;
      }
      element_in[cell] = static_cast<Index>(elements_.size());
      elements_.push_back(element);
    }
    std::vector<char> placed(elements_.size(), 0);
    for (Index e = first; e < static_cast<Index>(elements_.size()); ++e) {
      if (placed[e]) continue;
      first_of_patch_.push_back(static_cast<Index>(in_patches_.size()));
      mesh::for_each_in_patch(model_.patches, elements_[e].cell, [&](Index cell) {
        if (element_in[cell] == none) return;
        in_patches_.push_back(element_in[cell]);
        placed[element_in[cell]] = 1;
      });
    }
  }

  /// The soil in the middle of a cell.
  material::Material soil_in(const settings::BodySoil& soil, Index cell) const
  {
    return soil.at(model_.mesh.region_names[model_.mesh.region[cell]], model_.soil_place(model_.mesh.centroid(cell)));
  }
  Real stress_above(const settings::BodySoil& soil, Index cell) const
  {
    return soil.vertical_stress(model_.mesh.region_names[model_.mesh.region[cell]], model_.soil_place(model_.mesh.centroid(cell)));
  }
  Real depth_of(Index cell) const { return model_.soil_depth(model_.mesh.centroid(cell)); }

  void list_entries()
  {
    first_of_patch_.push_back(static_cast<Index>(in_patches_.size()));
    first_entry_.assign(node_.size() + 1, 0);
    for (const Element<dim>& element : elements_)
      for (const Index i : element.nodes) ++first_entry_[i + 1];
    std::partial_sum(first_entry_.begin(), first_entry_.end(), first_entry_.begin());
    std::vector<Index> next = first_entry_;
    entries_.resize(elements_.size() * (dim + 1));
    for (std::size_t e = 0; e < elements_.size(); ++e)
      for (int k = 0; k <= dim; ++k) entries_[next[elements_[e].nodes[k]]++] = static_cast<Index>(e) * (dim + 1) + k;
  }

  /// The sums of corner forces at the nodes, in the free directions.
  void gather(NodalVectors<dim>& forces) const
  {
    for_each("gravity loading", static_cast<Index>(node_.size()), [&](Index i) {
      Vec<dim> sum = Vec<dim>::Zero();
      for (Index e = first_entry_[i]; e < first_entry_[i + 1]; ++e)
        sum += elements_[entries_[e] / (dim + 1)].corner_forces[entries_[e] % (dim + 1)];
      forces[i] = sum.cwiseProduct(free_[i]);
    });
  }

  NodalVectors<dim> weight()
  {
    for (Element<dim>& element : elements_) {
      for (Vec<dim>& force : element.corner_forces) force.setZero();
      const Vec<dim> gravity = model_.bodies[element.body].weight_over_mass * model_.gravity;
      for_each_particle(element, [&](const bodies::Block<dim>& block, int lane) {
        const Vec<dim> x = position_of(block, lane);
        for (int k = 0; k <= dim; ++k) element.corner_forces[k] += block.mass[lane] * element.shape.value(k, x) * gravity;
      });
    }
    NodalVectors<dim> forces(node_.size());
    gather(forces);
    return forces;
  }

  /// One over the diagonal of K, without the projection; 0 in held directions.
  NodalVectors<dim> diagonal()
  {
    for (Element<dim>& element : elements_)
      for (int k = 0; k <= dim; ++k) {
        const Vec<dim> gradient = element.shape.gradient(k);
        const Real shear = element.ground.shear * gradient.squaredNorm();
        for (int d = 0; d < dim; ++d)
          element.corner_forces[k][d] = element.volume * element.ground.modulus *
                                        (shear + ((d == 1 ? 1 : element.ground.along) - element.ground.shear) * gradient[d] * gradient[d]);
      }
    NodalVectors<dim> sums(node_.size());
    gather(sums);
    for (Vec<dim>& sum : sums)
      for (int d = 0; d < dim; ++d) sum[d] = sum[d] > 0 ? 1 / sum[d] : 0;
    return sums;
  }

  /// The stresses of the elements of a patch.
  std::vector<SymTensor<dim>> stresses(Index patch, const NodalVectors<dim>& displacement) const
  {
    std::vector<SymTensor<dim>> strains;
    Real volume = 0, change = 0;
    for (Index k = first_of_patch_[patch]; k < first_of_patch_[patch + 1]; ++k) {
      const Element<dim>& element = elements_[in_patches_[k]];
      Matrix<dim> gradient = Matrix<dim>::Zero();
      for (int n = 0; n <= dim; ++n) gradient += displacement[element.nodes[n]] * element.shape.gradient(n).transpose();
      SymTensor<dim> strain{};
      for (int a = 0; a < dim; ++a)
        for (int b = a; b < dim; ++b) strain[tensor_index(a, b)] = (gradient(a, b) + gradient(b, a)) / 2;
      volume += element.volume;
      change += element.volume * plane_mean<dim>(strain);
      strains.push_back(strain);
    }
    for (std::size_t k = 0; k < strains.size(); ++k) {
      const Real by = change / volume - plane_mean<dim>(strains[k]);
      for (int d = 0; d < dim; ++d) strains[k][d] += by;
      strains[k] = stress_of<dim>(elements_[in_patches_[first_of_patch_[patch] + static_cast<Index>(k)]].ground, strains[k]);
    }
    return strains;
  }

  /// K u.
  void multiply(const NodalVectors<dim>& u, NodalVectors<dim>& forces)
  {
    for_each("gravity loading", static_cast<Index>(first_of_patch_.size()) - 1, [&](Index patch) {
      const std::vector<SymTensor<dim>> stress = stresses(patch, u);
      Real volume = 0, volume_stress = 0;
      for (std::size_t k = 0; k < stress.size(); ++k) {
        const Real of_element = elements_[in_patches_[first_of_patch_[patch] + static_cast<Index>(k)]].volume;
        volume += of_element;
        volume_stress += of_element * plane_mean<dim>(stress[k]);
      }
      for (std::size_t k = 0; k < stress.size(); ++k) {
        Element<dim>& element = elements_[in_patches_[first_of_patch_[patch] + static_cast<Index>(k)]];
        const Real change = volume_stress / volume - plane_mean<dim>(stress[k]);
        Matrix<dim> projected;
        for (int a = 0; a < dim; ++a)
          for (int b = 0; b < dim; ++b) projected(a, b) = stress[k][tensor_index(std::min(a, b), std::max(a, b))] + (a == b ? change : 0);
        for (int n = 0; n <= dim; ++n) element.corner_forces[n] = element.volume * (projected * element.shape.gradient(n));
      }
    });
    gather(forces);
  }

  const Model<dim>& model_;
  std::vector<bodies::Particles<dim>>& particles_;
  std::vector<Element<dim>> elements_;
  std::vector<Index> first_of_patch_, in_patches_;  ///< elements by patch
  std::vector<Index> number_, node_;                ///< of a node of the mesh, or none; and back
  std::vector<Index> first_entry_, entries_;        ///< (dim + 1) element + corner, by node
  NodalVectors<dim> free_;                          ///< 1 in free directions, 0 in held ones
  NodalVectors<dim> displacement_;
};

/// Bodies with k0, those that contacts join in one list.
std::vector<std::vector<Index>> joined_bodies(const settings::Case& c)
{
  std::vector<Index> leader(c.body.size());
  std::iota(leader.begin(), leader.end(), 0);
  const auto join = [&](Index a, Index b) {
    const Index from = std::max(leader[a], leader[b]), to = std::min(leader[a], leader[b]);
    std::replace(leader.begin(), leader.end(), from, to);
  };
  const auto has_k0 = [&](Index b) { return b != none && c.body[b].second.has_k0(); };
  for (const auto& [name, contact] : c.contact) {
    const Index a = index_of(c.body, contact.body), b = index_of(c.body, contact.other_body);
    if (has_k0(a) && has_k0(b)) join(a, b);
  }
  std::vector<std::vector<Index>> groups(c.body.size());
  for (Index b = 0; b < static_cast<Index>(c.body.size()); ++b)
    if (has_k0(b)) groups[leader[b]].push_back(b);
  std::erase_if(groups, [](const auto& group) { return group.empty(); });
  return groups;
}

}  // namespace

GroundElasticity ground_elasticity(const material::Material& material, Real k0)
{
  const material::Elasticity own = elasticity(material);
  const Real young_modulus = 9 * own.bulk * own.shear / (3 * own.bulk + own.shear), isotropic = std::min(k0, steepest_isotropic);
  const Real modulus = material::p_wave_modulus(material::elasticity(young_modulus, isotropic / (1 + isotropic)));
  if (k0 <= steepest_isotropic) return {modulus, k0, 1, k0, (1 - k0) / 2};
  // What the vertical takes away of the horizontal stiffness, k0^2, and as much beside it as isotropic soil has at the limit.
  const Real limit = steepest_isotropic;
  return {modulus, k0, k0 * k0 + (1 - limit * limit), k0 * k0 + limit * (1 - limit), (1 - limit) / 2};
}

template <int dim>
SymTensor<dim> stress_of(const GroundElasticity& ground, const SymTensor<dim>& strain)
{
  SymTensor<dim> stress;
  stress[0] = ground.modulus * (ground.along * strain[0] + ground.across * strain[2] + ground.k0 * strain[1]);
  stress[1] = ground.modulus * (strain[1] + ground.k0 * (strain[0] + strain[2]));
  stress[2] = ground.modulus * (ground.across * strain[0] + ground.along * strain[2] + ground.k0 * strain[1]);
  for (int k = 3; k < tensor_size<dim>; ++k) stress[k] = 2 * ground.modulus * ground.shear * strain[k];
  return stress;
}

template <int dim>
void load_by_gravity(const settings::Case& c, const Model<dim>& model, std::vector<bodies::Particles<dim>>& particles)
{
  for (const std::vector<Index>& bodies : joined_bodies(c)) {
    JoinedBodies<dim> ground(c, model, particles, bodies);
    if (!ground.solve())
      throw KeyError(
          fmt::format("initial_state: body.{} does not reach equilibrium under gravity: supports of the first stage must hold it, or a "
                      "body with k0 that it has a contact with",
                      c.body[bodies.front()].first));
    ground.give_stress();
  }
}

template SymTensor<2> stress_of(const GroundElasticity&, const SymTensor<2>&);
template SymTensor<3> stress_of(const GroundElasticity&, const SymTensor<3>&);
template void load_by_gravity(const settings::Case&, const Model<2>&, std::vector<bodies::Particles<2>>&);
template void load_by_gravity(const settings::Case&, const Model<3>&, std::vector<bodies::Particles<3>>&);

}  // namespace berm::problem
