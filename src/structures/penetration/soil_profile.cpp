// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/penetration/penetration_run_test.cpp
#include "structures/penetration/soil_profile.hpp"

#include <Eigen/Core>
#include <algorithm>

namespace berm::penetration {
SoilProfile::SoilProfile(const record::RunRecord& run)
    : run_(run),
      soil_(base::touched_soil(run)),
      gravity_(
          Eigen::Map<const Eigen::VectorXd>(run.settings.gravity.data(), static_cast<Eigen::Index>(run.settings.gravity.size())).norm())
{
  if (soil_) body_ = run.settings.body[problem::index_of(run.settings.body, base::contact_of_body(run.settings)->body)].second;
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
    horizontal = body_.k0 ? *body_.k0 * soil.overburden : soil.overburden > 0 ? nan : 0;
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
  return soil_ && problem::varies(*soil_);
}

}  // namespace berm::penetration
