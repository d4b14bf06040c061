// SPDX-License-Identifier: BSD-3-Clause
#include "input/read_case.hpp"
#include "input/reader.hpp"
#include "input/write_case.hpp"
#include "os/error.hpp"
#include "samples/small_cases.hpp"
#include "samples/wrong_inputs.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace berm::input::this_file {

/// One parameter of every kind.
struct Inner {
  Real depth = 1;
};
struct Wide {
  Real width = 0.1;
  int level = 2;
};
struct Tall {
  Real height = 0.2;
};
enum class Color { red, green };
struct Everything {
  Real number = 1.5;
  std::optional<Real> maybe;
  int count = 3;
  bool flag = false;
  std::string text;
  std::vector<std::string> texts;
  std::vector<Real> numbers;
  std::map<std::string, Real> by_name;
  std::map<std::string, int> counts;
  Color color = Color::green;
  std::variant<Wide, Tall> shape;
  Inner inner;
  std::optional<Inner> maybe_inner;
  std::vector<std::pair<std::string, Inner>> named;
  std::vector<Inner> row;
};

void describe(Describe& d, Inner& inner)
{
  d.value("depth", inner.depth, {.meaning = "depth", .unit = "m"});
}
void describe(Describe& d, Wide& wide)
{
  d.value("width", wide.width, {.meaning = "width", .unit = "m"});
  d.value("level", wide.level, {.meaning = "level"});
}
void describe(Describe& d, Tall& tall)
{
  d.value("height", tall.height, {.meaning = "height", .unit = "m"});
}
void describe(Describe& d, Everything& e)
{
  d.optional_table("maybe_inner", e.maybe_inner, {.meaning = "a table that may be left out"});
  d.table("inner", e.inner, {.meaning = "a table"});
  d.array("row", e.row, {.meaning = "tables in a row"});
  d.named_tables("named", e.named, {.meaning = "tables with names"});
  d.one_of("shape", e.shape, {"wide", "tall"}, {.meaning = "one of two"});
  d.choice("color", e.color, {"red", "green"}, {.meaning = "a word"});
  d.value("number", e.number, {.meaning = "a number", .unit = "Pa"});
  d.value("maybe", e.maybe, {.meaning = "a number that may be left out", .unit = "rad"});
  d.value("count", e.count, {.meaning = "a whole number"});
  d.value("flag", e.flag, {.meaning = "true or false"});
  d.value("text", e.text, {.meaning = "a text"});
  d.value("texts", e.texts, {.meaning = "texts"});
  d.value("numbers", e.numbers, {.meaning = "numbers", .unit = "m"});
  d.value("by_name", e.by_name, {.meaning = "numbers by name"});
  d.value("counts", e.counts, {.meaning = "whole numbers by name"});
}

namespace {

std::string written(Everything e)
{
  SettingVisitor visitor;
  describe(visitor, e);
  return toml_of(visitor.root());
}

Everything read_back(const std::string& text)
{
  Document document = parse_text("resolved.toml", text);
  Everything e;
  read(document, e);
  return e;
}

Real finite(Real value)
{
  return std::isfinite(value) ? value : -0.0;
}

void expect_same(const Everything& a, const Everything& b)
{
  RC_ASSERT(a.number == b.number);
  RC_ASSERT(std::signbit(a.number) == std::signbit(b.number));
  RC_ASSERT(a.maybe == b.maybe);
  RC_ASSERT(a.count == b.count);
  RC_ASSERT(a.flag == b.flag);
  RC_ASSERT(a.text == b.text);
  RC_ASSERT(a.texts == b.texts);
  RC_ASSERT(a.numbers == b.numbers);
  RC_ASSERT(a.by_name == b.by_name);
  RC_ASSERT(a.counts == b.counts);
  RC_ASSERT(a.color == b.color);
  RC_ASSERT(a.shape.index() == b.shape.index());
  RC_ASSERT(a.inner.depth == b.inner.depth);
  RC_ASSERT(a.maybe_inner.has_value() == b.maybe_inner.has_value());
  RC_ASSERT(a.named.size() == b.named.size());
  for (std::size_t k = 0; k < a.named.size(); ++k)
    RC_ASSERT(a.named[k].first == b.named[k].first && a.named[k].second.depth == b.named[k].second.depth);
  RC_ASSERT(a.row.size() == b.row.size());
}

/// Any text that is UTF-8: here ASCII, control characters included, and one letter of two bytes.
std::string any_text()
{
  std::string text;
  for (const int c : *rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 129)))
    text += c == 128 ? std::string("é") : std::string(1, static_cast<char>(c));
  return text;
}

TEST(RoundTrip, of_any_values_is_exact)
{
  rc::check([] {
    Everything e;
    e.number = finite(*rc::gen::arbitrary<double>());
    if (*rc::gen::arbitrary<bool>()) e.maybe = finite(*rc::gen::arbitrary<double>());
    e.count = *rc::gen::arbitrary<int>();
    e.flag = *rc::gen::arbitrary<bool>();
    e.text = any_text();
    if (const std::string text = any_text(); !text.empty()) e.texts = {text, "\"\\\t"};
    for (const double number : *rc::gen::arbitrary<std::vector<double>>()) e.numbers.push_back(finite(number));
    if (const std::string name = any_text(); !name.empty()) e.by_name = {{name, 0.1}, {"a.b", -3}}, e.counts = {{name, -7}};
    e.color = *rc::gen::element(Color::red, Color::green);
    if (*rc::gen::arbitrary<bool>()) e.shape = Tall{0.7};
    if (*rc::gen::arbitrary<bool>()) e.maybe_inner.emplace();
    e.named = {{"z", {1e-300}}, {"a-1_é", {0.1}}};
    e.row.resize(*rc::gen::inRange(0, 4));
    const std::string text = written(e);
    const Everything back = read_back(text);
    expect_same(e, back);
    RC_ASSERT(written(back) == text);
  });
}

