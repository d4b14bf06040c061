// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "study/study.hpp"

namespace berm::study {

/// What a row of a study is in its sample.
enum class RowKind {
  row,   ///< no part of a sample
  best,  ///< all parameters at their medians
  low,   ///< one of them at its 5 % value
  high,  ///< at its 95 % value
  draw,  ///< one of equal weight
};

/// A row of a study that was run.
struct SavedRow {
  std::vector<std::string> names;  ///< the case, and the values of the axes but the sample
  RowKind kind = RowKind::row;
  std::filesystem::path run;  ///< its folder
  bool finished = false;
};

/// Writes OUTPUT/study.json: the rows with their run folders, for programs to read.
void write_rows(const StudyPlan& plan, const std::filesystem::path& output);

/// The rows that a study's output tells; empty where the folder holds no study. Throws RunError where its study.json is damaged.
std::optional<std::vector<SavedRow>> read_rows(const std::filesystem::path& output);

}  // namespace berm::study
