// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "study/distribution.hpp"
#include "study/study_axis.hpp"

namespace berm::study {

/// A number that is not known well, and the keys that it sets.
struct SampleParameter {
  std::string name;
  std::vector<std::string> keys;             ///< each gets the number itself
  std::map<std::string, std::string> times;  ///< each gets its quantity times the number, which is bare
  Distribution distribution;
};

/// A Latin hypercube of parameters, beside runs with all of them at their medians and with one of them at its 5 % and 95 % value.
struct StudySample {
  int size = 0, seed = 1;
  std::vector<SampleParameter> parameter;
};

void describe(Describe& d, SampleParameter& parameter);
void describe(Describe& d, StudySample& sample);
/// Says at [sample] what does not fit together.
void check(Describe& d, const StudySample& sample);

/// The axis of a sample: the value "best", then "NAME low" and "NAME high" of each parameter, then the rows of the sample, "1", "2", ... Numbers have six digits, so that they are
/// the same wherever exp and log differ in their last bits.
StudyAxis sample_axis(const StudySample& sample);

/// The rows of the sample as a table that read_table reads.
std::string samples_csv(const StudyAxis& axis);

}  // namespace berm::study
