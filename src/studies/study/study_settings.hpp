// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "expectations/observable.hpp"
#include "input/catalogue.hpp"
#include "study/sample.hpp"

namespace berm::study {

/// A case of a study.
struct StudyCase {
  std::string name, file;        ///< the file beside study.toml
  std::vector<std::string> set;  ///< overrides KEY=VALUE
};

/// A file whose rows are the values of an axis.
struct StudyTable {
  std::string name, file;  ///< of the axis; beside study.toml
};

/// Combinations that are left out: those that have all of these words.
struct StudySkip {
  std::vector<std::pair<std::string, std::string>> where;  ///< an axis, or "case", and the name of its value
  std::string why;
};

/// A column of the table.
struct StudyMeasure {
  std::string name;  ///< its heading
  expectations::Observable observable;
  std::string unit;                ///< as it is shown, after scaling; "": the SI unit of the first number
  Real scale = 1;                  ///< shown number over the SI number
  std::vector<std::string> cases;  ///< only for these; empty = all
  std::optional<Real> limit = {};  ///< as shown: a sample tells how probable numbers below it are
};

/// History curves of all rows over one another.
struct StudyFigure {
  std::string name, x, y;          ///< columns of history.csv
  std::vector<std::string> stage;  ///< rows of these stages only; empty = all
  std::string case_name;           ///< rows of this case only; "" = all
  std::optional<Real>
      smooth;  ///< half width over which y is averaged, in the unit of x; absent: 0.01 of the main rigid body's diameter where x is a length
  std::string smooth_unit;  ///< SI, as it is written; "" where it has none
};

/// study.toml: a matrix of runs, and what is to be told of them.
struct Study {
  std::string title;
  std::vector<StudyCase> cases;
  std::vector<StudyAxis> axis;  ///< those of tables behind the others, that of the sample last
  std::vector<StudyTable> table;
  std::optional<StudySample> sample;
  std::vector<StudySkip> skip;
  std::vector<StudyMeasure> measure;
  std::vector<StudyFigure> figure;
};

void describe(Describe& d, StudyCase& c);
void describe(Describe& d, StudyValue& value);
void describe(Describe& d, StudyAxis& axis);
void describe(Describe& d, StudyTable& table);
void describe(Describe& d, StudySkip& skip);
void describe(Describe& d, StudyMeasure& measure);
void describe(Describe& d, StudyFigure& figure);
void describe(Describe& d, Study& study);

/// The keys of a study, for its schema.
input::Listed study_catalogue();

/// Reads a study and its tables, and draws its sample. Throws InputError with file, line and key.
Study read_study(const std::filesystem::path& file);

/// The axis that is a sample, or null.
const StudyAxis* sample_of(const Study& study);

/// What is wrong with a name that goes into tables and becomes one of a file: longer than 100 bytes, or a formula where a spreadsheet opens the table; "" where
/// nothing is.
std::string fault_of_name(const std::string& name);

/// A name as part of a file's: everything but letters, digits and . _ - + = becomes "_", and one of dots alone gets a "_".
std::string as_file_name(std::string name);

}  // namespace berm::study
