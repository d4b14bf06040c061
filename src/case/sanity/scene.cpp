// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "sanity/scene.hpp"

#include "problem/cells_at_body.hpp"
#include "problem/equilibrium.hpp"
#include "sanity/thin_places.hpp"

#include <algorithm>
#include <memory>

namespace berm::sanity {
namespace {

template <int dim>
RigidScene rigid_scene(const bodies::RigidBody<dim>& rigid)
{
  RigidScene scene{bodies::is_bounded<dim>(rigid.shape), width_of<dim>(rigid.shape), {}};
  for (int d = 0; d < dim && scene.bounded; ++d) {
    const Vec<dim> axis = Vec<dim>::Unit(d);
    scene.space[d] = {lowest_level<dim>(rigid.shape, axis), -lowest_level<dim>(rigid.shape, -axis)};
  }
  return scene;
}

/// The cells that each body takes at the start: those of its particles, or of its regions.
template <int dim>
std::vector<std::vector<Index>> cells_of_bodies(const settings::Case& c, const problem::Model<dim>& model,
                                                const std::vector<bodies::Particles<dim>>& particles)
{
  std::vector<std::vector<Index>> cells(c.body.size());
  for (std::size_t b = 0; b < c.body.size(); ++b) {
    if (!particles.empty()) {
      cells[b] = particles[b].occupied();
      continue;
    }
    std::vector<char> fills(model.mesh.region_names.size(), 0);
    for (const std::string& region : c.body[b].second.regions)
      if (const Index r = model.mesh.find_region(region); r != none) fills[r] = 1;
    for (Index cell = 0; cell < model.mesh.cell_count(); ++cell)
      if (fills[model.mesh.region[cell]]) cells[b].push_back(cell);
  }
  return cells;
}

/// Depth of soil of a body, m: below the level of the bed, or below the ground where that is not level.
template <int dim>
Real depth_below_surface(const settings::Case& c, const problem::Model<dim>& model, const Spans& space, const std::vector<Index>& cells)
{
  const Span& height = space[model.axes.up];
  if (model.ground.line.level())
    return model.axes.sign > 0 ? std::max(Real(0), c.surface - height.from) : std::max(Real(0), height.to - c.surface);
  return problem::depth_below_ground(model, cells);
}

/// Pairs of bodies whose cells have nodes in common.
template <int dim>
std::vector<std::pair<Index, Index>> neighbors_in(const mesh::Mesh<dim>& mesh, const std::vector<std::vector<Index>>& cells)
{
  std::vector<std::pair<Index, Index>> found;
  auto last = NodeField<Index>::zeros(mesh.node_count());  // 1 + the last body that was there
  for (Index b = 0; b < static_cast<Index>(cells.size()); ++b)
    for (const Index cell : cells[b])
      for (const Index node : mesh.nodes[cell]) {
        const Index other = last[node] - 1;
        last[node] = b + 1;
        if (other < 0 || other == b) continue;
        if (std::find(found.begin(), found.end(), std::pair(other, b)) == found.end()) found.emplace_back(other, b);
      }
  return found;
}

/// The regions of cells, in the order of the mesh, and the space that they take.
template <int dim>
std::vector<RegionScene> regions_of(const mesh::Mesh<dim>& mesh, const std::vector<Index>& cells)
{
  std::vector<RegionScene> regions(mesh.region_names.size());
  for (std::size_t r = 0; r < regions.size(); ++r) regions[r].name = mesh.region_names[r];
  for (const Index cell : cells)
    for (const Index node : mesh.nodes[cell])
      for (int d = 0; d < dim; ++d) regions[mesh.region[cell]].space[d].add(mesh.position[node][d]);
  std::erase_if(regions, [](const RegionScene& r) { return r.space[0].length() < 0; });
  return regions;
}

/// The boundaries of the supports.
template <int dim>
std::vector<SupportScene> supports_of(const settings::Case& c, const mesh::Mesh<dim>& mesh, const std::vector<std::vector<Index>>& cells)
{
  std::vector<SupportScene> supports;
  for (const auto& [name, settings] : c.support) {
    SupportScene& support = supports.emplace_back();
    auto at_boundary = NodeField<char>::zeros(mesh.node_count());
    for (const Index node : mesh.boundary_nodes[fixed_boundary(mesh, name, settings)]) {
      at_boundary[node] = 1;
      for (int d = 0; d < dim; ++d) support.space[d].add(mesh.position[node][d]);
    }
    for (const std::vector<Index>& of_body : cells)
      for (const Index cell : of_body)
        if (std::any_of(mesh.nodes[cell].begin(), mesh.nodes[cell].end(), [&](Index node) { return at_boundary[node] != 0; }))
          support.cell = std::min(support.cell, mesh.size(cell));
  }
  return supports;
}

/// The loads on the soil.
template <int dim>
std::vector<LoadScene> loads_of(const settings::Case& c, const problem::Model<dim>& model,
                                const std::vector<problem::LoadPointState<dim>>& load_points)
{
  constexpr Real within = 1e-6;  // of the mesh
  const auto place_of = [](const Vec<dim>& x) {
    Place place = {};
    for (int d = 0; d < dim; ++d) place[d] = x[d];
    return place;
  };
  std::vector<LoadScene> loads(c.traction.size());
  for (std::size_t k = 0; k < loads.size(); ++k) loads[k].key = "traction." + c.traction[k].first;
  for (std::size_t l = 0; l < load_points.size(); ++l) {
    const std::string& name = model.tractions[model.load_points[l].traction].name;
    loads[index_of(c.traction, name)].points.push_back(place_of(load_points[l].x));
  }
  boundary::for_each_of<boundary::Head<dim>>(model.conditions, [&](std::size_t, const auto& row, const auto& head) {
    LoadScene& load = loads.emplace_back(LoadScene{"support." + row.name + ".head", {}});
    for (std::size_t k = 0; k < row.nodes.size(); ++k)
      load.points.push_back(
          place_of(model.mesh.position[row.nodes[k]] + within * (model.mesh.upper - model.mesh.lower).norm() * head.normals[k]));
  });
  return loads;
}

template <int dim>
ResolvedWaves resolved_waves(const settings::Case& c, const problem::Model<dim>& model, const std::vector<std::vector<Index>>& cells)
{
  ResolvedWaves resolved;
  if (std::none_of(c.support.begin(), c.support.end(), [](const auto& support) { return support.second.motion.has_value(); }))
    return resolved;
  for (std::size_t b = 0; b < cells.size(); ++b)
    for (const Index cell : cells[b]) {
      const material::Material soil =
          model.bodies[b].soil.at(model.mesh.region_names[model.mesh.region[cell]], model.soil_depth(model.mesh.centroid(cell)));
      const Real wave = ResolvedWaves::cells * model.mesh.size(cell), density = inertia_density(soil);
      resolved.shear = std::min(resolved.shear, std::sqrt(elasticity(soil).shear / density) / wave);
      resolved.pressure = std::min(resolved.pressure, std::sqrt(p_wave_modulus(soil) / density) / wave);
    }
  return resolved;
}

}  // namespace

Index Scene::touched_by(Index rigid) const
{
  for (const auto& [name, contact] : c.contact)
    if (!contact.rigid.empty() && index_of(c.rigid, contact.rigid) == rigid) return index_of(c.body, contact.body);
  return none;
}

std::string Scene::region_at(Index body, Real depth) const
{
  const Index rigid = main_rigid(c);
  const Spans& at = rigid == none || !rigids[rigid].bounded ? bodies[body].space : rigids[rigid].space;
  Place x = {};
  for (std::size_t d = 0; d < x.size(); ++d) x[d] = (at[d].from + at[d].to) / 2;
  const Real inside = 1e-6 * depth_of(body), top = ground.line.level() ? c.surface : ground.line.height(x[along]);
  x[up] = top - up_sign * std::clamp(depth, inside, std::max(inside, depth_of(body) - inside));
  const std::string found = region(x);
  const std::vector<RegionScene>& own = bodies[body].regions;
  const auto is = [&](const RegionScene& one) { return one.name == found; };
  if (std::any_of(own.begin(), own.end(), is)) return found;
  // Within a rigid body around which the mesh was shaped there is none: then that around it.
  for (const RegionScene& one : own)
    if (one.space[along].from <= x[along] && x[along] <= one.space[along].to && one.space[up].from <= x[up] && x[up] <= one.space[up].to)
      return one.name;
  return "";
}

Real Scene::ground_rise(Index rigid, Real from, Real to) const
{
  if (ground.line.level()) return 0;
  const Span& space = rigids[rigid].space[along];
  const Real start = (space.from + space.to) / 2;
  return ground.line.height(start + to) - ground.line.height(start + from);
}

template <int dim>
Scene scene_of(const settings::Case& c, const input::Places& places, const problem::Model<dim>& model,
               const std::vector<bodies::Particles<dim>>& particles, const std::vector<problem::LoadPointState<dim>>& load_points,
               const Cost& cost)
{
  Scene scene{c, places};
  scene.up = model.axes.up;
  scene.along = model.axes.along;
  scene.up_sign = model.axes.sign;
  scene.gravity = model.gravity.norm();
  for (int d = 0; d < dim; ++d) scene.mesh[d] = {model.mesh.lower[d], model.mesh.upper[d]};
  scene.mesh_remarks = model.mesh.remarks;
  for (const bodies::RigidBody<dim>& rigid : model.rigid_bodies) scene.rigids.push_back(rigid_scene(rigid));
  const std::vector<std::vector<Index>> cells = cells_of_bodies(c, model, particles);
  for (std::size_t b = 0; b < c.body.size(); ++b) {
    BodyScene& body = scene.bodies.emplace_back();
    body.wave_speed = model.bodies[b].waves.mean_speed;
    for (const Index cell : cells[b])
      for (const Index node : model.mesh.nodes[cell])
        for (int d = 0; d < dim; ++d) body.space[d].add(model.mesh.position[node][d]);
    body.regions = regions_of(model.mesh, cells[b]);
  }
  for (std::size_t b = 0; b < c.body.size(); ++b) scene.bodies[b].depth = depth_below_surface(c, model, scene.bodies[b].space, cells[b]);
  scene.supports = supports_of(c, model.mesh, cells);
  scene.loads = loads_of(c, model, load_points);
  scene.resolved = resolved_waves(c, model, cells);
  scene.ground = model.ground;
  scene.neighbors = neighbors_in(model.mesh, cells);
  scene.ways = ways_of(model);
  scene.stages = model.stages;
  scene.cell_size = [&model, start = std::make_shared<Index>(0)](Index rigid, const Place& moved) {
    bodies::Pose<dim> pose;
    for (int d = 0; d < dim; ++d) pose.displacement[d] = moved[d];
    return problem::cell_size_at<dim>(model, placed(model.rigid_bodies[rigid], pose), *start);
  };
  scene.region = [&model](const Place& place) {
    Vec<dim> x;
    for (int d = 0; d < dim; ++d) x[d] = place[d];
    return problem::region_at<dim>(model, x);
  };
  look_for_thin_places(model, cells, scene);
  scene.cost = cost;
  return scene;
}

template Scene scene_of(const settings::Case&, const input::Places&, const problem::Model<2>&, const std::vector<bodies::Particles<2>>&,
                        const std::vector<problem::LoadPointState<2>>&, const Cost&);
template Scene scene_of(const settings::Case&, const input::Places&, const problem::Model<3>&, const std::vector<bodies::Particles<3>>&,
                        const std::vector<problem::LoadPointState<3>>&, const Cost&);

}  // namespace berm::sanity
