// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/start/soils_test.cpp
#include "start/soils.hpp"

namespace berm::start {

const std::vector<Soil>& soils()
{
  static const std::vector<Soil> all = {
      {"kaolin", "clay", "Kaolin of a beam centrifuge, lightly overconsolidated: s_u = 2.3 kPa + 3.6 kPa/m z, sensitivity 3.2.",
       "Dingle, White and Gaudin (2008), Mechanisms of pipe embedment and lateral breakout on soft clay, Can. Geotech. J. 45, 636-652.",
       "Strength, sensitivity and unit weight of their model bed, at prototype scale. G / s_u, ductility and the saturated "
       "density are usual values, not of the paper.",
       R"(law = "clay"
submerged_unit_weight = "6.5 kN/m^3"
inertia_density = "1690 kg/m^3"
rigidity_index = 100                    # G / s_u
poisson_ratio = 0.45
undrained_strength = "2.3 kPa"          # <- s_u at the seabed
undrained_strength_gradient = "3.6 kPa/m"
sensitivity = 3.2
ductility = 20                          # plastic shear strain after which 95 % of the softening has occurred
)"},
      {"soft-clay-gulf", "clay", "Soft clay of the type of the deep Gulf of Mexico: s_u = 2 kPa + 1.5 kPa/m z, sensitivity 3.",
       "Jeanjean (2009), Re-assessment of p-y curves for soft clays from centrifuge testing and finite element modeling, OTC 20158: s_u = "
       "0.25 sigma_v0 where normally consolidated, here with 6 kN/m3.",
       "Typical, not a site: 0.25 is as later programs quote the paper; strength at the seabed, unit weight, sensitivity, ductility and G "
       "/ "
       "s_u are usual values. For a first look.",
       R"(law = "clay"
submerged_unit_weight = "6 kN/m^3"
inertia_density = "1620 kg/m^3"
rigidity_index = 100                    # G / s_u
poisson_ratio = 0.45
undrained_strength = "2 kPa"          # <- s_u at the seabed
undrained_strength_gradient = "1.5 kPa/m"
sensitivity = 3
ductility = 20                          # plastic shear strain after which 95 % of the softening has occurred
)"},
      {"loose-silica", "sand", "Loose quartz sand, relative density 30 %: phi = 35 deg, psi = 2 deg at a mean stress of 100 kPa.",
       "Bolton (1986), The strength and dilatancy of sands, Geotechnique 36, 65-78: 33 deg at the critical state, and 3 I_R = 3 (0.3 (10 - "
       "ln 100) - 1) = 1.9 deg = 0.8 psi beyond.",
       "A correlation within 2 deg, for small strains: at large strains sand reaches 33 deg; run that, too. Unit weight and E "
       "are usual values, not of the paper.",
       R"(law = "mohr_coulomb"
submerged_unit_weight = "9 kN/m^3"
inertia_density = "1930 kg/m^3"
young_modulus = "8 MPa"               # <-
poisson_ratio = 0.3
friction_angle = "35 deg"            # <-
dilation_angle = "2 deg"            # <-
cohesion = "50 Pa"                      # keeps grains at the surface together
)"},
      {"medium-silica", "sand", "Medium dense quartz sand, relative density 50 %: phi = 38 deg, psi = 6 deg at a mean stress of 100 kPa.",
       "Bolton (1986), The strength and dilatancy of sands, Geotechnique 36, 65-78: 33 deg at the critical state, and 3 I_R = 3 (0.5 (10 - "
       "ln 100) - 1) = 5.1 deg = 0.8 psi beyond.",
       "A correlation within 2 deg, for small strains: at large strains sand reaches 33 deg; run that, too. Unit weight and E "
       "are usual values, not of the paper.",
       R"(law = "mohr_coulomb"
submerged_unit_weight = "9.5 kN/m^3"
inertia_density = "1970 kg/m^3"
young_modulus = "15 MPa"               # <-
poisson_ratio = 0.3
friction_angle = "38 deg"            # <-
dilation_angle = "6 deg"            # <-
cohesion = "50 Pa"                      # keeps grains at the surface together
)"},
      {"dense-silica", "sand", "Dense quartz sand, relative density 80 %: phi = 43 deg, psi = 12 deg at a mean stress of 100 kPa.",
       "Bolton (1986), The strength and dilatancy of sands, Geotechnique 36, 65-78: 33 deg at the critical state, and 3 I_R = 3 (0.8 (10 - "
       "ln 100) - 1) = 9.9 deg = 0.8 psi beyond.",
       "A correlation within 2 deg, for small strains: at large strains sand reaches 33 deg; run that, too. Unit weight and E "
       "are usual values, not of the paper.",
       R"(law = "mohr_coulomb"
submerged_unit_weight = "10.2 kN/m^3"
inertia_density = "2050 kg/m^3"
young_modulus = "30 MPa"               # <-
poisson_ratio = 0.3
friction_angle = "43 deg"            # <-
dilation_angle = "12 deg"            # <-
cohesion = "50 Pa"                      # keeps grains at the surface together
)"},
      {"calcareous", "sand", "Calcareous sand of a centrifuge test: phi = 35 deg, c = 0, E = 7 MPa.",
       "Maglia, Pinyol and Hoffman, Material Point Method modelling of offshore unburied cable/pipe interacting with soil: phi, c, E, nu "
       "and unit weight.",
       "The dilation angle is not published: 0 here. Grain crushing under large stresses is not in this law; examples/probe_test "
       "compares with the test.",
       R"(law = "mohr_coulomb"
submerged_unit_weight = "8.6 kN/m^3"
inertia_density = "1880 kg/m^3"
young_modulus = "7 MPa"               # <-
poisson_ratio = 0.25
friction_angle = "35 deg"            # <-
dilation_angle = "0 deg"            # <-
cohesion = "50 Pa"                      # keeps grains at the surface together
)"},
  };
  return all;
}

}  // namespace berm::start
