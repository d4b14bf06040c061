// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "macro_element/parameters.hpp"

#include <string>
#include <string_view>

namespace berm::macro_element_fit {

/// The C code of the macro-element, the code that makes it a functional mock-up unit, and the shared library that was compiled from both.
extern const std::string_view code_h, code_c, fmu_code, fmu_library;

/// modelDescription.xml of FMI 2.0 or 3.0 for a unit with this token, which FMI 2.0 calls its GUID.
std::string model_description(int fmi_version, const std::string& token);

/// The bytes of a functional mock-up unit, FMI 2.0 or 3.0 for co-simulation: the same parameters give the same ones. It holds the library for the kind of machine that berm was built for, and its code for others.
std::string fmu_of(const macro_element::Parameters& parameters, int fmi_version);

}  // namespace berm::macro_element_fit
