// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "study/estimates.hpp"
#include "study/study.hpp"

#include <string>
#include <vector>

namespace berm::study {

/// Writes OUTPUT/results.csv (all digits), results.md (a table for people, with what was skipped and what failed, and the figures) and a picture
/// for each figure. Throws RunError.
void write_study_report(const StudyPlan& plan, const std::filesystem::path& output);

/// Writes what the sample of a study tells: OUTPUT/estimates.csv, distribution.csv, sensitivity.csv and a tornado picture for each measure and combination of the other axes. Returns the same as Markdown, with
/// the pictures; "" of a study without a sample. Throws RunError.
std::string write_sample_report(const StudyPlan& plan, const std::filesystem::path& output);

/// Draws FOLDER/NAME.png: a bar for each parameter, the widest at the top, from the measure with all at their medians to that with this parameter at its 5 % and 95 % value; below them what
/// the sample spans. Where there are no such runs the bars are rank correlations. False where it could not be drawn (plot::draw), or nothing is known.
bool draw_tornado(const std::filesystem::path& folder, const std::string& name, const StudyPlan& plan, const Estimate& estimate);

/// A number in the unit that suits: "4.2 kPa".
std::string parameter_words(Real value, const AxisParameter& parameter);

/// One line of a .csv file.
std::string csv_line(const std::vector<std::string>& fields);

/// One line of a table in Markdown, and the line below its headings: text to the left in the first columns, numbers to the right in the others.
std::string markdown_line(const std::vector<std::string>& cells);
std::string markdown_rule(std::size_t columns, std::size_t columns_of_text);

}  // namespace berm::study
