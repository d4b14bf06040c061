// SPDX-License-Identifier: BSD-3-Clause
// A case file whose model is small: it is built and makes a few steps (mpm), or its elements are made (fem). What cannot be ends in InputError or
// RunError.
#include "target.hpp"

#include "fem/fem_problem.hpp"
#include "input/read_case.hpp"
#include "mpm/step.hpp"
#include "mpm/time_step.hpp"
#include "os/error.hpp"
#include "problem/stages.hpp"

using namespace berm;

namespace {

constexpr Real max_cells = 50, max_particles = 500;
constexpr const char* scratch = "/dev/shm";  // a box needs no files

Real cells_of(const mesh::BoxMesh& box)
{
  Real cells = 1;
  for (const Real count : box.cells) cells *= count;
  return cells;
}

Real particles_of(const bodies::BodySettings& body, Real cells)
{
  if (body.disk) return std::pow(body.disk->diameter / body.disk->spacing, 2);
  Real count = 1;
  if (body.block)
    for (const Real side : body.block->size) count *= std::max<Real>(1, side / body.block->spacing);
  else
    count = 6 * cells * std::max(body.particles_per_cell, 9);
  for (const auto& entry : body.region_particles_per_cell) count += 6 * cells * entry.second;
  return count;
}

bool is_small(const settings::Case& c)
{
  const auto* box = std::get_if<mesh::BoxMesh>(&c.mesh);
  if (box == nullptr || cells_of(*box) > max_cells) return false;
  Real particles = 0;
  for (const auto& entry : c.body) particles += particles_of(entry.second, cells_of(*box));
  return particles <= max_particles || c.method == settings::Method::fem;
}

template <int dim>
void make_steps(const settings::Case& c)
{
  problem::Problem<dim> problem = problem::build<dim>(c, "", scratch);
  mpm::Workspace<dim> workspace(problem.model, problem.state);
  stable_time_steps(problem.model, problem.state, workspace);
  for (int n = 0; n < 3; ++n) {
    step(problem.model, problem.state, workspace);
    stage_ended(problem.model, problem.state);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  try {
    const settings::Case c = input::read_case_text("case.toml", text_of(data, size));
    if (!is_small(c)) return 0;
    if (c.method == settings::Method::fem)
      fem::build_fem(c, "", scratch);
    else
      c.dimension() == 2 ? make_steps<2>(c) : make_steps<3>(c);
  } catch (const InputError&) {
  } catch (const RunError&) {
  }
  return 0;
}
