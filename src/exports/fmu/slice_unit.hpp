// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "os/error.hpp"
#include "settings/case.hpp"

#include <filesystem>
#include <string>

namespace berm::fmu {

/// The last stage of the case is none that a co-simulation moves.
struct NoDrive : KeyError {
  NoDrive(const std::string& what, std::string to_append) : KeyError(what), stage(std::move(to_append)) {}
  std::string stage;  ///< the one to append, as TOML
};

/// modelDescription.xml of FMI 2.0 or 3.0 for a slice of soil with this token.
std::string slice_description(int fmi_version, const std::string& token);

/// The bytes of a functional mock-up unit, FMI 2.0 or 3.0 for co-simulation: the slice of soil that a case is, driven in its last stage. `folder` is where the case lies, by which it names its mesh. Throws
/// KeyError where the case is no slice that a caller can drive, NoDrive where its last stage alone is another.
std::string fmu_of_slice(settings::Case settings, const std::filesystem::path& folder, int fmi_version);

}  // namespace berm::fmu
