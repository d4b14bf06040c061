// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/structure.hpp"

namespace berm::driven {

/// A rigid body that is pushed into the bed, by w against V, and dragged along it, by u against H: what any such body has, a pipe, a cone or an anchor. Its
/// results follow its path: the ways that it goes, and the states between them.
class Driven : public base::Structure {
public:
  std::vector<run_folder::Quantity> quantities(const record::RunRecord& run, const std::vector<Real>& held_forces) const override;
  std::vector<std::string> quantity_names(const problem::Case& c) const override;
  std::string table_of(const record::RunRecord& run) const override;
  bool draw_curves(const run_folder::RunFolder& folder, const record::RunRecord& run, const base::CurveBands& bands) const override;
  base::ChartCurves chart_curves(const record::RunRecord& run) const override;
  std::string in_words(const record::RunRecord& run, const base::DisplayUnits& shown) const override;
  std::string key_results(const base::Runs& runs, const base::DisplayUnits& shown) const override;
  base::TrustMeasures measures(const problem::Case& c) const override;
  std::string quality_note(const base::Runs& runs) const override;
  base::StagePaths paths(const record::RunRecord& run) const override;
  std::vector<std::string> draw_report_curves(const base::Runs& runs, const base::PublishedPoints& published,
                                              const std::filesystem::path& folder) const override;
  std::vector<std::string> draw_report_soil(const base::Runs& runs, const std::filesystem::path& folder) const override;
  std::unique_ptr<base::RunDetails> details(const record::RunRecord& run) const override;
};

}  // namespace berm::driven
