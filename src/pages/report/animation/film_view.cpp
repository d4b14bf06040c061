// SPDX-License-Identifier: BSD-3-Clause
#include "report/animation/film_view.hpp"

#include "structures/base/driven_body.hpp"

#include <algorithm>

namespace berm::report {
namespace {

// Around the body's path, over its width: to the sides of its centre, below and above its lowest point.
constexpr Real beside = 2.5, below = 2, above = 1.3;

/// How high soil can rise; infinite where the settings do not tell.
Real top_of(const mesh::MeshSettings& mesh)
{
  if (const auto* seabed = std::get_if<mesh::SeabedMesh>(&mesh)) return seabed->headroom;
  if (const auto* box = std::get_if<mesh::BoxMesh>(&mesh)) return (box->lower.empty() ? 0 : box->lower[1]) + box->size[1];
  return infinity;
}

/// Centre (x) and lowest point (y) of a body at the start, m.
template <int dim>
Vec<2> start_of(const bodies::RigidShapeSettings& settings)
{
  const bodies::RigidShape<dim> shape = make_shape<dim>(settings);
  return {center_of<dim>(shape)[0], lowest_level<dim>(shape, Vec<dim>::UnitY())};
}

/// The box of the centres (x) and lowest points (y) of the driven body.
FilmBox path_of(const record::RunRecord& run)
{
  const bodies::RigidShapeSettings& shape = run.settings.rigid[main_rigid(run.settings)].second.shape;
  const Vec<2> start = run.settings.dimension() == 2 ? start_of<2>(shape) : start_of<3>(shape);
  FilmBox path{start, start};
  if (!run.history.has("u_m") || !run.history.has("w_m")) return path;
  const std::vector<Real>&u = run.history["u_m"], &w = run.history["w_m"];
  for (std::size_t row = 0; row < u.size(); ++row) {
    const Vec<2> now(start[0] + u[row], run.surface_at(start[0] + u[row]) - w[row]);
    if (!now.allFinite()) continue;
    path.lower = path.lower.cwiseMin(now);
    path.upper = path.upper.cwiseMax(now);
  }
  return path;
}

}  // namespace

FilmBox film_view(const record::RunRecord& run, const FilmBox& soil)
{
  const Real D = base::body_scale(run.settings).width;
  if (!(D > 0)) return soil;
  const FilmBox path = path_of(run);
  const Real level = run.ground.line.level() ? run.settings.surface : run.ground.line.heights(path.lower[0], path.upper[0]).second;
  const Real highest = std::max(path.lower[1], std::min(path.upper[1], level));  // it may start far above the soil
  FilmBox view{Vec<2>(path.lower[0] - beside * D, path.lower[1] - below * D), Vec<2>(path.upper[0] + beside * D, highest + above * D)};
  view.lower = view.lower.cwiseMax(soil.lower);
  view.upper[0] = std::min(view.upper[0], soil.upper[0]);
  view.upper[1] = std::min(view.upper[1], std::max(soil.upper[1], top_of(run.settings.mesh)));
  const bool seen = (view.lower.array() < view.upper.array()).all();
  return seen ? view : soil;
}

std::optional<Real> film_surface(const record::RunRecord& run)
{
  const settings::Case& settings = run.settings;
  if (!run.ground.line.level()) return {};
  const bool flat = std::any_of(settings.body.begin(), settings.body.end(), [](const auto& body) { return body.second.has_k0(); });
  if (flat || std::holds_alternative<mesh::SeabedMesh>(settings.mesh)) return settings.surface;
  return {};
}

}  // namespace berm::report
