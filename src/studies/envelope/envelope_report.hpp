// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "envelope/envelope_table.hpp"

#include <filesystem>

namespace berm::envelope {

/// Writes FOLDER/envelope.csv, summary.json and envelope.png; of a footing whose probes are all done also its macro-element, redwin.txt, .c and .so, or warns why there is none.
void write_envelope_report(const settings::Case& c, const std::vector<EnvelopeRow>& rows, const std::filesystem::path& folder);

/// The table for people: a line for each probe's end and the extremes beside what is published.
std::string envelope_words(const settings::Case& c, const std::vector<EnvelopeRow>& rows);

/// What is published of the structure, for the ends of the probes.
base::PublishedEnvelope published_for(const settings::Case& c, const std::vector<EnvelopeRow>& rows);

/// Draws FOLDER/envelope.png, V and H; of a footing also moments.png, V and M without H, and sections.png, H and M where V is half and three quarters of V_max.
void draw_envelope(const settings::Case& c, const std::vector<EnvelopeRow>& rows, const std::filesystem::path& folder);

}  // namespace berm::envelope
