// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/document.hpp"
#include "problem/case.hpp"

namespace berm::report {

/// What a parameter of a case must be.
struct TestCondition {
  std::string path;  ///< "geometry", "material.*.friction_angle": * stands for any one name
  std::optional<Real> number;
  std::string word;  ///< instead of a number
};

/// Parameters that a run must have. Those with the same * must be found in one table: "material.*" is one material.
struct TestConditions {
  std::vector<TestCondition> all;
  Real tolerance = 0.002;  ///< largest |value / number - 1|
};

/// Takes the keys of a table that are parameters of a case, in quotes or as tables within, out of the document; `kept` are keys that stay. Throws
/// InputError where there is no such parameter, where it is not a number, a word or a list of numbers (of which the length as a vector is meant), or has
/// another unit.
std::vector<TestCondition> take_conditions(const input::Document& document, input::Node& table, const std::string& path,
                                           const std::vector<std::string>& kept);

/// Throws InputError where a case has no parameter of this path, in which * stands for any one name.
void refuse_unknown_parameter(const input::Document& document, const input::Node& node, const std::string& at, const std::string& path);

/// Whether the case has all of these parameters.
bool meets(const problem::Case& settings, const TestConditions& conditions);

/// The values of a parameter in a case, by name of its table, as text.
std::string values_of(const problem::Case& settings, const std::string& path);

}  // namespace berm::report
