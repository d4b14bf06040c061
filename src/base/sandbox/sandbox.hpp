// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace berm::sandbox {

// What programs that a case brings may do: its geometry, which gmsh runs, and its laws, which are code in this program. docs/untrusted_input.md says what holds.

/// Why this system has no sandbox; "" where it has one.
std::string why_there_is_none();

/// From now on this program and all that it starts write below `folders` and the temporary folder of this run only, open no sockets, and start no other programs than
/// gmsh, gnuplot, rsvg-convert and berm; what they started ends with this program. Makes the folders that are missing. Nothing happens in a program that was started in a sandbox: it is
/// in that one. Throws RunError where the system has none, and where this program has threads already.
void enter(const std::vector<std::filesystem::path>& folders);

/// Whether this program is in a sandbox.
bool is_inside();

/// What this program lets programs of a case do, from now on: gmsh is started by words_inside(), and a library is loaded in the sandbox, with BERM_NO_SANDBOX=1, or after do_without().
void guard_case_programs();
/// A library of a case runs with all rights of the user, and a warning says why.
void do_without(const std::string& why);

/// The words that start a program of a case in a sandbox of its own, in which it writes below this folder only: berm starts it. The same words with BERM_NO_SANDBOX=1 in the environment, and, with a
/// warning, where the system has no sandbox.
std::vector<std::string> words_inside(const std::vector<std::string>& words, const std::string& folder);
/// Of a berm that words_inside() started: its exit status; empty of another.
std::optional<int> run_inside(int argc, char** argv);

/// What is told with what was stopped.
constexpr const char* how_to_do_without = "--no-sandbox lets a case that you trust do so";
/// BERM_NO_SANDBOX=1, which runs that this one starts inherit, lets programs of a case do whatever the user may.
constexpr const char* trust_variable = "BERM_NO_SANDBOX";
bool is_trusted();

/// What was kept from happening, a line each; "" where nothing was.
std::string stopped();

/// Throws RunError where something was kept from happening.
void throw_if_stopped();

/// At the end of the program: folders that enter() made and that are empty are removed.
void leave();

}  // namespace berm::sandbox
