// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_templates_test.cpp
#include "sanity/questions.hpp"
#include "sanity/sanity.hpp"

#include "core/usual.hpp"
#include "input/message_text.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::sanity {
namespace {

/// Calls unusual(path, number, unit, usual size) for each number whose size is beyond what is declared as usual; of a list for the first.
template <class Unusual>
class UsualNumbers : public Describe, public AsksUsual {
public:
  explicit UsualNumbers(const Unusual& unusual) : unusual_(unusual) {}
  void check(bool, const std::string&, const std::string&, const std::vector<std::string>&) override {}
  void usual(const UsualNumber& declared) override
  {
    const auto doubted = [&](Real x) { return x != 0 && std::isfinite(x) && !input::within(std::abs(x), declared.size); };
    const std::string path = path_of(declared.key);
    const auto found = numbers_.find(path);
    if (found == numbers_.end()) return;
    const auto& [numbers, unit] = found->second;
    if (const auto first = std::find_if(numbers.begin(), numbers.end(), doubted); first != numbers.end())
      unusual_(path, *first, unit, declared.size);
  }

protected:
  void leaf(const char* key, Leaf variable, const Parameter& parameter) override
  {
    std::vector<Real> numbers;
    if (const auto* number = std::get_if<Real*>(&variable)) numbers = {**number};
    if (const auto* number = std::get_if<std::optional<Real>*>(&variable); number != nullptr && **number) numbers = {***number};
    if (const auto* list = std::get_if<std::vector<Real>*>(&variable)) numbers = **list;
    numbers_[path_of(key)] = {numbers, parameter.unit};
  }
  int choose(const char*, const std::vector<const char*>&, int current, const Parameter&) override { return current; }
  void enter(const char* key, const Parameter&) override { paths_.push_back(path_of(key)); }
  void leave() override { paths_.pop_back(); }
  bool has_table(const char*, bool present) override { return present; }
  std::vector<std::string> names_in(const char*, const std::vector<std::string>& present, const Parameter&) override { return present; }
  void enter_named(const char* key, const std::string& name) override { paths_.push_back(path_of(key) + "." + name); }
  int count_in(const char*, int present, const Parameter&) override { return present; }
  void enter_item(const char* key, int item) override { paths_.push_back(fmt::format("{}[{}]", path_of(key), item)); }

private:
  std::string path_of(const std::string& key) const { return paths_.empty() ? key : paths_.back() + "." + key; }

  const Unusual& unusual_;
  std::vector<std::string> paths_;
  std::map<std::string, std::pair<std::vector<Real>, std::string>> numbers_;  ///< and their unit, by path
};

/// "206 MPa", "1e-12 m/s".
std::string with_prefix(Real value, const std::string& unit)
{
  const bool takes_prefix = unit.starts_with("Pa") || unit.starts_with("N");
  const Real size = std::abs(value);
  if (!takes_prefix || size < 1e3 || !std::isfinite(value)) return input::quantity(value, unit);
  const auto [factor, prefix] = size >= 1e9 ? std::pair(1e9, "G") : size >= 1e6 ? std::pair(1e6, "M") : std::pair(1e3, "k");
  return fmt::format("{:.4g} {}{}", value / factor, prefix, unit);
}

}  // namespace

void are_numbers_usual(const Scene& s, Findings& found)
{
  const auto unusual = [&](const std::string& key, Real number, const std::string& unit, const Range& usual) {
    if (!s.places.has(key)) return;
    found.warn(key, fmt::format("is {}; usual values are {} to {}: {}", with_prefix(number, unit), with_prefix(usual.min, unit),
                                with_prefix(usual.max, unit), unit.empty() ? "is that intended?" : "is its unit right?"));
  };
  settings::Case copy = s.c;
  UsualNumbers visitor(unusual);
  describe(visitor, copy);
}

}  // namespace berm::sanity
