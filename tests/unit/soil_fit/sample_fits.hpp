// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "soil_fit/fit_soil.hpp"
#include "soil_fit/simulate.hpp"

#include <random>

namespace berm::soil_fit {

/// A law with values that are known, and a fit that begins elsewhere.
struct SampleLaw {
  const char *name, *keys, *free;
  Values truth;
  bool drained = true;
};

inline const std::vector<SampleLaw>& sample_laws()
{
  static const std::vector<SampleLaw> all = {
      {"mohr_coulomb",
       "law = \"mohr_coulomb\"\ndensity = 1000\nyoung_modulus = \"30 MPa\"\npoisson_ratio = 0.3\nfriction_angle = \"30 "
       "deg\"\ndilation_angle = \"2 deg\"\n",
       "[[free]]\nkey = \"young_modulus\"\nfrom = \"1 MPa\"\nto = \"100 MPa\"\n[[free]]\nkey = \"friction_angle\"\nfrom = \"20 deg\"\nto = "
       "\"45 "
       "deg\"\n[[free]]\nkey = \"dilation_angle\"\nfrom = \"0 deg\"\nto = \"15 deg\"\n",
       {{"young_modulus", 18e6}, {"friction_angle", 36 * pi / 180}, {"dilation_angle", 6 * pi / 180}}},
      {"modified_cam_clay",
       "law = \"modified_cam_clay\"\ndensity = 1000\ncritical_friction_angle = \"22 deg\"\ncompression_index = 0.2\nswelling_index = "
       "0.05\nvoid_ratio = 1.1\noverconsolidation_ratio = 1.3\npoisson_ratio = 0.25\nmax_pressure = \"2 MPa\"\n",
       "[[free]]\nkey = \"critical_friction_angle\"\nfrom = \"15 deg\"\nto = \"35 deg\"\n[[free]]\nkey = \"compression_index\"\nfrom = "
       "0.06\nto = 0.4\n[[free]]\nkey = \"swelling_index\"\nfrom = 0.005\nto = 0.055\n",
       {{"critical_friction_angle", 25 * pi / 180}, {"compression_index", 0.14}, {"swelling_index", 0.02}}},
      {"norsand",
       "law = \"norsand\"\ndensity = 1000\ncritical_friction_angle = \"31 deg\"\ncritical_void_ratio = 0.9\ncritical_line_slope = "
       "0.03\nvolumetric_coupling = 0.3\ndilatancy = 3\nhardening_modulus = 100\nvoid_ratio = 0.72\nrigidity = 300\npoisson_ratio = "
       "0.2\nmax_pressure = \"2 MPa\"\n",
       "[[free]]\nkey = \"critical_friction_angle\"\nfrom = \"28 deg\"\nto = \"36 deg\"\n[[free]]\nkey = \"critical_void_ratio\"\nfrom = "
       "0.8\nto = 1.1\n[[free]]\nkey = \"dilatancy\"\nfrom = 1.5\nto = 6\n[[free]]\nkey = \"hardening_modulus\"\nfrom = 30\nto = 400\n",
       {{"critical_friction_angle", 33 * pi / 180}, {"critical_void_ratio", 0.95}, {"dilatancy", 3.8}, {"hardening_modulus", 160}}},
      {"hypoplastic",
       "law = \"hypoplastic\"\ndensity = 1000\ncritical_friction_angle = \"31 deg\"\ngranular_hardness = \"2 GPa\"\nhardness_exponent = "
       "0.3\nmin_void_ratio = 0.6\ncritical_void_ratio = 0.95\nmax_void_ratio = 1.15\ndilatancy_exponent = 0.1\nstiffness_exponent = "
       "1.2\nvoid_ratio = 0.75\nmax_pressure = \"2 MPa\"\n",
       "[[free]]\nkey = \"critical_friction_angle\"\nfrom = \"28 deg\"\nto = \"36 deg\"\n[[free]]\nkey = \"granular_hardness\"\nfrom = "
       "\"100 MPa\"\nto = \"20 GPa\"\n[[free]]\nkey = \"critical_void_ratio\"\nfrom = 0.85\nto = 1.1\n",
       {{"critical_friction_angle", 33 * pi / 180}, {"granular_hardness", 4e9}, {"critical_void_ratio", 0.99}}},
      {"hardening_soil",
       "law = \"hardening_soil\"\ndensity = 1000\nfriction_angle = \"33 deg\"\ndilation_angle = \"3 deg\"\nsecant_modulus = \"20 "
       "MPa\"\noedometer_modulus "
       "= \"20 MPa\"\nunloading_modulus = \"80 MPa\"\nstiffness_exponent = 0.4\npoisson_ratio = 0.2\nmax_pressure = \"2 MPa\"\n",
       "[[free]]\nkey = \"secant_modulus\"\nfrom = \"10 MPa\"\nto = \"60 MPa\"\n[[free]]\nkey = \"stiffness_exponent\"\nfrom = 0.2\nto = "
       "0.9\n[[free]]\nkey = \"friction_angle\"\nfrom = \"28 deg\"\nto = \"42 deg\"\n[[free]]\nkey = \"dilation_angle\"\nfrom = \"0 "
       "deg\"\nto = "
       "\"12 deg\"\n",
       {{"secant_modulus", 28e6}, {"stiffness_exponent", 0.55}, {"friction_angle", 36 * pi / 180}, {"dilation_angle", 6 * pi / 180}}},
      {"clay",
       "law = \"clay\"\ndensity = 1000\nyoung_modulus = \"3 MPa\"\npoisson_ratio = 0.49\nundrained_strength = \"20 kPa\"\nsensitivity = "
       "3\nductility = 0.5\n",
       "[[free]]\nkey = \"young_modulus\"\nfrom = \"1 MPa\"\nto = \"10 MPa\"\n[[free]]\nkey = \"undrained_strength\"\nfrom = \"5 kPa\"\nto "
       "= \"60 "
       "kPa\"\n[[free]]\nkey = \"ductility\"\nfrom = 0.1\nto = 2\n",
       {{"young_modulus", 4.5e6}, {"undrained_strength", 31e3}, {"ductility", 0.3}},
       false},
      {"ngi_adp",
       "law = \"ngi_adp\"\ndensity = 1000\nrigidity_index = 250\npoisson_ratio = 0.49\nundrained_strength = \"20 kPa\"\ndss_ratio = "
       "0.7\npassive_ratio = "
       "0.45\nactive_failure_strain = 0.01\ndss_failure_strain = 0.05\npassive_failure_strain = 0.08\n",
       "[[free]]\nkey = \"rigidity_index\"\nfrom = 100\nto = 1000\n[[free]]\nkey = \"undrained_strength\"\nfrom = \"5 kPa\"\nto = \"60 "
       "kPa\"\n[[free]]\nkey = \"active_failure_strain\"\nfrom = 0.005\nto = 0.1\n",
       {{"rigidity_index", 400}, {"undrained_strength", 31e3}, {"active_failure_strain", 0.03}},
       false}};
  return all;
}

/// A fit of a law to triaxial tests (test_from), which begins at its keys with these values.
inline FitCase fit_of(const SampleLaw& law, const Values& begin = {})
{
  std::vector<std::string> overrides;
  for (const auto& [key, value] : begin) overrides.push_back("material.soil." + key + "=" + std::to_string(value));
  return read_fit_text(
      "case.toml",
      std::string("starts = 1\nlargest_step = 0.002\n[material.soil]\n") + law.keys + law.free +
          "[[measured]]\nname = \"none\"\nfile = \"none.csv\"\nkind = \"triaxial\"\ndrained = " + (law.drained ? "true" : "false") + "\n",
      ".", overrides);
}

/// Strains of a triaxial test to 12 % as a laboratory logs them: rows denser at small strains, and an unloading and reloading by 0.25 % at 4 %.
inline std::vector<Real> logged_strains()
{
  std::vector<Real> strains = {0};
  constexpr int early = 24, loop = 12, late = 16;
  for (int row = 0; row < early; ++row) strains.push_back(2e-4 * std::pow(200, static_cast<Real>(row) / (early - 1)));
  for (int row = 1; row <= 2 * loop; ++row) strains.push_back(0.04 - 0.0025 * (1 - std::abs(row - loop) / static_cast<Real>(loop)));
  for (int row = 1; row <= late; ++row) strains.push_back(0.04 + 0.08 * row / late);
  return strains;
}

/// A triaxial test with the numbers that the law has with the values of the truth.
inline MeasuredTest test_from(const FitCase& c, const SampleLaw& law, Real confining_stress)
{
  MeasuredTest test;
  test.name = "test_" + std::to_string(static_cast<int>(confining_stress / 1e3));
  test.settings.name = test.name;
  test.settings.kind = element::Triaxial{{.confining_stress = confining_stress}, law.drained};
  test.driven = logged_strains();
  test.curves = {{Compared::q, {}}};
  if (law.drained) test.curves.push_back({Compared::volumetric_strain, {}});
  for (MeasuredCurve& curve : test.curves) curve.values.assign(test.rows(), 0);
  const auto values = simulate(test, material_with(c, law.truth), c.largest_step);
  for (std::size_t k = 0; k < test.curves.size(); ++k) test.curves[k].values = values[k];
  return test;
}

/// Noise of a part of the largest of each curve.
inline void add_noise(MeasuredTest& test, Real part, std::mt19937_64& random)
{
  for (MeasuredCurve& curve : test.curves) {
    Real most = 0;
    for (const Real x : curve.values) most = std::max(most, std::abs(x));
    std::normal_distribution<Real> noise(0, part * most);
    for (Real& x : curve.values) x += noise(random);
  }
}

}  // namespace berm::soil_fit
