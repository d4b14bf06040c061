// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <optional>
#include <string>
#include <vector>

namespace berm::study {

/// One choice along an axis.
struct StudyValue {
  std::string name;
  std::vector<std::string> set;  ///< KEY=VALUE, on top of the case's
  std::string place;             ///< FILE:LINE, where it is a row of a table
  std::vector<Real> number;      ///< SI, by parameter of the axis; NaN where it is none
};

/// A parameter of a sample.
struct AxisParameter {
  std::string name, unit;  ///< SI; "" = bare numbers
};

/// What is varied: each row of the results has one value of each axis.
struct StudyAxis {
  std::string name;
  std::vector<StudyValue> value;
  /// Its values from this one on are a sample, of equal weight. Those before them, if any: all parameters at their medians, then each in turn at its 5 % and its 95 % value.
  std::optional<std::size_t> sample_from;
  std::vector<AxisParameter> parameter;  ///< of a sample
};

}  // namespace berm::study
