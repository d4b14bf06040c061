// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace berm::text {

/// A formula in the TeX of the manual as MathML, which browsers render natively; `block` for a displayed formula. Supported
/// are letters, numbers, Greek, the usual signs, sub- and superscripts, fractions, roots, accents, named functions, words
/// and brackets; a formula with anything else is shown as its source: <code class="tex">.
std::string html_math(const std::string& tex, bool block);

}  // namespace berm::text
