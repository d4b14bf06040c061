// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/pipe/pipe.hpp"

namespace berm::anchor {

/// An anchor, plough or grapnel that is dragged through the bed: depth of its lowest point and tow force over travel. What it has in common with any driven body is that
/// of pipe::Pipe. It is named in the input.
class Anchor : public pipe::Pipe {
public:
  const char* word() const override { return "anchor"; }
  std::vector<run_folder::Quantity> quantities(const record::RunRecord& run, const std::vector<Real>& held_forces) const override;
  std::string table_of(const record::RunRecord& run) const override;
  std::string in_words(const record::RunRecord& run, const base::DisplayUnits& shown) const override;
  std::string key_results(const base::Runs& runs, const base::DisplayUnits& shown) const override;
  std::string published_values(const base::Runs&, const base::DisplayUnits&) const override { return ""; }
  std::string quality_note(const base::Runs&) const override { return ""; }
  std::vector<std::string> draw_report_curves(const base::Runs& runs, const base::PublishedPoints& published,
                                              const std::filesystem::path& folder) const override;
};

}  // namespace berm::anchor
