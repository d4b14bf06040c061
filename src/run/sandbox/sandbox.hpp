// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace berm::sandbox {

// What programs that a case brings may do: its geometry, which gmsh runs, and its laws, which are code in this program. docs/untrusted_input.md says what holds.

/// Why this system has no sandbox; "" where it has one.
std::string why_there_is_none();

/// From now on this program and all that it starts write below `folders` and the temporary folder of this run only, open no sockets, and start no other programs than
/// gmsh, gnuplot, rsvg-convert and berm. Makes the folders that are missing. Nothing happens in a program that was started in a sandbox: it is in that one.
/// Throws RunError where the system has none.
void enter(const std::vector<std::filesystem::path>& folders);

/// What was kept from happening, a line each; "" where nothing was.
std::string stopped();

/// Throws RunError where something was kept from happening.
void throw_if_stopped();

/// At the end of the program: folders that enter() made and that are empty are removed.
void leave();

}  // namespace berm::sandbox
