// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/study/study_test.cpp
#include "study/study_settings.hpp"

#include "input/message_text.hpp"
#include "input/reader.hpp"
#include "settings/symmetry.hpp"
#include "study/table_axis.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::study {
namespace {

constexpr const char* case_key = "case";
constexpr const char* why_key = "why";

template <class Item>
std::vector<std::string> names_of(const std::vector<Item>& items)
{
  std::vector<std::string> names;
  for (const Item& item : items) names.push_back(item.name);
  return names;
}

bool contains(const std::vector<std::string>& list, const std::string& word)
{
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// Names in one list differ, also as names of files.
template <class Item>
void check_names(Describe& d, const std::string& path, const std::vector<Item>& items)
{
  std::vector<std::string> before;
  for (std::size_t k = 0; k < items.size(); ++k) {
    const std::string name = as_file_name(items[k].name);
    const std::string fault = fault_of_name(items[k].name);
    d.check(fault.empty(), fmt::format("{}[{}].name", path, k), fault);
    d.check(!contains(before, name), fmt::format("{}[{}].name", path, k), "is the name, or as a file the name, of another before it");
    before.push_back(name);
  }
}

/// The keys of a [[skip]] are names of axes. They are taken out of the document before the others are read.
std::vector<std::vector<input::Node>> take_conditions(input::Document& document)
{
  std::vector<std::vector<input::Node>> conditions;
  input::Node* skips = member(document.root, "skip");
  if (skips == nullptr || skips->kind != input::Node::Kind::array) return conditions;
  for (input::Node& skip : skips->items) {
    std::vector<input::Node>& taken = conditions.emplace_back();
    for (const input::Node& item : skip.items)
      if (item.key != why_key) taken.push_back(item);
    std::erase_if(skip.items, [](const input::Node& item) { return item.key != why_key; });
  }
  return conditions;
}

/// One key of a [[skip]] and its text.
std::pair<std::string, std::string> condition_of(const input::Document& document, const input::Node& node, const Study& study)
{
  std::vector<std::string> keys = names_of(study.axis), values = names_of(study.cases);
  keys.insert(keys.begin(), case_key);
  const std::string path = "skip." + node.key;
  const auto axis = std::find(keys.begin(), keys.end(), node.key);
  if (axis == keys.end()) refuse(document, node, path, "is not an axis" + input::suggestion(node.key, keys));
  if (axis != keys.begin()) values = names_of(study.axis[static_cast<std::size_t>(axis - keys.begin()) - 1].value);
  if (node.kind != input::Node::Kind::text) refuse(document, node, path, fmt::format("must be a name in quotes, not {}", kind_of(node)));
  if (!contains(values, node.text))
    refuse(document, node, path, input::in_quotes(node.text) + " is none of its names" + input::suggestion(node.text, values));
  return {node.key, node.text};
}

/// The parts of a key between its dots.
std::vector<std::string> parts_of(const std::string& key)
{
  std::vector<std::string> parts(1);
  for (const char c : key)
    if (c == '.')
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

/// Whether two keys can mean the same value; * stands for every name.
bool overlap(const std::string& key, const std::string& other)
{
  const std::vector<std::string> one = parts_of(key), two = parts_of(other);
  return std::equal(one.begin(), one.end(), two.begin(), two.end(),
                    [](const std::string& a, const std::string& b) { return a == b || a == "*" || b == "*"; });
}

std::string key_of(const std::string& set)
{
  return set.substr(0, set.find('='));
}

/// The key that a value sets and one of the axes, or the value itself, sets too, and the name of that axis; empty where there is none.
std::pair<std::string, std::string> set_twice(const std::vector<StudyAxis>& axes, const StudyValue& value, const std::string& own_name)
{
  for (std::size_t k = 0; k < value.set.size(); ++k) {
    const std::string key = key_of(value.set[k]);
    for (std::size_t before = 0; before < k; ++before)
      if (overlap(key, key_of(value.set[before]))) return {key, own_name};
    for (const StudyAxis& axis : axes)
      for (const StudyValue& other : axis.value)
        for (const std::string& set : other.set)
          if (overlap(key, key_of(set))) return {key, axis.name};
  }
  return {};
}

/// Adds the axis of a table or a sample, which stands at the node.
void add_axis(const input::Document& document, const input::Node& node, const std::string& path, Study& study, const StudyAxis& axis)
{
  if (const std::string fault = fault_of_name(axis.name); !fault.empty()) refuse(document, node, path, "the name of its axis " + fault);
  if (contains(names_of(study.axis), axis.name) || axis.name == case_key || axis.name == why_key)
    refuse(document, node, path,
           fmt::format("there is another axis {0}, or it is a word that [[skip]] needs itself", input::in_quotes(axis.name)));
  if (axis.sample_from && sample_of(study) != nullptr)
    refuse(document, node, path,
           "is a second sample; put all columns into one file, or give the rows a column `name` where they are chosen and not drawn");
  if (const auto [key, by] = set_twice(study.axis, axis.value.back(), axis.name); !key.empty())
    refuse(document, node, path, fmt::format("{} is set twice, here and by {}", key, by));
  study.axis.push_back(axis);
}

/// Makes axes of the tables and of the sample.
void add_tables(const input::Document& document, Study& study)
{
  const std::filesystem::path folder = std::filesystem::path(document.file).parent_path();
  for (std::size_t k = 0; k < study.table.size(); ++k) {
    StudyTable& table = study.table[k];
    if (table.name.empty()) table.name = std::filesystem::path(table.file).stem().string();
    add_axis(document, member(document.root, "table")->items[k], "table." + table.name, study, read_table(folder / table.file, table.name));
  }
  if (study.sample) add_axis(document, *member(document.root, "sample"), "sample", study, sample_axis(*study.sample));
}

}  // namespace

void describe(Describe& d, StudyCase& c)
{
  d.value("name", c.name, {.meaning = "name of the case in the table", .required = true});
  d.value("file", c.file, {.meaning = "case file, relative to the study's folder", .required = true});
  d.value("set", c.set, {.meaning = "parameters changed in this case, each KEY=VALUE as for --set"});
}

void describe(Describe& d, StudyValue& value)
{
  d.value("name", value.name, {.meaning = "name of the value in the table", .required = true});
  d.value("set", value.set, {.meaning = "parameters changed for this value, each KEY=VALUE as for --set; * stands for every name"});
}

void describe(Describe& d, StudyAxis& axis)
{
  d.value("name", axis.name, {.meaning = "what is varied", .required = true});
  d.array("value", axis.value, {.meaning = "the values along the axis", .required = true});
}

void describe(Describe& d, StudyTable& table)
{
  d.value("name", table.name, {.meaning = "what is varied; absent: the name of the file"});
  d.value("file", table.file,
          {.meaning = "CSV file with keys in its first line and one row per line, relative to the study's folder", .required = true});
}

void describe(Describe& d, StudySkip& skip)
{
  d.value(why_key, skip.why, {.meaning = "reason for leaving out these combinations", .required = true});
}

void describe(Describe& d, StudyMeasure& measure)
{
  d.value("name", measure.name, {.meaning = "heading of the column", .required = true});
  describe(d, measure.observable);
  d.value("unit", measure.unit, {.meaning = "unit that is shown; absent: the SI unit of the number"});
  d.value("scale", measure.scale, {.meaning = "shown number divided by the number in SI units"});
  d.value("cases", measure.cases, {.meaning = "only for these cases; absent = all"});
  d.value("limit", measure.limit, {.meaning = "limit, as shown: a sample gives the probability of values below and above it"});
}

void describe(Describe& d, StudyFigure& figure)
{
  d.value("name", figure.name, {.meaning = "name of the figure and its file", .required = true});
  d.value("x", figure.x, {.meaning = "column of history.csv along the horizontal axis", .required = true});
  d.value("y", figure.y, {.meaning = "column of history.csv along the vertical axis", .required = true});
  d.value("stage", figure.stage, {.meaning = "rows of these stages only; absent = all"});
  d.value(case_key, figure.case_name, {.meaning = "curves of this case only; absent = all"});
  d.value("smooth", figure.smooth,
          {.meaning = "y is averaged over x +- this; absent: 0.01 of the diameter of the main rigid body",
           .range = not_negative,
           .any_unit = &figure.smooth_unit});
}

void describe(Describe& d, Study& study)
{
  d.value("title", study.title, {.meaning = "title of the table"});
  d.array(case_key, study.cases, {.meaning = "cases to run", .required = true});
  d.array("axis", study.axis, {.meaning = "what is varied"});
  d.array("table", study.table, {.meaning = "files whose rows are varied"});
  d.optional_table("sample", study.sample, {.meaning = "Latin hypercube of uncertain parameters, and seeds of random fields"});
  d.array("skip", study.skip, {.meaning = "combinations that are left out"});
  d.array("measure", study.measure, {.meaning = "columns of the table", .required = true});
  d.array("figure", study.figure, {.meaning = "figures of history curves"});
  const std::vector<std::string> cases = names_of(study.cases);
  check_names(d, case_key, study.cases);
  check_names(d, "axis", study.axis);
  check_names(d, "figure", study.figure);
  if (study.sample) {
    check_names(d, "sample.parameter", study.sample->parameter);
    check(d, *study.sample);
  }
  for (std::size_t k = 0; k < study.axis.size(); ++k) {
    const std::string path = fmt::format("axis[{}]", k);
    check_names(d, path + ".value", study.axis[k].value);
    d.check(study.axis[k].name != case_key && study.axis[k].name != why_key, path + ".name", "is a word that [[skip]] needs itself");
  }
  for (std::size_t k = 0; k < study.measure.size(); ++k) {
    const std::string path = fmt::format("measure[{}]", k);
    const StudyMeasure& measure = study.measure[k];
    check(d, path, measure.observable);
    const std::string fault = fault_of_name(measure.name);
    d.check(fault.empty(), path + ".name", fault);
    for (const std::string& name : measure.cases) d.check(contains(cases, name), path + ".cases", "there is no such case", cases);
  }
  for (std::size_t k = 0; k < study.figure.size(); ++k) {
    const std::string& name = study.figure[k].case_name;
    d.check(name.empty() || contains(cases, name), fmt::format("figure[{}].case", k), "there is no such case", cases);
  }
}

input::Listed study_catalogue()
{
  input::Listed all = input::catalogue_of<Study>();
  std::ranges::find(all.children, "skip", &input::Listed::key)->children.clear();  // its keys are the names of axes
  return all;
}

Study read_study(const std::filesystem::path& file)
{
  input::Document document = input::parse_file(file);
  const std::vector<std::vector<input::Node>> conditions = take_conditions(document);
  Study study;
  read(document, study);
  add_tables(document, study);
  for (std::size_t k = 0; k < study.skip.size(); ++k) {
    for (const input::Node& node : conditions[k]) study.skip[k].where.push_back(condition_of(document, node, study));
    if (conditions[k].empty())
      refuse(document, member(document.root, "skip")->items[k], "skip", "names no axis and would leave out everything");
  }
  return study;
}

const StudyAxis* sample_of(const Study& study)
{
  for (const StudyAxis& axis : study.axis)
    if (axis.sample_from) return &axis;
  return nullptr;
}

std::string fault_of_name(const std::string& name)
{
  constexpr std::size_t most = 100;
  if (name.size() > most) return fmt::format("is longer than {} bytes", most);
  const bool signs = name.starts_with('+') || name.starts_with('-');
  const bool formula = name.starts_with('=') || name.starts_with('@') || (signs && name.find_first_of("(|!") != std::string::npos);
  return formula ? input::in_quotes(name) + " is a formula to a spreadsheet" : "";
}

std::string as_file_name(std::string name)
{
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && std::string("._-=+").find(c) == std::string::npos) c = '_';
  if (name.find_first_not_of('.') == std::string::npos) name.insert(name.begin(), '_');  // "." and ".." are other folders
  return name;
}

}  // namespace berm::study
