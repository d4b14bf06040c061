// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/archive.hpp"

#include <cstring>
#include <map>

namespace berm::test {

/// The bytes of all that is kept, by name, to compare two states with.
class ArchiveInMemory : public Archive {
public:
  bool reads() const override { return false; }
  void refuse(const std::string& why) const override { throw RunError(why); }
  const std::map<std::string, std::string>& bytes() const { return bytes_; }

protected:
  void list(const std::string& path, std::vector<Real>& numbers) override { take(path, numbers); }
  void list(const std::string& path, std::vector<Index>& numbers) override { take(path, numbers); }
  void list(const std::string& path, std::vector<BigIndex>& numbers) override { take(path, numbers); }
  void list(const std::string& path, std::string& text) override { take(path, text); }

private:
  template <class List>
  void take(const std::string& path, const List& values)
  {
    if (bytes_.contains(path)) throw RunError(path + " is kept twice");
    bytes_[path] = std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
  }

  std::map<std::string, std::string> bytes_;
};

/// Names of what differs.
inline std::string differences(const ArchiveInMemory& a, const ArchiveInMemory& b)
{
  std::string names;
  for (const auto& [name, bytes] : a.bytes())
    if (const auto other = b.bytes().find(name); other == b.bytes().end() || other->second != bytes) names += name + " ";
  return a.bytes().size() == b.bytes().size() ? names : names + "(not the same names)";
}

}  // namespace berm::test
