// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"

namespace berm::base {

/// Why the numbers of a run are not to be used, a sentence without its full stop each; empty where nothing is known against them. Of what the page judges, only what spoils the
/// answer itself, from where the page calls it bad:
///
/// - energy that does not balance, more than a twentieth of the work (of soil that nothing drives: or of the elastic energy that it had at the start): forces do that work, and may be off by as much;
/// - momentum that does not balance: the program is wrong;
/// - soil at its largest volume, more than a hundredth of all: it no longer follows its law;
/// - forces, displacements or energies that are no numbers;
/// - a driven body that touched soil, and touches none in the last tenth of a push or a drag that soil resisted: what it drags through is water.
std::vector<std::string> invalid_because(const record::RunRecord& run);

/// Why, as one text; "" where nothing is.
std::string invalid_words(const std::vector<std::string>& invalid);

/// Marks a name or a line of numbers of a run that is invalid; "" of one that is not.
const char* invalid_mark(const std::vector<std::string>& invalid);

/// Begins the lines that say why numbers are not to be used.
inline constexpr const char* invalid_line_begin = "(!)";

/// These lines of a run, one for each reason: "(!) the answer of RUN is invalid, do not use NUMBERS: WHY".
std::vector<std::string> invalid_lines(const std::string& run, const std::vector<std::string>& invalid,
                                       const char* numbers = "these numbers");

}  // namespace berm::base
