// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "springs/lognormal.hpp"
#include "springs/springs.hpp"

#include <optional>
#include <vector>

namespace berm::springs {

/// What a number of a spring is of.
enum class Kind { force, displacement, stiffness, ratio };

/// One number of the springs of a run, and what a sample tells of it.
struct Estimate {
  std::string spring;  ///< "lateral STAGE", "vertical", "axial"
  std::string name;
  Kind kind = Kind::force;
  std::string meaning;
  std::string travel;                        ///< that it was found in; of a state or a formula none
  std::string source;                        ///< "computed", or the formula
  Real best = nan;                           ///< of the best run, or of the only one; of one with bands extrapolated to zero cell size
  Real low = nan, middle = nan, high = nan;  ///< quantiles of 5, 50 and 95 % of the sample; low and high of a run with bands: their ends
  std::size_t size = 0;                      ///< runs of the sample, or of the band, that have this number
  Lognormal fit;
};
const char* unit_of(Kind kind);

/// Whether a secant of V over w may be taken for a stiffness: it is positive. That of a stage in which the pipe sinks while V falls is not.
bool is_stiffness(Real secant);
/// Lines that say which stiffnesses are not written, and why.
std::vector<std::string> refused_stiffnesses(const Springs& springs);

/// What goes to other programs: the springs of a run, or those of a sample of runs.
struct Design {
  std::string name;  ///< of the run, or of the combination of a study
  std::vector<std::string>
      provenance;  ///< lines: from what, by which program; those that begin with base::invalid_line_begin say why the numbers are not to be used
  Springs best;  ///< of the best run, extrapolated where it has bands; of a sample without one, the middle of all numbers
  /// Of a sample: forces at 5 and at 95 %, of a run with bands their ends; at the displacements of `best`.
  std::optional<Springs> low, high;
  std::vector<Estimate> estimates;
  std::vector<Springs> draws;
  std::size_t failed = 0;  ///< draws without a finished run
};

/// Lines that say from which run numbers are, by which program, and why they are not to be used; what is doubtful is a warning, too.
std::vector<std::string> head_of(const record::RunRecord& run);

/// Of the best run, if there is one, and draws of equal weight, one at least.
Design design_of_sample(const std::string& name, const std::optional<Springs>& best, std::vector<Springs> draws);

/// The springs of a run folder, or of each combination of a study's output that has a sample. Throws RunError where there are none, InputError where a run has not
/// what is selected.
std::vector<Design> designs_in(const std::filesystem::path& folder, const Selection& selection = {});

}  // namespace berm::springs
