// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/usual.hpp"
#include "input/document.hpp"

namespace berm::input {

/// Condition of a key: another key of the same table, the selector, has this word.
struct Condition {
  std::string selector, word;
};

/// A parameter or a table of parameters, as declared.
struct Listed {
  enum class Kind {
    value,
    word,          ///< one of `words`
    table,         ///< [mesh]
    named_tables,  ///< [material.NAME]
    array          ///< [[stage]]
  };
  enum class Type { number, whole_number, truth, text, texts, numbers, number_by_name, whole_number_by_name, text_by_name };
  /// As one may write it in a case; std::monostate: there is none.
  using Default = std::variant<std::monostate, bool, int, Real, std::string, std::vector<Real>, std::vector<std::string>>;

  Kind kind = Kind::table;
  std::string key, meaning, unit;
  Type type = Type::text;  ///< of a value
  Default default_value;
  std::string default_text;               ///< the same, for readers; "" where there is none
  std::vector<std::string> number_words;  ///< that may stand for the number
  Range range, usual;
  bool required = false;
  std::vector<std::string> words;
  std::vector<Condition> conditions;
  std::vector<Listed> children;  ///< of tables
};

/// Lists all parameters of a struct, those of every alternative included.
class Lister : public Describe, public AsksUsual {
public:
  Lister() { levels_.push_back({&root_, {}}); }
  const Listed& root() const { return root_; }
  void check(bool, const std::string&, const std::string&, const std::vector<std::string>&) override {}
  void usual(const UsualNumber& number) override;

protected:
  void leaf(const char* key, Leaf variable, const Parameter& parameter) override;
  int choose(const char* key, const std::vector<const char*>& names, int current, const Parameter& parameter) override;
  void enter(const char* key, const Parameter& parameter) override;
  void leave() override { levels_.pop_back(); }
  bool has_table(const char*, bool) override { return true; }
  std::vector<std::string> names_in(const char* key, const std::vector<std::string>& present, const Parameter& parameter) override;
  void enter_named(const char* key, const std::string& name) override;
  int count_in(const char* key, int present, const Parameter& parameter) override;
  void enter_item(const char* key, int item) override;
  bool lists_all() const override { return true; }
  void begin_alternative(const char* key, const char* name) override { levels_.back().conditions.push_back({key, name}); }
  void end_alternative() override { levels_.back().conditions.pop_back(); }

private:
  struct Level {
    Listed* table;
    std::vector<Condition> conditions;
  };

  Listed& add(Listed::Kind kind, const char* key, const Parameter& parameter);

  Listed root_;
  std::vector<Level> levels_;
};

/// "number", "list of texts or "unlimited"", "word".
std::string type_words(const Listed& entry);

/// All parameters of a struct. describe(Describe&, T&) must not depend on values.
template <class T>
Listed catalogue_of()
{
  T all{};
  Lister lister;
  describe(lister, all);
  return lister.root();
}

/// Throws InputError for the first key that no parameter of the catalogue has at that level, with the nearest known one; for
/// a key of an alternative that is not chosen; and for an override through a name that the file does not have.
void refuse_unknown_keys(const Document& document, const Listed& catalogue);

/// Throws InputError for the first key that was not read.
void refuse_unused_keys(const Document& document);

/// The parameters of another kind of input than a case.
struct OtherInput {
  std::string heading;  ///< of its keys outside of tables
  Listed keys;
};

/// All parameters of a case, then those of other inputs, as aligned plain text, for `berm params`.
std::string parameter_table(const Listed& of_case, const std::vector<OtherInput>& others = {});

/// The same as Markdown: docs/parameters.md, for `berm params --markdown`.
std::string parameter_page(const Listed& of_case, const std::vector<OtherInput>& others = {});

/// JSON Schema, draft 4, of an input with these parameters: what editors complete and check by. Where a word selects keys, each word is an alternative of oneOf.
std::string json_schema(const Listed& of_input, const std::string& title);

}  // namespace berm::input
