// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

#include <initializer_list>

namespace berm {

/// The size of a number that soil, steel and sea have, under its key in the table in hand, "profile.cohesion" in one of its tables; 0 is always usual.
struct UsualNumber {
  const char* key;
  Range size;  ///< SI
};

/// A visitor of parameters (Describe) that asks for usual numbers.
class AsksUsual {
public:
  virtual void usual(const UsualNumber& number) = 0;

protected:
  ~AsksUsual() = default;
};

/// Declares, after the parameters of a struct, what is usual of them: `berm check` doubts a number whose size is beyond, and does not refuse it.
inline void declare_usual(Describe& d, std::initializer_list<UsualNumber> numbers)
{
  if (auto* asking = dynamic_cast<AsksUsual*>(&d))
    for (const UsualNumber& number : numbers) asking->usual(number);
}

}  // namespace berm
