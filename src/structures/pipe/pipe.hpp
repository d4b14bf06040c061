// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/structure.hpp"

namespace berm::pipe {

/// A pipe: a rigid body that a push drives into the bed by w against V, and a drag along it by u against H. Bodies of other shapes that are driven so are told
/// by the same numbers, without the formulas, which are those of a circle.
class Pipe : public base::Structure {
public:
  const char* word() const override { return "pipe"; }
  std::vector<run_folder::Quantity> quantities(const record::RunRecord& run, const std::vector<Real>& held_forces) const override;
  std::string table_of(const record::RunRecord& run) const override;
  bool is_answer(const record::RunRecord& run, const run_folder::Quantity& quantity) const override;
  bool draw_curves(const run_folder::RunFolder& folder, const record::RunRecord& run, const base::CurveBands& bands) const override;
  base::ChartCurves chart_curves(const record::RunRecord& run) const override;
  std::string in_words(const record::RunRecord& run, const base::DisplayUnits& shown) const override;
  std::string key_results(const base::Runs& runs, const base::DisplayUnits& shown) const override;
  std::string published_values(const base::Runs& runs, const base::DisplayUnits& shown) const override;
  base::TrustMeasures measures(const problem::Case& c) const override;
  std::string quality_note(const base::Runs& runs) const override;
  base::StagePaths paths(const record::RunRecord& run) const override;
  std::vector<std::string> draw_report_curves(const base::Runs& runs, const base::PublishedPoints& published,
                                              const std::filesystem::path& folder) const override;
  std::vector<std::string> draw_report_soil(const base::Runs& runs, const std::filesystem::path& folder) const override;
  std::unique_ptr<base::RunDetails> details(const record::RunRecord& run) const override;
  base::EmbeddedBody embedded(const problem::Case& c) const override;
  base::PublishedEnvelope published_envelope(const problem::Case& c, const base::EnvelopeEnds& ends) const override;
};

}  // namespace berm::pipe
