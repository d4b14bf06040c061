// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/space_steps.hpp"
#include "mesh/box.hpp"
#include "samples/fem_sample_problem.hpp"

namespace berm {

/// A block 0 < x, z < 1 m, -1 m < y < 0 of Kuhn's tetrahedra, on a fixed base between rollers, and nothing else.
inline settings::Case block_in_space(const material::Material& soil, Real cells = 2)
{
  settings::Case c = block_of(soil);
  c.geometry = settings::Geometry::space;
  c.surface = 0;
  mesh::BoxMesh box;
  box.lower = {0, -1, 0};
  box.size = {1, 1, 1};
  box.cells = {cells, cells, cells};
  c.mesh = box;
  c.support = {{"left", {"left", {"x"}}},
               {"right", {"right", {"x"}}},
               {"back", {"back", {"z"}}},
               {"front", {"front", {"z"}}},
               {"base", {"bottom", {"x", "y", "z"}}}};
  return c;
}

inline fem::SpaceProblem space_problem_of(const settings::Case& c)
{
  return fem::build_in_space(c, mesh::make_box<3>(std::get<mesh::BoxMesh>(c.mesh)));
}

/// The places of `inside` cells from 0 to R = 1 m whose sizes fall by `ratio`, and of cells from there to `far` that grow by a factor each.
inline std::vector<Real> graded(int inside, Real ratio, Real growth, Real far)
{
  std::vector<Real> at{0};
  Real size = 1;
  for (int k = 0; k < inside; ++k, size /= ratio) at.push_back(at.back() + size);
  for (Real& x : at) x /= at[static_cast<std::size_t>(inside)];
  Real step = at[static_cast<std::size_t>(inside)] - at[static_cast<std::size_t>(inside) - 1];
  const auto first = static_cast<std::ptrdiff_t>(at.size());
  while (at.back() < far) at.push_back(at.back() + step), step *= growth;
  const Real stretch = (far - 1) / (at.back() - 1);
  std::for_each(at.begin() + first, at.end(), [&](Real& x) { x = 1 + (x - 1) * stretch; });
  return at;
}

/// A quarter of a disk of R = 1 m, or of a square of that half width, tied to the ground at y = 0, and pushed down at 1 m/s.
struct SpaceFooting {
  bool square = false;
  int cells = 4;       ///< across R
  Real ratio = 1.5;    ///< of their sizes from each to the next towards the edge
  Real growth = 1.25;  ///< of the cells outside
  Real far = 3;        ///< m, where the soil ends, and how deep
  material::Material soil;

  settings::Case settings() const
  {
    settings::Case c = block_in_space(soil, 1);
    c.symmetry = {"x", "z"};
    c.support = {{"right", {"right", {"x", "z"}}}, {"front", {"front", {"x", "z"}}}, {"base", {"bottom", {"x", "y", "z"}}}};
    bodies::RigidSettings footing;
    if (square)
      footing.shape = bodies::BoxSettings{{0, 0.5, 0}, {2, 1, 2}};
    else
      footing.shape = bodies::CylinderSettings{{0, 0.5, 0}, {0, 1, 0}, 2, 1};
    footing.mass = 1;
    c.rigid = {{"footing", footing}};
    contact::ContactSettings base;
    base.body = "block";
    base.rigid = "footing";
    base.scheme = contact::Scheme::tied;
    c.contact = {{"base", base}};
    c.stage = {pushing()};
    return c;
  }

  mesh::Mesh<3> mesh() const
  {
    const std::vector<Real> r = graded(cells, ratio, growth, far);
    std::vector<Real> depth{0};
    Real step = r[static_cast<std::size_t>(cells)] - r[static_cast<std::size_t>(cells) - 1];
    while (depth.back() < far) depth.push_back(depth.back() + step), step *= growth;
    const Real stretch = far / depth.back();
    const int n = static_cast<int>(r.size()) - 1, m = static_cast<int>(depth.size()) - 1;
    mesh::BoxMesh box;
    box.lower = {0, 0, 0};
    box.size = {static_cast<Real>(n), static_cast<Real>(m), static_cast<Real>(n)};
    box.cells = box.size;
    mesh::Mesh<3> made = mesh::make_box<3>(box);
    for (Vec<3>& x : made.position) {
      const auto i = static_cast<std::size_t>(std::lround(x[0])), j = static_cast<std::size_t>(std::lround(x[1])),
                 k = static_cast<std::size_t>(std::lround(x[2]));
      const Real y = -depth[static_cast<std::size_t>(m) - j] * stretch;
      if (square) {
        x = {r[i], y, r[k]};
        continue;
      }
      const std::size_t ring = std::max(i, k);
      const Real u = static_cast<Real>(i), v = static_cast<Real>(k);
      const Real angle = ring == 0 ? 0 : i >= k ? pi / 4 * v / u : pi / 2 - pi / 4 * u / v;
      x = {i == 0 ? 0 : r[ring] * std::cos(angle), y, r[ring] * std::sin(angle)};
    }
    made.complete();
    return made;
  }

  fem::SpaceProblem problem() const { return fem::build_in_space(settings(), mesh()); }
};

}  // namespace berm
