// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"

#include <filesystem>

namespace berm::input {

/// Reads the file of the load history of the stage of this number, a path from `folder`, into its times and factors or columns, writes a record that is repeated
/// behind itself, and puts the number that berm finds in the place of an automatic time scale. Lines that begin with # do not count. Of a file of factors the others are two numbers with a comma between
/// them, time in s and factor, under a first line of words or none. Of columns the first line names them, each with its unit as in history.csv:
///
///   time_s,H_N_m,V_kN_m
///
/// (settings::load_columns; N_m stands for N/m, Nm_m for N m/m). Where the first line that counts has semicolons, they stand for commas. There are
/// two rows of numbers at least. The stage ends with the last time at the latest. Throws KeyError where there is no such file or the stage cannot be combined with it,
/// and InputError with file and line where it is wrong.
void read_load_history(settings::Case& c, std::size_t stage_number, const std::filesystem::path& folder);

/// Reads the file of the motion of the support of this number, a path from `folder`, into its times and velocities: time_s,x_m_s,y_m_s. Throws KeyError where there
/// is no such file or the support cannot be combined with it, and InputError with file and line where it is wrong.
void read_motion(settings::Case& c, std::size_t support_number, const std::filesystem::path& folder);

}  // namespace berm::input
