// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace berm::run_folder {

/// How sure a number is: the answer lies in converged +- half_width, nineteen times in twenty (docs/theory/method.md, Discretisation uncertainty). All in the unit of the number.
struct Band {
  Real value = 0;       ///< of the run
  Real converged = 0;   ///< at zero cell size
  Real half_width = 0;  ///< extrapolation + sqrt(mesh^2 + noise^2 + speed^2)
  Real order = std::numeric_limits<
      Real>::quiet_NaN();  ///< of convergence, as its runs show it; NaN where scatter hides it. The extrapolation takes 1
  Real extrapolation = 0;  ///< what the converged number is uncertain by because the order of convergence is
  Real mesh = 0;           ///< and because numbers scatter from mesh to mesh
  Real noise = 0;          ///< what the run's number is uncertain by as a mean over noisy rows
  Real speed =
      0;  ///< change of the number where the body is driven at twice the speed (finite elements: with longer increments and relaxation)
};

/// The band of a quantity of summary.json.
struct QuantityBand {
  std::string name, unit;
  Band band;
};

/// The band of a curve that a chart shows, SI units; `chart` as the page names it: V_w, H_u, w_u. u counts from where the first drag began. low and high are NaN
/// where a run did not come that far.
struct CurveBand {
  std::string chart;
  std::vector<Real> x, low, high;
};

/// A run that a band is made of, beside the run itself.
struct BandRun {
  std::string name;  ///< of its folder
  Real size = 1;     ///< of its cells over those of the run
  Real speed = 1;    ///< of its drives (finite elements: length of its increments) over that of the run
  Real wall_s = 0;
};

/// What a number becomes where sand that has no d50 gets one, on the coarsest cells that a band is made of, SI.
struct GrainNumber {
  std::string name, unit;  ///< of the quantity of summary.json
  Real without = 0;        ///< without a d50
  std::vector<Real> with;  ///< by Grains::d50; NaN where that run has no such number
};

/// Sand whose shear bands are as wide as cells make them, tried with grains.
struct Grains {
  Real size = 1;          ///< of the cells over those of the run
  std::vector<Real> d50;  ///< m; empty where nothing was tried
  std::vector<GrainNumber> numbers;
};

/// What `berm run --uncertainty` found out about a run.
struct Uncertainty {
  std::vector<QuantityBand> quantities;
  std::vector<CurveBand> curves;
  std::vector<BandRun> runs;
  std::vector<std::pair<std::string, std::string>> without;  ///< quantities and curves that have no band, and why
  std::vector<std::string> left_out;                         ///< parts that the band does not hold, and why
  Grains grains;                                             ///< what they would do to the numbers
  std::string missing;                                       ///< why there is no band at all; "" where there is one

  /// The band of that quantity, or null.
  const Band* find(const std::string& quantity) const;
};

/// As "uncertainty" in summary.json, and back. A number that is not finite is null there and NaN here. The reader throws RunError "is damaged: WHY".
nlohmann::ordered_json json_of(const Uncertainty& uncertainty);
Uncertainty uncertainty_of(const nlohmann::ordered_json& json);

/// Puts it into the summary.json of a run folder, in the place of an earlier one; all else there stays as it is. Throws RunError.
void add_to_summary(const std::filesystem::path& run_folder, const Uncertainty& uncertainty);

}  // namespace berm::run_folder
