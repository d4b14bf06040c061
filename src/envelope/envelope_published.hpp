// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "envelope/envelope_table.hpp"
#include "formulas/formula.hpp"

namespace berm::envelope {

/// A published curve or point, N/m.
struct PublishedCurve {
  std::string title;  ///< with its label, and its range where the pipe is not in it
  std::vector<Real> V, H;
};

/// A published number, N/m.
struct PublishedNumber {
  std::string name;
  formulas::Formula formula;
};

/// What is published for the pipe and the soil of a case.
struct Published {
  Real unit = 0;          ///< N/m that forces are divided by to be compared; 0: none
  std::string unit_name;  ///< as people write it
  std::vector<PublishedCurve> curves;
  std::vector<PublishedNumber> numbers;
  std::string remark;  ///< why there is nothing, or what is left out
};

/// For clay (Mohr-Coulomb without friction) the fits for a pipe wished in place, the buoyancy gamma' A of the clay that it takes the place of added
/// to V; at w = D/2 also the bounds of Murff and others. For sand (without cohesion) the tabulated V_max, and Zhang's surface fitted to the probes'
/// ends with their own V_max.
Published published_for(const problem::Case& c, const std::vector<EnvelopeRow>& rows);

}  // namespace berm::envelope
