// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/trust_measure.hpp"

namespace berm::base {

/// Where the energies balance worst.
struct EnergyError {
  Real over_work;     ///< the largest error over the largest work, as summary.json has it, else as the history has it
  std::string where;  ///< "drag, u = 18 mm"; "" where it is not known
};
EnergyError energy_error(const record::RunRecord& run);

/// The energy that contact (friction_J_m) gave in all, where it should take some, over the largest work; 0 where it took some, NaN without a history.
Real work_of_contact(const record::RunRecord& run);

/// A quantity's value, NaN where there is none.
Real quantity_value(const record::RunRecord& run, const std::string& name);

/// Whether a material of the run has a strength.
bool has_soil(const record::RunRecord& run);

/// Energy that does not balance.
TrustMeasure energy_balance(settings::Method method);

/// What keeps soil still takes: the velocity filter, the bulk viscosity, and local damping while a body is driven.
TrustMeasures energy_that_the_method_takes();

/// The out-of-balance force after the geostatic stage; `when` ends the sentence "the bed was out of balance by ... of its weight".
TrustMeasure balance_after_geostatic(const std::string& when);

/// The soil at the bounds of its volume and in the air; momentum that does not balance.
TrustMeasures soil_volumes();
TrustMeasure soil_at_largest_volume();
TrustMeasure momentum_balance();

/// What friction shear bands can lose that are as wide as the cells make them.
TrustMeasure shear_bands();
/// The friction of the cells that shear, of soil whose bands have a width of their own.
TrustMeasure friction_of_cells();

/// How well the increments of finite elements were solved.
TrustMeasures convergence();

/// A number of the summary's timing, told and not judged.
TrustMeasure counted(const char* what, const char* timing);

}  // namespace berm::base
