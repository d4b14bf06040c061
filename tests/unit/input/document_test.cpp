// SPDX-License-Identifier: BSD-3-Clause
#include "input/document.hpp"
#include "input/override.hpp"
#include "os/error.hpp"
#include "samples/wrong_inputs.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <random>

namespace berm::input::this_file {
namespace {

std::string message_of(const std::string& text)
{
  try {
    parse_text("case.toml", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string repeated(const std::string& text, int times)
{
  std::string all;
  for (int k = 0; k < times; ++k) all += text;
  return all;
}

const Node& at(const Node& node, const std::string& key)
{
  const Node* found = member(node, key);
  if (found == nullptr) throw std::out_of_range(key);
  return *found;
}

TEST(Document, keeps_values_lines_and_the_order_of_the_file)
{
  const Document document = parse_text(
      "case.toml", "z = 1\na = 2.5\n\n[material.sand]\nfine = true\n[material.clay]\nname = 'x'\n[[stage]]\nlist = [1,\n 2]\n[[stage]]\n");
  ASSERT_EQ(document.root.items.size(), 4u);
  EXPECT_EQ(document.root.items[0].key, "z");
  EXPECT_EQ(document.root.items[1].key, "a");
  EXPECT_EQ(document.root.items[1].line, 2);
  EXPECT_DOUBLE_EQ(document.root.items[1].number, 2.5);
  const Node& materials = at(document.root, "material");
  ASSERT_EQ(materials.items.size(), 2u);
  EXPECT_EQ(materials.items[0].key, "sand");
  EXPECT_EQ(materials.items[0].line, 4);
  EXPECT_EQ(materials.items[1].key, "clay");
  EXPECT_EQ(name_of(materials.items[1]), "x");
  const Node& stages = at(document.root, "stage");
  ASSERT_EQ(stages.items.size(), 2u);
  EXPECT_EQ(stages.items[1].line, 11);
  EXPECT_EQ(at(stages.items[0], "list").items[1].whole, 2);
}

TEST(Document, may_be_empty_and_may_end_its_lines_as_windows_does)
{
  EXPECT_TRUE(parse_text("case.toml", "").root.items.empty());
  const Document document = parse_text("case.toml", "\xEF\xBB\xBF"
                                                    "a = 1\r\n[t]\r\nb = \"x\"\r\n");
  EXPECT_EQ(at(at(document.root, "t"), "b").text, "x");
  EXPECT_EQ(at(at(document.root, "t"), "b").line, 3);
}

TEST(Document, refuses_what_is_no_toml_in_one_line_with_its_place)
{
  const std::string wrong[] = {"[&",
                               "[[",
                               "[",
                               "[[&]]",
                               "[a.&",
                               "a = [&",
                               "a = {&",
                               "&",
                               "a",
                               "a =",
                               "a = = 1",
                               "= 1",
                               "[]",
                               "[[]]",
                               "a.b",
                               "a = 1 2",
                               "a = \"",
                               "a = '''",
                               "a = 1__0",
                               "a = 99999999999999999999999",
                               "a = 1e",
                               "a = \xff\xfe",
                               "\xff",
                               "a = \"\xc3\x28\"",
                               std::string("a = 1\0 2", 8),
                               "a = 1\nb = 2\na = 3",
                               "a = 1\n[a]\n",
                               repeated("[", 1000),
                               "a = " + repeated("[", 100000),
                               "a = " + repeated("{a=", 10000),
                               repeated("a.", 400000) + "a = 1",
                               "a = " + repeated("[\n", 100000),
                               repeated("[a]\n", 2),
                               repeated("]", 1000),
                               "a = 1\r b = 2",
                               "a = 2024-13-45",
                               "a = \"\\q\"",
                               "a = \"\\ud800\"",
                               "[a\n]",
                               "a = {b = 1,}",
                               "a = {b = 1\n}",
                               "é = 1",
                               "a é = 1",
                               "a = é",
                               "a = 1 é",
                               "[é]"};
  for (const std::string& text : wrong) {
    const std::string message = message_of(text);
    EXPECT_TRUE(message.starts_with("case.toml:")) << text.substr(0, 40) << " gives: " << message;
    EXPECT_GT(std::atoi(message.c_str() + 10), 0) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_LT(message.size(), 400u) << message;
  }
}

TEST(Document, refuses_a_file_too_long_to_be_a_case)
{
  const auto path = std::filesystem::temp_directory_path() / "berm_brackets.toml";
  std::ofstream(path) << std::string(20'000'000, '[');
  EXPECT_THROW(parse_file(path), InputError);
  std::filesystem::remove(path);
  EXPECT_FALSE(message_of(std::string(20'000'000, '[')).empty());
}

TEST(Document, counts_dots_of_keys_and_not_of_texts_or_numbers)
{
  EXPECT_NO_THROW(parse_text("case.toml", "a = \"\"\"\n" + repeated(". ", 200) + "\n\"\"\"\nb = '''" + repeated("x.", 99) + "'''\n"));
  EXPECT_NO_THROW(
      parse_text("case.toml", "a = \"" + repeated(". ", 200) + "\"\nb = [" + repeated("0.5, ", 200) + "]\n# " + repeated("x", 10) + "\n"));
}

// Each is TOML but for the depth, and no deeper than the call stack of whoever visits it.
TEST(Document, refuses_keys_with_too_many_dots_wherever_quotes_stand)
{
  const std::string deep = repeated("a.", 100'000) + "a";
  for (const std::string& text :
       {deep + " = 1\n", "[" + deep + "]\n", "t = {" + deep + " = '1'}\n", "t = {k = \"\"\"\n\"\"\", " + deep + " = \"1\"}\n",
        "t = {k = '''\n''', " + deep + " = '1'}\n", "t = {k = \"\"\"\\\"\"\"\", " + deep + " = \"1\"}\n",
        "t = {k = \"\"\"\"\"\"\"\", " + deep + " = \"1\"}\n", "t = {k = \"\\\"\", " + deep + " = \"1\"}\n",
        "t = {\"k\" = '\"', " + deep + " = '\"'}\n", "# it's\n" + deep + " = '1'\n"}) {
    const std::string message = message_of(text);
    EXPECT_NE(message.find("a key has more than 32 dots"), std::string::npos) << message << " for " << text.substr(0, 40);
  }
}

TEST(Document, survives_random_marks)
{
  std::mt19937 random(2);
  const std::string marks = "[]{}\"'=.,#\n\r a1&\\_-+";
  for (int trial = 0; trial < 50000; ++trial) {
    std::string text;
    for (auto length = random() % 12; length > 0; --length) text += marks[random() % marks.size()];
    message_of(text);
  }
}

TEST(Override, replaces_and_adds_values)
{
  Document document = parse_text("case.toml", std::string(test::good_case));
  for (const char* override :
       {"material.sand.friction_angle=\"40 deg\"", "material.sand.cohesion=1 kPa", "stage.drag.until.displacement=40 mm", "mpm.courant=0.3",
        "gravity=[0, \"-2 gravity\"]", "title=40 deg", "body.bed.region_damping.\"a.b\"=.5", "mpm.volumetric_projection=true"})
    apply_override(document, override);
  const Node& root = document.root;
  const Node& angle = at(at(at(root, "material"), "sand"), "friction_angle");
  EXPECT_EQ(angle.text, "40 deg");
  EXPECT_EQ(angle.override_key, "material.sand.friction_angle");
  EXPECT_EQ(at(at(at(root, "material"), "sand"), "cohesion").text, "1 kPa");
  EXPECT_EQ(at(at(at(root, "stage").items[1], "until"), "displacement").text, "40 mm");
  EXPECT_DOUBLE_EQ(at(at(root, "mpm"), "courant").number, 0.3);
  EXPECT_TRUE(at(at(root, "mpm"), "volumetric_projection").truth);
  EXPECT_EQ(at(root, "gravity").items[1].text, "-2 gravity");
  EXPECT_EQ(at(at(at(at(root, "body"), "bed"), "region_damping"), "a.b").text, ".5");
  EXPECT_EQ(at(root, "gravity").items[1].override_key, "gravity");
}

TEST(Override, with_a_star_sets_every_table_of_its_place)
{
  Document document = parse_text("case.toml", std::string(test::good_case));
  apply_override(document, "material.*.density=1500");
  apply_override(document, "stage.*.damping=0.3");
  for (const char* name : {"sand", "rubber"}) EXPECT_EQ(at(at(at(document.root, "material"), name), "density").whole, 1500) << name;
  for (const Node& stage : at(document.root, "stage").items) EXPECT_DOUBLE_EQ(at(stage, "damping").number, 0.3);
}

TEST(Override, cannot_bring_a_second_key)
{
  Document document = parse_text("case.toml", "");
  apply_override(document, "title=1\nsurface=2");
  ASSERT_EQ(document.root.items.size(), 1u);
  EXPECT_EQ(document.root.items[0].text, "1\nsurface=2");
}

}  // namespace
}  // namespace berm::input::this_file
