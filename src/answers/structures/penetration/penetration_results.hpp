// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/summary.hpp"
#include "structures/penetration/penetration_run.hpp"

namespace berm::penetration {

/// The name of a result at a depth that is a multiple of D: "N_kt_at_z_2D".
std::string name_at(const std::string& what, Real over_D);

/// Key results, with q and N the symbols of the reading ("q_t", "N_kt"):
///   q_at_z_{...}D (Pa) and N_at_z_{...}D at the reading's depths, as far as the way down came;
///   z_end (m) and z_end_over_D, the depth of the level of full width at the end;
///   q_end and N_end, means over the last travel, N_change and N_scatter over it (of q where there is no N: q_change, q_scatter);
///   of a footing in clay sigma_backflow_end (Pa), what the soil on it weighs at the end over the area, and N_c_end_backflow, N_c_end with that weight on it;
///   N_steady, the same mean, and z_at_N_steady, where the resistance is steady (LastTravel);
///   f_shaft_end (Pa), mean friction of the shaft that is in the soil, where the history tells the force on it;
///   area (m2; plane strain m), of the part that is modelled;
///   soil_above, of a body around which soil flows, where there are frames.
std::vector<run_folder::Quantity> penetration_quantities(const PenetrationRun& run);

/// Of a body that a drag loads after its push: the point of its failure in V, H and M, where H of the first drag is largest: V_at_H_max and M_at_H_max (N m; plane strain
/// N m/m), with M about the middle of its base, counter-clockwise on the body; in clay also over A s_u and A D s_u (V_at_H_max_over_As_u, H_max_over_As_u,
/// M_at_H_max_over_ADs_u).
std::vector<run_folder::Quantity> failure_point(const PenetrationRun& run);

/// The names of all that a run may have of both.
std::vector<std::string> penetration_names(const Reading& reading);

/// The same as a table of the log.
std::string penetration_table(const std::vector<run_folder::Quantity>& quantities, const Reading& reading);

/// log.csv of a run folder, a row of the history a line: z_m, w_m, q_Pa, factor, both again averaged (q_mean_Pa, factor_mean), f_shaft_Pa, s_u_Pa and sigma_v0_Pa; nan
/// where there is none. "" where the body did not come into the soil.
std::string log_csv(const PenetrationRun& run);

/// Whether a quantity is one of a reading: of its resistance, its factors, or their place.
bool is_of_reading(const std::string& name, const Reading& reading);

}  // namespace berm::penetration
