// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace berm::text {

/// A text as HTML shows it: &, <, > and " escaped.
std::string html_text(const std::string& text);

/// A formula in the TeX of the manual as MathML, which browsers draw by themselves; `block` where it stands on a line of its own. It knows letters,
/// numbers, Greek, the usual signs, sub- and superscripts, fractions, roots, accents, named functions, words and brackets; of a formula with
/// anything else the source is shown: <code class="tex">.
std::string html_math(const std::string& tex, bool block);

}  // namespace berm::text
