// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/penetration/penetration_run_test.cpp
#include "structures/penetration/soil_profile.hpp"

#include "mesh/seabed.hpp"
#include "os/error.hpp"
#include "run_folder/frame_reader.hpp"

#include <Eigen/Core>
#include <algorithm>

namespace berm::penetration {

SoilProfile::SoilProfile(const record::RunRecord& run)
    : run_(run),
      soil_(base::touched_soil(run)),
      gravity_(
          Eigen::Map<const Eigen::VectorXd>(run.settings.gravity.data(), static_cast<Eigen::Index>(run.settings.gravity.size())).norm())
{
  if (soil_) body_ = run.settings.body[index_of(run.settings.body, base::contact_of_body(run.settings)->body)].second;
}

SoilAt SoilProfile::at(Real depth) const
{
  if (!soil_) return {nan, nan, nan, nan, nan, nan, nan};
  const Real deep = base::soil_depth(run_.settings, run_.ground, depth);
  const material::Material material = soil_->at("", deep);
  const std::optional<material::Strength> law = strength_at_rest(material);
  SoilAt soil{nan, law ? law->friction_angle : nan, 0, nan, nan, density(material) * gravity_, nan};
  const bool given = body_.initial_stress.size() > 1;
  Real horizontal = 0;
  if (given) {
    soil.overburden = -body_.initial_stress[1];
    horizontal = -body_.initial_stress[0];
  } else {
    soil.overburden = gravity_ * soil_->mass_above("", std::max(Real(0), deep));
    horizontal = body_.has_k0() ? *body_.k0_at(deep, soil.overburden) * soil.overburden : soil.overburden > 0 ? nan : 0;
  }
  if (!law || law->friction_angle > 0 || !(law->cohesion > 0)) return soil;
  soil.strength = law->cohesion;
  soil.anisotropy = (soil.overburden - horizontal) / (2 * soil.strength);
  soil.rigidity_index = young_poisson(material).shear_modulus() / soil.strength;
  soil.interface_ratio = base::interface_ratio(*base::contact_of_body(run_.settings), soil.strength);
  return soil;
}

bool SoilProfile::varies() const
{
  return soil_ && settings::varies(*soil_);
}

namespace {

constexpr Real near_middle = 0.1;  // of D

/// A wall through the middle of the body along one coordinate of the first frame.
Walls in_first_frame(const record::RunRecord& run, Real middle, Real width, std::vector<Real> run_folder::SavedSoil::*coordinate)
{
  if (run.folder.empty() || run.settings.geometry == settings::Geometry::axisymmetric) return {};
  try {
    const std::vector<run_folder::FrameFiles> frames = run_folder::frame_files(run.folder / "frames");
    if (frames.empty()) return {};
    const run_folder::SavedSoil soil = run_folder::read_soil(frames.front().soil);
    const std::vector<Real>& x = soil.*coordinate;
    if (x.empty()) return {};
    const auto [least, most] = std::minmax_element(x.begin(), x.end());
    Walls walls;
    if (std::abs(*least - middle) < near_middle * width) walls.left = middle;
    if (std::abs(*most - middle) < near_middle * width) walls.right = middle;
    return walls;
  } catch (const RunError&) {
    return {};  // the page says so where it shows the frames
  }
}

}  // namespace

Walls walls_of(const record::RunRecord& run, const base::BodyProfile& body)
{
  const mesh::MeshSettings& mesh = run.settings.mesh;
  if (const auto* bed = std::get_if<mesh::SeabedMesh>(&mesh)) {
    const mesh::SeabedLayout layout = layout_of(*bed);
    return {layout.left, layout.right, bed->depth > 0 ? -bed->depth : -infinity};
  }
  if (const auto* box = std::get_if<mesh::BoxMesh>(&mesh)) {
    const Vec<2> lower = bodies::to_vec<2>(box->lower), size = bodies::to_vec<2>(box->size);
    return {lower[0], lower[0] + size[0], lower[1]};
  }
  return in_first_frame(run, (body.left + body.right) / 2, body.width, &run_folder::SavedSoil::x);
}

Real part_in_space(const record::RunRecord& run, const base::BodyProfile& body, Real z)
{
  const Real middle = (body.left + body.right) / 2;
  Walls along, across;
  if (const auto* box = std::get_if<mesh::BoxMesh>(&run.settings.mesh)) {
    const Vec<3> lower = bodies::to_vec<3>(box->lower), upper = lower + bodies::to_vec<3>(box->size);
    along = {lower[0], upper[0]}, across = {lower[2], upper[2]};
  } else {
    along = in_first_frame(run, middle, body.width, &run_folder::SavedSoil::x);
    across = in_first_frame(run, z, body.width, &run_folder::SavedSoil::z);
  }
  const std::vector<std::string>& whole_across = run.settings.symmetry;
  const auto cut = [&](const Walls& walls, Real at, const char* axis) {
    const bool mirrored = std::find(whole_across.begin(), whole_across.end(), axis) != whole_across.end();
    return !mirrored && std::min(std::abs(walls.left - at), std::abs(walls.right - at)) < near_middle * body.width;
  };
  return (cut(along, middle, "x") ? 0.5 : 1) * (cut(across, z, "z") ? 0.5 : 1);
}

}  // namespace berm::penetration
