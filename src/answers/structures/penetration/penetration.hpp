// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/driven/driven.hpp"
#include "structures/penetration/reading.hpp"

namespace berm::penetration {

/// A body that is pushed down and read as a site investigation reads it: resistance over an area against depth, a factor of it, and whether it is steady. What it
/// has in common with any driven body (ends of pushes, drags, charts) is that of driven::Driven.
class Penetration : public driven::Driven {
public:
  explicit Penetration(const Reading& reading) : reading_(reading) {}

  const char* word() const override { return reading_.word; }
  std::vector<run_folder::Quantity> quantities(const record::RunRecord& run, const std::vector<Real>& held_forces) const override;
  std::vector<std::string> quantity_names(const problem::Case& c) const override;
  std::string table_of(const record::RunRecord& run) const override;
  bool draw_curves(const run_folder::RunFolder& folder, const record::RunRecord& run, const base::CurveBands& bands) const override;
  std::string in_words(const record::RunRecord& run, const base::DisplayUnits& shown) const override;
  std::string key_results(const base::Runs& runs, const base::DisplayUnits& shown) const override;
  std::string published_values(const base::Runs& runs, const base::DisplayUnits& shown) const override;
  base::TrustMeasures measures(const problem::Case& c) const override;
  std::string quality_note(const base::Runs& runs) const override;
  std::vector<std::string> draw_report_curves(const base::Runs& runs, const base::PublishedPoints& published,
                                              const std::filesystem::path& folder) const override;

protected:
  const Reading& own_reading() const { return reading_; }

private:
  const Reading& reading_;
};

}  // namespace berm::penetration
