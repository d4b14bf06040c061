// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/generic/generic.hpp"

namespace berm::line {

/// A pipeline on slices of soil: what its line does under each of its loads.
class Line : public generic::Generic {
public:
  const char* word() const override { return "pipeline"; }
  bool applies_to(const problem::Case& c) const override { return c.pipeline.has_value(); }
  std::vector<run_folder::Quantity> quantities(const record::RunRecord& run, const std::vector<Real>& held_forces) const override;
  std::vector<std::string> quantity_names(const problem::Case& c) const override;
  std::string table_of(const record::RunRecord& run) const override;
  bool draw_curves(const run_folder::RunFolder& folder, const record::RunRecord& run, const base::CurveBands& bands) const override;
  std::string in_words(const record::RunRecord& run, const base::DisplayUnits& shown) const override;
  std::string published_values(const base::Runs& runs, const base::DisplayUnits& shown) const override;
  std::string other_results(const record::RunRecord& run, const std::string& id) const override;
  std::vector<std::string> draw_report_curves(const base::Runs& runs, const base::PublishedPoints& published,
                                              const std::filesystem::path& folder) const override;
};

}  // namespace berm::line
