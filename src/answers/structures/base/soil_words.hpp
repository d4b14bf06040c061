// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/body_soil.hpp"
#include "settings/case.hpp"
#include "settings/drainage.hpp"
#include "structures/base/chart.hpp"
#include "structures/base/driven_body.hpp"

namespace berm::base {

/// The layers of a soil downwards, or its regions: "\"sand\", from 5 mm down \"clay\"".
std::string layers_in_words(const settings::BodySoil& soil);

/// A fill or an excavation in words: "fill backfill of sand, in stage \"backfill\", 3 lifts in 2 s".
struct EarthworkWords {
  const bodies::EarthworkSettings& settings;
  std::string body, material;  ///< material "": it takes soil out
  std::string words;
};
std::vector<EarthworkWords> earthworks_in_words(const settings::Case& c);

/// K0 in words: "0.5", or "0.62 by OCR = 2" of one; where it varies with depth what it follows from: "by POP = 30 kPa".
std::string k0_in_words(const bodies::K0Settings& at_rest, Real sin_friction);

/// What `berm check` says of K0 that follows from the stress history, line by line.
std::vector<std::string> k0_words(const settings::Case& c);

/// What `berm check` says of bodies whose soil varies, line by line: their layers or regions, and strength and stiffness at the surface and at the lowest
/// point that the main rigid body reaches in a push.
std::vector<std::string> soil_words(const settings::Case& c);

/// What `berm check` says of a case whose water flows, line by line: c_v, and v D / c_v or T = c_v t / D^2 of each stage, and whether inertia is
/// small in it.
std::vector<std::string> drainage_words(const settings::Case& c);

/// "drained", "partially drained" or "undrained" at v D / c_v.
const char* drainage_word(Real number);

/// What the inertia of the soil is measured by, and whether it is small: "density v2 is 0.0035 of the strength: inertia is small".
std::string inertia_words(const settings::StageInertia& inertia);

/// How a stage at rest consolidated, as the history tells.
struct Dissipation {
  std::string stage;
  Real time;    ///< s, how long it took
  Real degree;  ///< U at its end
  Real t50;     ///< s since its begin, when U was 0.5 first; NaN where it was not
  Real T, T50;  ///< c_v t / D^2 of the two; NaN without a body of width D
};
/// Of all stages that move nothing and have an excess pore pressure.
std::vector<Dissipation> dissipation_of(const record::RunRecord& run);
/// The degree of consolidation over time, a curve for each of these stages; none without them.
Charts dissipation_charts(const record::RunRecord& run);

/// The effective normal force on a body that rubs on soil with water, at the end of a stage: means over its last twentieth.
struct SurfaceForce {
  std::string stage;
  Real w;      ///< m, embedment
  Real N_eff;  ///< N/m or N, integral of the effective normal stress over the surface
  Real V;      ///< N/m or N, vertical reaction
};
/// Of all stages but geostatic ones, where the history has it.
std::vector<SurfaceForce> surface_forces_of(const record::RunRecord& run);

/// The same for the summary: U_of_STAGE and, where they are known, t50_of_STAGE and T50_of_STAGE.
std::vector<run_folder::Quantity> dissipation_quantities(const record::RunRecord& run);

/// The mass that each fill of a run has placed, and that which its area had room for, by the end of its history: FILL_mass and FILL_expected_mass.
std::vector<run_folder::Quantity> fill_quantities(const record::RunRecord& run);

}  // namespace berm::base
