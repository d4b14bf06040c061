// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"
#include "user_law/function.hpp"

#include <map>

namespace berm::user_law {

/// Laws that the calling program has itself, by the name of the material whose library they stand for (law = "user").
using GivenLaws = std::map<std::string, OwnFunction>;

/// Loads the libraries of the user's own laws of a case, tries them, and notes their SHA-256 in it. A law that threads cannot call at a time is called by one
/// after the other, with a warning. Throws KeyError where a library is missing, is another than library_sha256 says, does not load, has no such function, or
/// fails the trials (trial.hpp). A law that crashes ends the program (crash_guard.hpp).
/// A given law is called by one thread after the other. Throws KeyError where a given law stands for no such material.
void load(settings::Case& c, const GivenLaws& given = {});

/// The same of materials by themselves, for stresses of this dimension.
void load(std::vector<std::pair<std::string, material::Material>>& materials, int dimension, const GivenLaws& given = {});

/// Whether one of the materials has a law from a library.
bool names_library(const std::vector<std::pair<std::string, material::Material>>& materials);

/// Path and SHA-256 of the libraries of a case that are loaded, each once.
std::vector<std::pair<std::string, std::string>> library_hashes(const settings::Case& c);

/// Throws RunError with the reason where a loaded law has failed.
void throw_failures(const settings::Case& c);
void throw_failures(const std::vector<std::pair<std::string, material::Material>>& materials);

/// Forgets failures that the method has got over.
void forget_failures(const settings::Case& c);

}  // namespace berm::user_law
