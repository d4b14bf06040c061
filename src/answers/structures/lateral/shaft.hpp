// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/penetration/penetration.hpp"

namespace berm::lateral {

/// A body that may be pushed down and read as resistance over depth, and loaded sideways where it stands in the bed: a pile, a skirt. A run that does both has the results
/// of both.
class Shaft : public penetration::Penetration {
public:
  using Penetration::Penetration;

  std::vector<run_folder::Quantity> quantities(const record::RunRecord& run, const std::vector<Real>& held_forces) const override;
  std::vector<std::string> quantity_names(const problem::Case& c) const override;
  std::string table_of(const record::RunRecord& run) const override;
  bool draw_curves(const run_folder::RunFolder& folder, const record::RunRecord& run, const base::CurveBands& bands) const override;
  base::ChartCurves chart_curves(const record::RunRecord& run) const override;
  std::string in_words(const record::RunRecord& run, const base::DisplayUnits& shown) const override;
  std::string key_results(const base::Runs& runs, const base::DisplayUnits& shown) const override;
  std::string published_values(const base::Runs& runs, const base::DisplayUnits& shown) const override;
  base::TrustMeasures measures(const problem::Case& c) const override;
  base::StagePaths paths(const record::RunRecord& run) const override;
  std::vector<base::OwnChart> own_charts(const record::RunRecord& run) const override;
  std::optional<base::PointTravel> point_travel(const record::RunRecord& run) const override;
  std::vector<std::string> draw_report_curves(const base::Runs& runs, const base::PublishedPoints& published,
                                              const std::filesystem::path& folder) const override;
  std::unique_ptr<base::RunDetails> details(const record::RunRecord& run) const override;
};

}  // namespace berm::lateral
