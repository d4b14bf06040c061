// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "macro_element/macro_element.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

namespace berm::macro_element {

using Parameters = berm_macro_element_parameters;

/// A number among the parameters.
double& value_of(Parameters& parameters, const berm_macro_element_member& member);
double value_of(const Parameters& parameters, const berm_macro_element_member& member);

/// What macro_element.json has of them: "version", and "parameters" with value (SI) and unit of each.
nlohmann::ordered_json json_of(const Parameters& parameters);

/// The parameters in the text of a macro_element.json, which messages call `name`. Throws InputError where it is no such file of this version, lacks a parameter or has one out of its range.
Parameters parameters_in(const std::string& text, const std::string& name);

/// Those of a macro_element.json, or of the folder that has one. Throws InputError as above, and where it cannot be read.
Parameters read_parameters(const std::filesystem::path& named);

}  // namespace berm::macro_element
