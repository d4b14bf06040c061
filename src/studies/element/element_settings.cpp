// SPDX-License-Identifier: BSD-3-Clause
#include "element/element_settings.hpp"

#include "input/message_text.hpp"
#include "input/override.hpp"
#include "input/read_case.hpp"
#include "input/reader.hpp"
#include "input/write_case.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::element {
namespace {

using Materials = std::vector<std::pair<std::string, material::Material>>;

void describe(Describe& d, StartStress& start)
{
  d.value(
      "confining_stress", start.confining_stress,
      {.meaning = "effective stress at the start, the same in all directions, compression positive", .unit = "Pa", .range = not_negative});
  d.value("vertical_stress", start.vertical_stress,
          {.meaning = "vertical effective stress at the start, compression positive, with k0, instead of confining_stress",
           .unit = "Pa",
           .range = not_negative});
  d.value("k0", start.k0, {.meaning = "ratio of horizontal to vertical effective stress at the start", .range = not_negative});
}

template <class Kind>
void describe_drained(Describe& d, Kind& kind)
{
  d.value("drained", kind.drained,
          {.meaning = "true: drained, at constant applied effective stress; false: undrained, at constant volume", .required = true});
}

template <class Kind>
void describe_direction(Describe& d, Kind& kind)
{
  d.choice("direction", kind.direction, {"compression", "extension"}, {.meaning = "sense of the axial deformation"});
}

}  // namespace

void describe(Describe& d, Triaxial& kind)
{
  describe(d, kind.start);
  describe_drained(d, kind);
  describe_direction(d, kind);
  d.value("reconsolidated", kind.reconsolidated,
          {.meaning = "undrained test: between cycles q is taken back to 0, undrained, and p' to confining_stress, drained; the strains of "
                      "the path are then measured from there"});
}

void describe(Describe& d, Biaxial& kind)
{
  describe(d, kind.start);
  describe_drained(d, kind);
  describe_direction(d, kind);
}

void describe(Describe& d, SimpleShear& kind)
{
  describe(d, kind.start);
  describe_drained(d, kind);
}

void describe(Describe& d, Oedometer& kind)
{
  describe(d, kind.start);
  d.value("stress_path", kind.stress_path,
          {.meaning = "vertical effective stresses that are reached in turn, compression positive, instead of strain_path",
           .unit = "Pa",
           .range = not_negative});
}

void describe(Describe& d, Isotropic& kind)
{
  describe(d, kind.start);
  d.value("stress_path", kind.stress_path,
          {.meaning = "mean effective stresses that are reached in turn, compression positive", .unit = "Pa", .range = not_negative});
}

void describe(Describe& d, TestSettings& test)
{
  d.value("name", test.name, {.meaning = "name of the test: its folder, and its rows in tables", .required = true});
  d.one_of("kind", test.kind, {Triaxial::word, Biaxial::word, SimpleShear::word, Isotropic::word, Oedometer::word},
           {.meaning = "which test; biaxial is axial compression or extension in plane strain", .required = true});
  d.value("material", test.material, {.meaning = "material of the specimen", .required = true});
  d.value("depth", test.depth,
          {.meaning = "depth of the specimen below the seabed, in a material that varies with depth", .unit = "m", .range = not_negative});
  d.value("strain_path", test.strain_path,
          {.meaning = "axial strains (simple_shear: engineering shear strains) that are reached in turn, positive in "
                      "`direction`: [0.1], or with unloading and reloading [0.05, 0.04, 0.1]",
           .range = {-2, 2}});
  d.value("cycles", test.cycles, {.meaning = "number of times that the path is followed", .range = {1, 1e4}});
  d.value("steps", test.steps, {.meaning = "number of steps from one entry of the path to the next", .range = {1, 1e5}});
  d.value(
      "strain_rate", test.strain_rate,
      {.meaning =
           "rate of the axial strain (simple_shear: of the shear strain); absent: so slow that the strength does not depend on the rate",
       .unit = "1/s",
       .range = positive});
}

