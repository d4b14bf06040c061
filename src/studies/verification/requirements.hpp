// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "verification/book.hpp"

namespace berm::verification {

/// Something that the user may rely on, and the numbers of an example that prove it.
struct Promise {
  std::string requirement, derived;
  std::vector<std::size_t> numbers;  ///< of Example::expectations
};

/// What an example promises, in the order of its numbers: those of one requirement and one derivation together.
std::vector<Promise> promises_of(const Example& example);

/// The page requirements.html of the book: what is promised, where it is derived, which runs prove it, and how they went.
std::string requirements_page(const std::vector<ExamplePage>& pages);

/// The same as text, with the last results.
std::string requirements_text(const std::vector<ExamplePage>& pages);

}  // namespace berm::verification
