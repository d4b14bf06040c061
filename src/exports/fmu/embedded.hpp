// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace berm::fmu {

/// The functions of FMI 2.0 and 3.0 in C, what they ask of a model, and the library of a slice's unit, which loads libberm.
extern const std::string_view fmi_h, fmi_c, slice_library;

}  // namespace berm::fmu
