// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/catalogue.hpp"

namespace berm::input {

/// Fills a struct from a document, marks what it reads as used, and throws InputError (see refuse) at the first invalid
/// value.
class Reader : public Describe {
public:
  explicit Reader(Document& document);
  void check(bool valid, const std::string& path, const std::string& message, const std::vector<std::string>& allowed = {}) override;

protected:
  void leaf(const char* key, Leaf variable, const Parameter& parameter) override;
  int choose(const char* key, const std::vector<const char*>& names, int current, const Parameter& parameter) override;
  void enter(const char* key, const Parameter& parameter) override;
  void leave() override { levels_.pop_back(); }
  bool has_table(const char* key, bool present) override;
  std::vector<std::string> names_in(const char* key, const std::vector<std::string>& present, const Parameter& parameter) override;
  void enter_named(const char* key, const std::string& name) override;
  int count_in(const char* key, int present, const Parameter& parameter) override;
  void enter_item(const char* key, int item) override;

private:
  /// The table being read. Where it is absent, `table` is null and `nearest` its nearest parent that exists.
  struct Level {
    Node* table;
    const Node* nearest;
    std::string path;
  };

  Node* find(const char* key);
  std::string path_of(const std::string& key) const;
  void step_into(Node* table, const std::string& path);
  [[noreturn]] void refuse_missing(const char* key, const std::string& what, const std::vector<std::string>& words = {}) const;

  Document& document_;
  bool whole_ = false;  ///< space or axisymmetry: quantities are not per metre run
  std::vector<Level> levels_;
};

/// Reads a document into a struct and refuses every key that the struct does not have.
template <class T>
void read(Document& document, T& value)
{
  static const Listed catalogue = catalogue_of<T>();
  refuse_unknown_keys(document, catalogue);
  Reader reader(document);
  describe(reader, value);
  refuse_unused_keys(document);
}

}  // namespace berm::input
