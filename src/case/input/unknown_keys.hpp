// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/catalogue.hpp"
#include "input/document.hpp"

namespace berm::input {

/// Throws InputError for the first key that no parameter of the catalogue has at that level, with the nearest known one; for
/// a key of an alternative that is not chosen; and for an override through a name that the file does not have.
void refuse_unknown_keys(const Document& document, const Listed& catalogue);

/// Throws InputError for the first key that was not read.
void refuse_unused_keys(const Document& document);

}  // namespace berm::input
