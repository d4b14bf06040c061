// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "soil_fit/fit_settings.hpp"

namespace berm::soil_fit {

/// What is asked of berm fit LAW TESTS.csv.
struct UsualFit {
  std::string law;
  std::vector<std::filesystem::path> files;
  std::string kind = "triaxial";
  bool undrained = false, extends = false;
  std::optional<Real> k0 = {};  ///< of oedometers and simple shear
  std::string diameter = {};    ///< of a penetrometer, with its unit
};

/// The laws that it knows usual numbers of.
std::vector<std::string> usual_laws();

/// The input of a fit with the usual numbers of the law, of which those are free that such tests tell, within the usual bounds. Throws InputError.
std::string usual_fit(const UsualFit& request);

}  // namespace berm::soil_fit
