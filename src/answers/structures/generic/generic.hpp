// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/structure.hpp"

namespace berm::generic {

/// Any case that is of no other structure: it has no key results; what it watches, its own quantities and its checks are told.
class Generic : public base::Structure {
public:
  const char* word() const override { return "other"; }
  bool applies_to(const problem::Case& c) const override;
  bool draw_curves(const run_folder::RunFolder& folder, const record::RunRecord& run, const base::CurveBands& bands) const override;
  std::string in_words(const record::RunRecord& run, const base::DisplayUnits& shown) const override;
  std::string other_results(const record::RunRecord& run, const std::string& id) const override;
  base::TrustMeasures measures(const problem::Case& c) const override;
};

}  // namespace berm::generic
