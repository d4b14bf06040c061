// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "input/document.hpp"

namespace berm::input {

/// Reads one parameter from its node. `path` is its name in messages. Throws InputError (see refuse) where the node has the
/// wrong kind or dimension, is out of range, or is empty although the parameter is required.
class ValueReader {
public:
  ValueReader(const Document& document, const Node& node, std::string path, const Parameter& parameter)
      : document_(document),
        node_(node),
        path_(std::move(path)),
        parameter_(parameter)
  {
  }

  void operator()(Real* value) const { *value = number(node_, path_); }
  void operator()(std::optional<Real>* value) const { *value = number(node_, path_); }
  void operator()(int* value) const { *value = whole_number(node_, path_); }
  void operator()(bool* value) const;
  void operator()(std::string* value) const { *value = text(node_, path_); }
  void operator()(std::vector<std::string>* values) const;
  void operator()(std::vector<Real>* values) const;
  void operator()(std::map<std::string, Real>* values) const;
  void operator()(std::map<std::string, int>* values) const;
  void operator()(std::map<std::string, std::string>* values) const;

private:
  Real number(const Node& node, const std::string& path) const;
  int whole_number(const Node& node, const std::string& path) const;
  std::string text(const Node& node, const std::string& path) const;
  Real number_in_any_unit(const Node& node, const std::string& path) const;
  void check_range(const Node& node, const std::string& path, Real value) const;
  void check_array(const char* what, const char* example, const std::string& entries) const;
  void check_names(const char* to_what, const char* example) const;

  const Document& document_;
  const Node& node_;
  std::string path_;
  const Parameter& parameter_;
};

}  // namespace berm::input
