// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/case.hpp"

namespace berm {

/// Writes a struct as TOML: every value in SI units, with its unit and meaning beside it. Reading the text gives the same struct.
class Writer : public Describe {
public:
  explicit Writer(bool in_space = false) : in_space_(in_space) { open_.push_back(&root_); }
  std::string text() const;
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
  struct Line {
    std::string setting, comment;
  };
  struct Table {
    std::string path;   ///< dotted, "" of the root
    bool item = false;  ///< of an array
    std::vector<Line> lines;
    std::vector<Table> tables;
  };

  Table& open(const std::string& key);
  static void write(const Table& table, std::string& text);

  Table root_;
  std::vector<Table*> open_;
  bool in_space_;  ///< quantities per metre run are whole
};

/// The whole case as TOML, with every default filled in, in SI units: resolved.toml.
std::string resolved_toml(const Case& settings);

}  // namespace berm
