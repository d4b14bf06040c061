// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"
#include "record/run_record.hpp"
#include "run_folder/uncertainty.hpp"
#include "settings/case.hpp"

#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace berm::uncertainty {

/// A finished run that a band is made of.
struct VariantRecord {
  Real size, speed;  ///< as in Variant
  record::RunRecord run;
  std::optional<Real> d50 = {};  ///< as in Variant
};

/// The bands of all answers of a run's structure and of its curves, from the run and those with other cells; at another speed than 1 only one, of a size that another
/// run or the run itself has, and none with grains. A number or curve that one of them has not, and a number that noise makes or hides, have no band, and `without` says so.
run_folder::Uncertainty bands_of(const record::RunRecord& run, const std::vector<VariantRecord>& variants);

/// What a number scatters as from mesh to mesh: those of pushes and lifts, those of drags, and forces that the input holds, which do not.
enum class Scatters { as_in_pushes, as_in_drags, not_at_all };
struct RunNumber {
  Real value;
  Scatters scatters;
};

/// Numbers of a run, by name: of its record alone, which may have other rows than its folder, or none.
using NumbersOfRun = std::function<std::map<std::string, RunNumber>(const record::RunRecord&)>;

/// The bands of such numbers; the half width is NaN where one of the variants has no such number.
std::map<std::string, run_folder::Band> bands_of(const record::RunRecord& run, const std::vector<VariantRecord>& variants,
                                                 const NumbersOfRun& numbers_of_run);

/// All answers of a run's structure with grains beside those without, of runs on cells of one size. `variants` are all that were run.
run_folder::Grains grains_of(const record::RunRecord& run, const std::vector<VariantRecord>& variants);

/// What the numbers of a run are uncertain by as means over noisy rows, at 95 %: twice the standard error of the jackknife over five sets of
/// rows, each every fifth row. None for methods without noise and for numbers that are not of the rows; NaN where a number is found without some of the rows and not without
/// others.
std::map<std::string, Real> noise_of(const record::RunRecord& run, const NumbersOfRun& numbers_of_run);

/// The bands as a table for people: the run's number, the converged one with its half width, and the parts of that; below it what has no band, and why.
std::string words_of(const run_folder::Uncertainty& uncertainty, settings::Method method);

}  // namespace berm::uncertainty
