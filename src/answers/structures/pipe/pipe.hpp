// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/driven/driven.hpp"

namespace berm::pipe {

/// A pipe on or in the bed. Bodies of other shapes that nothing else is known of are read by the same numbers, without the formulas, which are those of a circle.
class Pipe : public driven::Driven {
public:
  const char* word() const override { return "pipe"; }
  std::vector<run_folder::Quantity> quantities(const record::RunRecord& run, const std::vector<Real>& held_forces) const override;
  std::vector<std::string> quantity_names(const problem::Case& c) const override;
  std::string in_words(const record::RunRecord& run, const base::DisplayUnits& shown) const override;
  std::string key_results(const base::Runs& runs, const base::DisplayUnits& shown) const override;
  std::string published_values(const base::Runs& runs, const base::DisplayUnits& shown) const override;
  base::EmbeddedBody embedded(const problem::Case& c) const override;
  base::PublishedEnvelope published_envelope(const problem::Case& c, const base::EnvelopeEnds& ends) const override;
};

}  // namespace berm::pipe
