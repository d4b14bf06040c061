// SPDX-License-Identifier: BSD-3-Clause
#include "material/undrained.hpp"

namespace berm::material {

void check_water(Describe& d, const std::string& path, const std::optional<PoreWater>& water, const SoilForWater& soil)
{
  if (!water) return;
  const std::string table = path + ".water";
  d.check(soil.effective_stress, table,
          "is for laws of effective stress, and this one has an undrained strength, which is one of total stress: leave the table out, or "
          "take mohr_coulomb with a friction_angle, modified_cam_clay, norsand, hypoplastic or hardening_soil");
  const bool flows = water->drainage == Drainage::consolidation;
  d.check(!water->porosity || water->bulk_modulus || water->permeability || flows, table + ".porosity",
          "is needed with bulk_modulus and permeability only");
  d.check(!water->porosity || !soil.has_void_ratio, table + ".porosity", "cannot be combined with void_ratio, which gives it");
  d.check(!water->bulk_modulus || water->porosity || soil.has_void_ratio, table, "needs the porosity, which bulk_modulus requires");
  d.check(!flows || water->porosity || soil.has_void_ratio, table,
          "needs the porosity, which is required with drainage = \"consolidation\"");
  d.check(!flows || water->permeability, table, "needs the permeability, which is required with drainage = \"consolidation\"");
  d.check(water->permeability || !water->kozeny_carman, table + ".kozeny_carman", "is a law of the permeability, which is missing");
  d.check(!water->min_pressure || water->water_depth == 0, table + ".min_pressure", "cannot be combined with water_depth");
  if (water->drainage == Drainage::drained) return;
  d.check(!soil.stiffness_varies || water->bulk_modulus, table, "needs bulk_modulus, because the stiffness of the soil varies with depth");
  d.check(!soil.dilates || flows || water->min_pressure, path + ".dilation_angle",
          "dilating undrained soil never fails: the pore pressure falls, and the strength increases, until the water cavitates; take "
          "dilation_angle = 0, or give the pressure of cavitation as water.min_pressure");
}

}  // namespace berm::material