namespace {

const material::Material* material_named(const ElementCase& c, const std::string& name)
{
  for (const Materials* all : {&c.material, &c.borrowed})
    for (const auto& [own, material] : *all)
      if (own == name) return &material;
  return nullptr;
}

std::vector<std::string> names_of(const ElementCase& c)
{
  std::vector<std::string> names;
  for (const Materials* all : {&c.material, &c.borrowed})
    for (const auto& entry : *all) names.push_back(entry.first);
  return names;
}

/// A name that is one of a folder, too.
bool is_folder_name(const std::string& name)
{
  const auto fits = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-'; };
  return !name.empty() && std::all_of(name.begin(), name.end(), fits);
}

void check_start(Describe& d, const std::string& path, const StartStress& start, bool isotropic)
{
  d.check(start.confining_stress.has_value() || start.vertical_stress.has_value(), path,
          "needs the stress at the start: confining_stress, or vertical_stress and k0");
  d.check(!isotropic || start.confining_stress, path, "begins at the same stress in all directions: confining_stress");
  d.check(!start.confining_stress || !start.vertical_stress, path + ".vertical_stress", "cannot be combined with confining_stress");
  d.check(!start.confining_stress || !start.k0, path + ".k0",
          "cannot be combined with confining_stress, which is the same in all directions");
  d.check(!start.vertical_stress || start.k0, path + ".vertical_stress", "needs k0, which gives the horizontal stress");
}

/// A soil cannot begin beyond its strength.
void check_strength(Describe& d, const std::string& path, const StartStress& start, const material::Material& material)
{
  std::vector<Real> state(static_cast<std::size_t>(material::state_size(material)), 0.);
  material::initial_state(material, {{-start.horizontal(), -start.vertical(), -start.horizontal()}}, state.data());
  const Real half = std::abs(start.vertical() - start.horizontal()) / 2, middle = (start.vertical() + start.horizontal()) / 2;
  const std::optional<Real> strength = material::shear_strength(material, -middle, state.data());
  constexpr Real rounding = 1e-9;
  d.check(
      !strength || half <= *strength * (1 + rounding), path + ".k0",
      fmt::format("the stress at the start is beyond the strength of the soil: (s1 - s3)/2 would be {:.4g} Pa, and is at most {:.4g} Pa",
                  half, strength.value_or(0)));
}

void check_path(Describe& d, const std::string& path, const TestSettings& test)
{
  const bool by_stress = !stress_path_of(test.kind).empty();
  d.check(by_stress || !std::holds_alternative<Isotropic>(test.kind), path, "needs stress_path = [...], the mean stresses to reach");
  d.check(by_stress || !test.strain_path.empty(), path,
          std::holds_alternative<Oedometer>(test.kind) ? "needs strain_path = [...] or stress_path = [...]"
                                                       : "needs strain_path = [...], the strains to reach");
  d.check(!by_stress || test.strain_path.empty(), path + ".strain_path", "cannot be combined with stress_path");
  const std::vector<Real>& points = by_stress ? stress_path_of(test.kind) : test.strain_path;
  const std::string key = path + (by_stress ? ".stress_path" : ".strain_path");
  Real before = by_stress ? start_of(test.kind).vertical() : 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    d.check(points[k] != before, fmt::format("{}[{}]", key, k), "is the present state of the specimen");
    before = points[k];
  }
  d.check(test.cycles == 1 || points.size() > 1 || reconsolidated(test.kind), path + ".cycles",
          "a cycle needs at least two entries of the path, loading and unloading");
}

void check_test(Describe& d, const std::string& path, const TestSettings& test, const ElementCase& c)
{
  d.check(is_folder_name(test.name), path + ".name", "allowed are letters, digits, _ and -");
  const material::Material* material = material_named(c, test.material);
  d.check(material != nullptr, path + ".material", "there is no such material", names_of(c));
  check_start(d, path, start_of(test.kind), std::holds_alternative<Isotropic>(test.kind));
  check_path(d, path, test);
  if (reconsolidated(test.kind)) {
    d.check(!drained(test.kind), path + ".reconsolidated", "is of an undrained test: drained = false");
    d.check(start_of(test.kind).confining_stress.has_value(), path + ".reconsolidated",
            "is to an isotropic stress: needs confining_stress");
    d.check(test.cycles > 1, path + ".reconsolidated", "is between cycles: needs cycles = 2 or more");
    d.check(material == nullptr || !knows_total_stress_alone(*material), path + ".reconsolidated",
            fmt::format("{} has an undrained strength, which drainage does not change", test.material));
  }
  if (material == nullptr) return;  // of a visitor that does not throw
  check_strength(d, path, start_of(test.kind), material::at_depth(*material, test.depth, start_of(test.kind).vertical()));
  d.check(!drained(test.kind) || is_compression(test.kind) || !knows_total_stress_alone(*material), path + ".drained",
          fmt::format("{} has an undrained strength, and cannot be drained: drained = false", test.material));
}

/// Refuses a case of berm run, which has no tests.
void refuse_case_of_run(const input::Document& document)
{
  if (member(document.root, "test") != nullptr) return;
  for (const char* key : {"stage", "mesh", "body", "rigid"})
    if (const input::Node* node = member(document.root, key))
      refuse(
          document, *node, key,
          fmt::format("this is a case of berm run, without [[test]]; a file with materials_from = {} and [[test]] tables tests its soils",
                      input::in_quotes(std::filesystem::path(document.file).filename().string())));
}

void describe_materials(Describe& d, Materials& materials)
{
  d.named_tables("material", materials, {.meaning = "materials"});
}

}  // namespace

void describe(Describe& d, MaterialsOfCase& c)
{
  describe_materials(d, c.material);
  for (const auto& [name, material] : c.material) check(d, "material." + name, material);
}

