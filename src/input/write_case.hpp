// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/case.hpp"

namespace berm {

/// What a parameter is set to; std::monostate where it is left out.
using SettingValue = std::variant<std::monostate, Real, int, bool, std::string, std::vector<std::string>, std::vector<Real>,
                                  std::map<std::string, Real>, std::map<std::string, int>>;

/// A parameter as a struct has it.
struct Setting {
  std::string key;
  SettingValue value;
  std::string unit;  ///< SI, "" of bare numbers and words
  std::string meaning;
};

/// A table of parameters and the tables inside it.
struct SettingTable {
  std::string path;   ///< dotted, "" of the root
  bool item = false;  ///< of an array
  std::vector<Setting> settings;
  std::vector<SettingTable> tables;
};

/// All parameters of a case as they are, defaults included.
SettingTable all_settings(const Case& settings);

/// The whole case as TOML, with every default filled in, in SI units: resolved.toml.
std::string resolved_toml(const Case& settings);

}  // namespace berm
