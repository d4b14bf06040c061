// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/start/soils_test.cpp
#include "start/soils.hpp"

namespace berm::start {

const std::vector<Soil>& soils()
{
  static const std::vector<Soil> all = {
      {"kaolin", "clay", "Kaolin, lightly overconsolidated, of a beam centrifuge: s_u = 2.3 kPa + 3.6 kPa/m z, sensitivity 3.2.",
       "Dingle, White and Gaudin (2008), Mechanisms of pipe embedment and lateral breakout on soft clay, Can. Geotech. J. 45, 636-652.",
       "Strength, sensitivity and weight are theirs, measured by T-bars. G / s_u, the ductility and the saturated density are usual values, not measured.",
       R"(law = "clay"
submerged_unit_weight = "6.5 kN/m^3"
inertia_density = "1690 kg/m^3"
rigidity_index = 100
poisson_ratio = 0.45
undrained_strength = "2.3 kPa"          # <- s_u at the seabed
undrained_strength_gradient = "3.6 kPa/m"
sensitivity = 3.2
ductility = 20
)"},
      {"silica-medium", "sand", "Quartz sand of a relative density of 50 %: phi = 38 deg, psi = 6 deg at a mean stress of 100 kPa.",
       "Bolton (1986), The strength and dilatancy of sands, Geotechnique 36, 65-78: 33 deg at the critical state, and 3 I_R = 3 (0.5 (10 - ln 100) - 1) = 5 deg beyond.",
       "The strength of a small strain. Soil that is dragged far comes to the 33 deg of the critical state: run that, too. E is a usual value.",
       R"(law = "mohr_coulomb"
submerged_unit_weight = "9.5 kN/m^3"
inertia_density = "1970 kg/m^3"
young_modulus = "15 MPa"                # <-
poisson_ratio = 0.3
friction_angle = "38 deg"               # <-
dilation_angle = "6 deg"                # <- 0.8 psi = phi - 33 deg
cohesion = "50 Pa"                      # keeps grains at the surface together
)"},
  };
  return all;
}

}  // namespace berm::start
