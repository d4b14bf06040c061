// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/summary.hpp"
#include "structures/penetration/penetration_run.hpp"

namespace berm::penetration {

/// The name of a result at a depth that is a multiple of D: "N_kt_at_z_2D".
std::string name_at(const std::string& what, Real over_D);

/// Key results, with q and N the symbols of the run ("q_t", "N_kt"):
///   q_at_z_{...}D (Pa) and N_at_z_{...}D at the depths of the penetrometer, as far as the way down came;
///   of a body around which soil flows, where there are frames, soil_above;
///   z_end (m) and z_end_over_D, the depth of the level of full width at the end, and area (m2; plane strain m), of the part that is modelled;
///   q_end and N_end, means over the last travel, N_change and N_scatter over it (of q where there is no N: q_change, q_scatter);
///   f_shaft_end (Pa), mean friction of the shaft that is in the soil, where the history tells the force on it;
///   of a footing in clay sigma_backflow_end (Pa), what the soil on it weighs at the end over the area, and N_c_end_backflow, N_c_end with that weight on it;
///   N_steady, the same mean, and z_at_N_steady, where the resistance is steady (LastTravel);
///   of a body that a drag loads after its push the point of its failure in V, H and M, where H of the first drag is largest: V_at_H_max and M_at_H_max (N m; plane strain
///   N m/m), with M about the middle of its base, counter-clockwise on the body; in clay also over A s_u and A D s_u.
std::vector<run_folder::Quantity> penetration_quantities(const PenetrationRun& run);

/// Of these the numbers that are asked of a push: where a force ended it the depth, then factor, resistance and shaft friction.
base::Headline penetration_headline(const PenetrationRun& run);

/// The names of all that a run may have of these.
std::vector<std::string> penetration_names(const Penetrometer& how);

/// log.csv of a run folder, a row of the history a line: z_m, w_m, q_Pa, factor, both again averaged (q_mean_Pa, factor_mean), f_shaft_Pa, s_u_Pa and sigma_v0_Pa; nan
/// where there is none. "" where the body did not come into the soil.
std::string log_csv(const PenetrationRun& run);

}  // namespace berm::penetration
