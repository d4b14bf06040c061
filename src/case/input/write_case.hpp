// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"

namespace berm::input {

/// Value of a parameter; std::monostate where it is not set.
using SettingValue = std::variant<std::monostate, Real, int, bool, std::string, std::vector<std::string>, std::vector<Real>,
                                  std::map<std::string, Real>, std::map<std::string, int>, std::map<std::string, std::string>>;

/// A parameter with its value.
struct Setting {
  std::string key;
  SettingValue value;
  std::string unit;  ///< SI, "" of dimensionless numbers and words
  std::string meaning;
};

/// A table of parameters and its nested tables.
struct SettingTable {
  std::string path;   ///< dotted, "" of the root
  bool item = false;  ///< of an array
  std::vector<Setting> settings;
  std::vector<SettingTable> tables;
};

/// Records every parameter of a struct, with its value, its SI unit and its meaning.
class SettingVisitor : public Describe {
public:
  explicit SettingVisitor(bool whole = false) : whole_(whole) { open_.push_back(&root_); }
  const SettingTable& root() const { return root_; }
  void check(bool, const std::string&, const std::string&, const std::vector<std::string>&) override {}

protected:
  void leaf(const char* key, Leaf variable, const Parameter& parameter) override;
  int choose(const char* key, const std::vector<const char*>& names, int current, const Parameter& parameter) override;
  void enter(const char* key, const Parameter& parameter) override;
  void leave() override { open_.pop_back(); }
  bool has_table(const char*, bool present) override { return present; }
  std::vector<std::string> names_in(const char*, const std::vector<std::string>& present, const Parameter&) override { return present; }
  void enter_named(const char* key, const std::string& name) override;
  int count_in(const char*, int present, const Parameter&) override { return present; }
  void enter_item(const char* key, int item) override;

private:
  SettingTable& open(const std::string& key);

  SettingTable root_;
  std::vector<SettingTable*> open_;
  bool whole_;  ///< quantities are not per metre run
};

/// As TOML: every value in SI units, with unit and meaning in a comment. Reading the text gives the same struct.
std::string toml_of(const SettingTable& table);

/// All parameters of a case with their values, defaults included.
SettingTable all_settings(const settings::Case& settings);

/// The whole case as TOML, with every default filled in, in SI units: resolved.toml.
std::string resolved_toml(const settings::Case& settings);

/// A resolved.toml without its last table, [report], which changes no result: cases are the same where these are.
std::string_view without_report(std::string_view resolved);

}  // namespace berm::input