TEST(RoundTrip, of_a_case_is_the_same_text_twice_and_has_every_default)
{
  const std::string once = resolved_toml(read_case_text("case.toml", std::string(test::good_case)));
  EXPECT_EQ(resolved_toml(read_case_text("resolved.toml", once)), once);
  for (const char* part :
       {"velocity_filter = 0.1", "friction_angle = 0.610865238198", "gravity = [0, -9.80665]", "\n[[stage]]\n", "\n[stage.until]\n",
        "\n[material.sand]\n", "geometry = \"plane_strain\"", "cohesion = 0", "[Pa] Young's modulus"})
    EXPECT_NE(once.find(part), std::string::npos) << part << " is not in\n" << once;
}

TEST(RoundTrip, of_clay_whose_stiffness_follows_its_strength_keeps_it)
{
  std::string text = test::small_case;
  const std::string sand =
      "law = \"mohr_coulomb\"\ndensity = \"877 kg/m^3\"\nyoung_modulus = \"7 MPa\"\npoisson_ratio = 0.25\nfriction_angle = \"35 deg\"\n";
  text.replace(text.find(sand), sand.size(), R"(law = "clay"
density = "877 kg/m^3"
rigidity_index = 100
poisson_ratio = 0.45
undrained_strength = "14 kPa"
)");
  const settings::Case first = read_case_text("case.toml", text), again = read_case_text("resolved.toml", resolved_toml(first));
  EXPECT_EQ(first.material[0].second, again.material[0].second);
  EXPECT_NEAR(elasticity(again.material[0].second).shear, 1.4e6, 1e-6);
}

TEST(RoundTrip, of_a_word_that_stands_for_a_number_is_the_word)
{
  const auto written_of = [](const std::string& value) {
    const settings::Case c = read_case_text("case.toml", std::string(test::good_case),
                                            {"contact.pipe_on_bed.scheme=musl_coupled", "contact.pipe_on_bed.tension=" + value});
    return std::pair(c.contact[0].second.tension, resolved_toml(c));
  };
  const auto [unlimited, unlimited_text] = written_of("unlimited");
  EXPECT_EQ(unlimited, infinity);
  EXPECT_NE(unlimited_text.find("tension = \"unlimited\""), std::string::npos) << unlimited_text;
  EXPECT_EQ(read_case_text("resolved.toml", unlimited_text).contact[0].second.tension, infinity);
  const auto [none_of_it, none_text] = written_of("none");
  EXPECT_EQ(none_of_it, 0);
  EXPECT_NE(none_text.find("tension = \"none\""), std::string::npos) << none_text;
  EXPECT_EQ(written_of("5 kPa").first, 5000);
}

TEST(RoundTrip, in_space_has_whole_forces_and_masses_where_the_plane_has_them_per_metre)
{
  const std::string text = R"(geometry = "space"
[mesh]
kind = "box"
size = [1, 1, 1]
cells = [2, 2, 2]
[material.solid]
law = "linear_elastic"
density = 1000
young_modulus = 1e6
poisson_ratio = 0.3
[body.solid]
material = "solid"
regions = ["box"]
[rigid.plate]
shape = "half_plane"
point = [0, 1, 0]
normal = [0, -1, 0]
mass = "5 kg"
[contact.above]
body = "solid"
rigid = "plate"
friction_angle = 0
[[stage]]
name = "push"
kind = "push"
force = "2 kN"
until.time = 1
)";
  const settings::Case c = read_case_text("case.toml", text);
  EXPECT_EQ(c.rigid[0].second.mass, 5);
  EXPECT_EQ(c.stage[0].force.value(), 2000);
  EXPECT_NE(resolved_toml(c).find("# [N] force of the drive"), std::string::npos) << resolved_toml(c);
  EXPECT_THROW(read_case_text("case.toml", text, {"stage.push.force=\"2 kN/m\""}), InputError);
}
TEST(RoundTrip, of_an_override_is_as_if_the_file_said_so)
{
  std::string changed(test::good_case);
  changed.replace(changed.find("\"35 deg\""), 8, "\"40 deg\"");
  changed.replace(changed.find("\"0.4 m\""), 7, "\"40 mm\"");
  const settings::Case by_override = read_case_text("case.toml", std::string(test::good_case),
                                                    {"material.sand.friction_angle=40 deg", "stage.drag.until.displacement=\"40 mm\""});
  EXPECT_EQ(resolved_toml(by_override), resolved_toml(read_case_text("case.toml", changed)));
}

TEST(resolved_case, without_its_report_is_the_same_whoever_signed_it)
{
  const auto text = [](const std::vector<std::string>& changes) {
    return std::string(without_report(resolved_toml(read_case_text("case.toml", std::string(test::good_case), changes))));
  };
  const std::string plain = text({});
  EXPECT_EQ(text({"report.project=P", "report.note=checked"}), plain);
  EXPECT_NE(text({"mpm.courant=0.4"}), plain);
  EXPECT_NE(plain.find("checkpoint_wall_time"), std::string::npos) << "nothing else is cut";
}

}  // namespace
}  // namespace berm::input::this_file
