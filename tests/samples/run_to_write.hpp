// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/linear_elastic.hpp"
#include "mesh/box.hpp"
#include "run_folder/frame_maker.hpp"
#include "run_folder/frames.hpp"
#include "run_folder/history.hpp"
#include "samples/frame_particles.hpp"
#include "samples/history_columns.hpp"
#include "samples/temporary_folder.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace berm {

inline std::string content_of(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

inline void put(const std::filesystem::path& path, const std::string& content)
{
  std::ofstream(path, std::ios::binary) << content;
}

/// A box of 0.2 x 0.1 (x 0.05) m with one particle near the middle of each cell, in two bodies (left and right half), and a circle, a box and
/// a half-plane as rigid bodies. The particles' numbers are functions of body and id, so that a test can tell them.
template <int dim>
problem::Problem<dim> sample_problem()
{
  problem::Problem<dim> problem{};
  mesh::BoxMesh box{.lower = {0, 0, 0}, .size = {0.2, 0.1, 0.05}, .cells = {8, 4, 2}};
  box.lower.resize(dim);
  box.size.resize(dim);
  box.cells.resize(dim);
  problem::Model<dim>& model = problem.model;
  problem::State<dim>& state = problem.state;
  model.mesh = make_box<dim>(box);
  for (int body = 0; body < 2; ++body) state.particles.emplace_back(model.mesh, model.mesh.cell_count(), std::vector<FieldInfo>{});
  material::LinearElastic solid;
  solid.density = 1000;
  solid.young_modulus = 1e6;
  model.bodies.assign(2, {"body", settings::soil_of_one(solid), {}});
  for (Index cell = model.mesh.cell_count() - 1; cell >= 0; --cell) {  // backwards: storage is by cell, ids run against it
    bodies::Particle<dim> p;
    p.x = model.mesh.centroid(cell);
    const int body = p.x[0] < 0.1 ? 0 : 1;
    p.id = state.particles[body].size();
    for (int d = 0; d < dim; ++d) p.v[d] = 100 * body + p.id + 0.25 * d;
    for (int k = 0; k < tensor_size<dim>; ++k) p.stress[k] = 10 * p.id + k;
    p.volume = 1 + p.id;
    p.mass = 1;
    p.deviatoric_strain = 0.5 * p.id;
    state.particles[body].insert(cell, p);
  }
  const Vec<dim> middle = (model.mesh.lower + model.mesh.upper) / 2;
  model.rigid_bodies = {{"pipe", bodies::Circle<dim>{middle, 0.02}, 1},
                        {"block", bodies::Box<dim>{middle, Vec<dim>::Constant(0.01), Matrix<dim>::Identity()}, 1},
                        {"floor", bodies::HalfPlane<dim>{middle, Vec<dim>::UnitY()}, 1}};
  state.rigid_bodies.resize(3);
  return problem;
}

/// The frames of a problem, made and written.
template <int dim>
class SampleFrames {
public:
  SampleFrames(const std::filesystem::path& folder, const problem::Problem<dim>& problem)
      : maker_(problem.model, problem.state),
        writer_(folder, problem.model.mesh)
  {
  }
  void write(const problem::State<dim>& state) { writer_.write(last_ = maker_.make(state, std::move(last_))); }
  std::size_t count() const { return writer_.times().size(); }
  const run_folder::Frame<dim>& last() const { return last_; }

private:
  run_folder::FrameMaker<dim> maker_;
  run_folder::FrameWriter<dim> writer_;
  run_folder::Frame<dim> last_;
};

/// A square of 0.2 m of two 6-node triangles, below and above the diagonal through its origin: node 3 j + i is at (0.1 i, 0.1 j), and the
/// strain is 0 in the corner x = 0, 1 in the corner y = 0 and linear between.
inline run_folder::Frame<2> two_triangles()
{
  std::vector<run_folder::FrameParticle<2>> nodes;
  for (int k = 0; k < 9; ++k) {
    run_folder::FrameParticle<2> f{{}, 0, Vec<2>(0.001 * k, 0), {}, 0.25};
    f.particle.x = Vec<2>(0.1 * (k % 3), 0.1 * static_cast<Real>(k / 3));
    f.particle.id = k;
    f.particle.volume = 0.04 / 9;
    f.strain.deviatoric = 0.5 + (f.particle.x[0] - f.particle.x[1]) / 0.4;
    f.strain.volumetric = -0.01 * k;
    f.particle.deviatoric_strain = 2 + k;
    for (int c = 0; c < tensor_size<2>; ++c) f.particle.stress[c] = 10 * k + c;
    nodes.push_back(f);
  }
  run_folder::Frame<2> frame = frame_of(nodes);
  frame.triangles = {{0, 2, 8, 1, 5, 4}, {0, 8, 6, 4, 7, 3}};
  return frame;
}

/// The history of a pipe with D = 0.02 m that is pushed to 0.25 D with V = stiffness w and then dragged to `drag` with H = H_end tanh(u/a)
/// and w growing with u, V held; a known ripple lies on the forces, and the second impulse is a known part of V. Rows every 0.002 D.
struct SamplePipe {
  Real D = 0.02, stiffness = 4e5, H_end = 800, a = 0.004, drag = 0.5 * 0.02, ripple = 0, second = 0;

  Real H(Real u) const { return H_end * std::tanh(u / a); }
  Real w(Real u) const { return 0.25 * D + 0.2 * u; }

  void write(const std::filesystem::path& path) const
  {
    NamedHistory file(path, {"u_m", "w_m", "H_N_m", "V_N_m", "gap_m", "overlap_m", "second_impulse_N_m"});
    const Real spacing = 0.002 * D;
    Real time = 0;
    Index row = 0;
    const auto noise = [&] { return ripple * (row++ % 2 == 0 ? 1 : -1); };
    file.add(time, "settle", {0, -0.01 * D, 0, 0, 1e9, 0, 1e9});
    for (int k = -5; k <= 125; ++k, time += 0.01) {
      const Real w = k * spacing;
      file.add(time, "push", {0, w, 0, std::max<Real>(0, stiffness * w) + noise(), 1e-4, 2e-5, second * std::max<Real>(0, stiffness * w)});
    }
    const Real held = stiffness * 0.25 * D;
    for (int k = 1; k * spacing <= drag * (1 + 1e-9); ++k, time += 0.01) {
      const Real u = k * spacing;
      const Real now = noise();
      file.add(time, "drag", {u, w(u), H(u) + now, held + now, 3e-4, 1e-5, 1e3});
    }
  }
};

}  // namespace berm