void describe(Describe& d, ElementCase& c)
{
  d.value("title", c.title, {.meaning = "title of the page"});
  d.value("materials_from", c.materials_from,
          {.meaning = "a case of berm run, relative to this file's folder, whose materials are tested"});
  describe_materials(d, c.material);
  d.array("test", c.test, {.meaning = "laboratory tests", .required = true});
  d.check(!names_of(c).empty(), "material", "at least one table [material.NAME] is needed, or materials_from = \"case.toml\"");
  for (const auto& [name, material] : c.material) {
    check(d, "material." + name, material);
    const auto same = [&, &own = name](const auto& other) { return other.first == own; };
    d.check(std::none_of(c.borrowed.begin(), c.borrowed.end(), same), "material." + name,
            "is the name of a material of materials_from, too");
  }
  for (std::size_t k = 0; k < c.test.size(); ++k) {
    const std::string path = fmt::format("test[{}]", k);
    for (std::size_t before = 0; before < k; ++before)
      d.check(c.test[before].name != c.test[k].name, path + ".name", "is the name of a test before it");
    check_test(d, path, c.test[k], c);
  }
}

const char* kind_word(const TestKind& kind)
{
  return std::visit([](const auto& k) { return k.word; }, kind);
}

const StartStress& start_of(const TestKind& kind)
{
  return std::visit([](const auto& k) -> const StartStress& { return k.start; }, kind);
}

const std::vector<Real>& stress_path_of(const TestKind& kind)
{
  static const std::vector<Real> by_strains;
  if (const auto* oedometer = std::get_if<Oedometer>(&kind)) return oedometer->stress_path;
  if (const auto* isotropic = std::get_if<Isotropic>(&kind)) return isotropic->stress_path;
  return by_strains;
}

Real sense(const TestKind& kind)
{
  const auto extends = [](const auto& k) {
    if constexpr (requires { k.direction; }) return k.direction == Direction::extension;
    return false;
  };
  return std::visit(extends, kind) ? -1 : 1;
}

bool is_compression(const TestKind& kind)
{
  return std::holds_alternative<Oedometer>(kind) || std::holds_alternative<Isotropic>(kind);
}

bool drained(const TestKind& kind)
{
  if (const auto* triaxial = std::get_if<Triaxial>(&kind)) return triaxial->drained;
  if (const auto* biaxial = std::get_if<Biaxial>(&kind)) return biaxial->drained;
  if (const auto* shear = std::get_if<SimpleShear>(&kind)) return shear->drained;
  return true;
}

bool reconsolidated(const TestKind& kind)
{
  const auto* triaxial = std::get_if<Triaxial>(&kind);
  return triaxial != nullptr && triaxial->reconsolidated;
}

bool knows_total_stress_alone(const material::Material& material)
{
  const std::optional<material::Strength> strength = material::strength_at_rest(material);
  return strength && strength->friction_angle == 0;
}

material::Material material_of(const ElementCase& c, const TestSettings& test)
{
  return material::drained(material::at_depth(*material_named(c, test.material), test.depth, start_of(test.kind).vertical()));
}

ElementCase read_element_case(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  input::Document document = input::parse_file(file), other;
  ElementCase c;
  const auto apply = [&](bool to_other) {
    for (const std::string& override : overrides) {
      const input::Node* own = member(document.root, "material");
      const std::string key = override.substr(0, override.find('='));
      const std::string name = key.starts_with("material.") ? key.substr(9, key.find('.', 9) - 9) : "";
      const bool elsewhere = !name.empty() && !c.materials_from.empty() && (own == nullptr || member(*own, name) == nullptr);
      if (elsewhere == to_other) apply_override(to_other ? other : document, override);
    }
  };
  if (const input::Node* from = member(document.root, "materials_from"); from != nullptr) c.materials_from = from->text;
  apply(false);
  refuse_case_of_run(document);
  if (const input::Node* from = member(document.root, "materials_from"); from != nullptr && !from->text.empty()) {
    c.materials_from = from->text;
    try {
      other = input::parse_file(file.parent_path() / from->text);
    } catch (const InputError& error) {
      input::refuse(document, *from, "materials_from", error.what());
    }
    apply(true);
    std::erase_if(other.root.items, [](const input::Node& item) { return item.key != "material"; });
    MaterialsOfCase materials;
    read(other, materials);
    c.borrowed = std::move(materials.material);
    input::find_libraries(c.borrowed, (file.parent_path() / from->text).parent_path());
  }
  read(document, c);
  input::find_libraries(c.material, file.parent_path());
  return c;
}

input::Listed element_catalogue()
{
  return input::catalogue_of<ElementCase>();
}

std::string resolved_toml(const ElementCase& c)
{
  ElementCase whole = c;
  whole.materials_from.clear();
  whole.material.insert(whole.material.end(), whole.borrowed.begin(), whole.borrowed.end());
  whole.borrowed.clear();
  input::SettingVisitor visitor(true);
  describe(visitor, whole);
  return "# All tests: every default filled in, numbers in SI units, angles in radians.\n" + toml_of(visitor.root());
}

}  // namespace berm::element
