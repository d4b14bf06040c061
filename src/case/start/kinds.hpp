// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/start/kinds_test.cpp
#pragma once

#include <string>
#include <vector>

namespace berm::start {

/// A job that `berm new` writes a case for, as the first lines of its template say it.
struct Kind {
  std::string name;      ///< as the command takes it
  std::string group;     ///< under which it is listed
  std::string question;  ///< that a run answers
  std::string title;     ///< of the case
  std::string example;   ///< folder of examples/ that goes on from here
  std::string text;      ///< of the template
};

/// All of them, by group and name.
const std::vector<Kind>& kinds();

/// The kind of a name. Throws InputError where there is none.
const Kind& kind_called(const std::string& name);

/// What a template says for each size, in this order.
inline const std::vector<std::string> sizes = {"quick", "normal", "fine"};

/// The template with the cells and speeds of a size.
///
/// A line that depends on it has the value of normal, and in its comment those of the others: `near_size = "50 mm"  # [quick "80 mm", fine "25 mm"] of D/10`.
/// What is written has the chosen value and a comment that names the size. Throws InputError where there is no such size.
std::string at_size(const Kind& kind, const std::string& size);

}  // namespace berm::start
