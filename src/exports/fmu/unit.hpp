// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/zip.hpp"

namespace berm::fmu {

/// Its value reference is its place in the list; the first is the time.
struct Variable {
  const char *name, *causality, *unit, *description;
  std::vector<std::size_t> inputs = {};  ///< that an output depends on at the same time
};

/// A functional mock-up unit for co-simulation, whose library is made of a model in C and of fmi.c.
struct Unit {
  const char *identifier, *description;
  std::vector<Variable> variables;
  bool has_derivatives, has_bytes_of_states, needs_berm;
  std::string_view library;               ///< for the kind of machine that berm was built for
  std::string token;                      ///< which FMI 2.0 calls its GUID
  std::vector<io::ZipEntry> files = {};   ///< besides the description and the library
  std::vector<const char*> sources = {};  ///< of `files` those in sources/ that are compiled for other machines
};

/// modelDescription.xml of FMI 2.0 or 3.0.
std::string model_description(int fmi_version, const Unit& unit);

/// The bytes of an archive: the same unit gives the same ones.
std::string archive_of(int fmi_version, const Unit& unit);

}  // namespace berm::fmu
