// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "record/run_record.hpp"
#include "structures/base/run_details.hpp"

namespace berm::expectations {

/// The one number that is taken from a column of a history over a window of time.
enum class Measure {
  end,           ///< in the last row
  mean,          ///< over the rows
  largest,       ///< of the rows
  least,         ///< of the rows
  change,        ///< last row less first row
  slope,         ///< of the least-squares line over time
  acceleration,  ///< slope of a velocity; of a displacement twice the square term of the least-squares parabola
  period         ///< mean distance of the crossings of the mean that go the same way, interpolated between rows
};

/// The word for each measure.
inline const std::vector<const char*> measure_words = {"end", "mean", "largest", "least", "change", "slope", "acceleration", "period"};

/// Which number of a run's results is meant.
struct Observable {
  std::string
      quantity;  ///< of summary.json: a quantity, else a check, else one of the timing; else one of the details of the run's structure,
  std::optional<Real> at;  ///< taken here; or
  std::string column;      ///< of history.csv, with
  Measure measure = Measure::end;
  std::optional<Real> from, to;  ///< s, ends of the window
};

/// The keys of a reading stand in the table of whoever takes it.
void describe(Describe& d, Observable& observable);

/// Says at `path` what does not fit together in a reading.
void check(Describe& d, const std::string& path, const Observable& observable);

/// "V_at_w_0.1D", "block_vx_m_s mean".
std::string words_of(const Observable& observable);

/// The SI unit of what the measure makes of the column, as the history's schema tells; "" of a bare number. Throws RunError where there is no such column.
std::string unit_of(const Observable& observable, const run_folder::History& history);

/// Whether the column holds a velocity, whose slope is an acceleration.
bool is_velocity(const Observable& observable, const run_folder::History& history);

/// The rows of a column within the window.
struct Rows {
  std::vector<Real> time, value;
};

/// Throws InputError where the history has no such column.
Rows rows_of(const Observable& observable, const run_folder::History& history);

/// The measure of the column over its window. NaN where the window has too few rows or crossings. Throws InputError as rows_of.
Real evaluate(const Observable& observable, const run_folder::History& history);

/// A number of a run's results.
struct Reading {
  Real value;
  std::string unit;   ///< SI; "" = a bare number
  std::string label;  ///< of the column, or the quantity
};

/// The number, from the files of a run folder, or from what was read of it with the details of its structure (or none); true is 1, false 0, and what was not finite
/// NaN. Throw InputError where there is no such quantity or column, RunError where there is no such file or a frame is damaged.
Reading evaluate(const Observable& observable, const std::filesystem::path& run_folder);
Reading evaluate(const Observable& observable, const record::RunRecord& run, const base::RunDetails& details);

}  // namespace berm::expectations
