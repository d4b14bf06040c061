// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "envelope/envelope_probes.hpp"
#include "input/places.hpp"
#include "jobs/jobs.hpp"

#include <filesystem>

namespace berm::envelope {

/// An envelope to find.
struct EnvelopeRequest {
  settings::Case settings;
  std::filesystem::path case_file;
  std::filesystem::path folder;
  EnvelopeSettings how;
  jobs::Runner runner;
  input::Places places = {};  ///< where the keys of the case were written, for messages
};

/// Runs the probes of an envelope that have no result yet, FOLDER/runs/PROBE.toml into FOLDER/runs/PROBE, and writes envelope.csv, envelope.png (of a
/// footing also moments.png and sections.png) and summary.json. Ctrl-C stops it and leaves what is there. Throws InputError where the case has no
/// body in the bed whose envelope is known, or does not fit its mesh, before anything is written.
jobs::Outcome find_envelope(const EnvelopeRequest& request);

}  // namespace berm::envelope
