// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"

namespace berm::settings {

/// Whether there is a stage in which both supports act.
bool act_together(const Case& c, const boundary::SupportSettings& a, const boundary::SupportSettings& b);

/// Refuses heads of supports that make no sense by themselves.
void check_heads(Describe& d, const Case& c);

/// Refuses motions of supports that make no sense by themselves.
void check_motions(Describe& d, const Case& c);

/// What is wrong with the motion of a support, of which no file is left to read: "KEY: MESSAGE" with the key below the motion; "" where nothing is.
std::string fault_of_motion(const Case& c, const boundary::SupportSettings& support);

}  // namespace berm::settings
