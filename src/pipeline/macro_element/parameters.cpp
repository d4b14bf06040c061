// SPDX-License-Identifier: BSD-3-Clause
#include "macro_element/parameters.hpp"

#include "os/error.hpp"
#include "os/read_file.hpp"

#include <cfloat>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <vector>

namespace berm::macro_element {
namespace {

using Json = nlohmann::ordered_json;

/// The points of V0, which are no members of one number.
struct Points {
  const char *name, *unit;
  double (Parameters::*member)[BERM_MACRO_ELEMENT_MAX_POINTS];
};
constexpr Points backbone[] = {{"backbone_w", "m", &Parameters::backbone_w}, {"backbone_V", "N/m", &Parameters::backbone_V}};

std::string range_of(const berm_macro_element_member& m)
{
  const std::string least = m.least == DBL_MIN ? "more than 0" : m.least > -DBL_MAX ? fmt::format("{:g} or more", m.least) : "";
  const std::string most = m.most == DBL_MAX ? "" : m.most < 1 && m.most > 1 - 1e-9 ? "less than 1" : fmt::format("{:g} or less", m.most);
  return least + (least.empty() || most.empty() ? "" : ", ") + most;
}

/// Reads one file; messages name it and the key.
class Reader {
public:
  Reader(const std::string& text, const std::string& name) : name_(name)
  {
    try {
      all_ = Json::parse(text);
    } catch (const Json::exception& error) {
      const std::string_view what = error.what();  // "[...] parse error at line 1, column 2: " and what stands there, whatever that is
      const std::size_t place = what.find("line "), end = what.find(':');
      throw InputError(fmt::format("{}: no JSON{}", name_, place < end ? fmt::format(" at {}", what.substr(place, end - place)) : ""));
    }
  }

  Parameters parameters() const
  {
    Parameters p{};
    p.version = version();
    for (const berm_macro_element_member& m : berm_macro_element_members) value_of(p, m) = number(value(m.name, m.unit), m.name);
    for (const Points& points : backbone) {
      const Json& list = value(points.name, points.unit);
      if (!list.is_array() || list.size() > BERM_MACRO_ELEMENT_MAX_POINTS)
        refuse(points.name, fmt::format("a list of {} numbers at most", BERM_MACRO_ELEMENT_MAX_POINTS));
      if (points.member == &Parameters::backbone_V && list.size() != static_cast<std::size_t>(p.backbone_points))
        refuse(points.name, "as many numbers as backbone_w has");
      p.backbone_points = static_cast<int>(list.size());
      for (std::size_t k = 0; k < list.size(); ++k) (p.*points.member)[k] = number(list[k], points.name);
    }
    check(p);
    return p;
  }

private:
  [[noreturn]] void refuse(const std::string& parameter, const std::string& allowed) const
  {
    throw InputError(fmt::format("{}: parameters.{}.value: {}", name_, parameter, allowed));
  }

  const Json& member(const Json& json, const char* key, const std::string& path) const
  {
    const auto found = json.is_object() ? json.find(key) : json.end();
    if (found == json.end()) throw InputError(fmt::format("{}: there is no {}", name_, path));
    return *found;
  }

  int version() const
  {
    const Json& found = member(all_, "version", "version");
    if (found != BERM_MACRO_ELEMENT_VERSION)
      throw InputError(fmt::format("{}: version: it is {}, and this berm takes {}: fit to the runs again by berm macro-element", name_,
                                   found.is_number() ? found.dump() : "no number", BERM_MACRO_ELEMENT_VERSION));
    return BERM_MACRO_ELEMENT_VERSION;
  }

  const Json& value(const char* name, const char* unit) const
  {
    const std::string path = fmt::format("parameters.{}", name);
    const Json& entry = member(member(all_, "parameters", "parameters"), name, path);
    if (member(entry, "unit", path + ".unit") != unit) throw InputError(fmt::format("{}: {}.unit: \"{}\"", name_, path, unit));
    return member(entry, "value", path + ".value");
  }

  double number(const Json& json, const char* name) const
  {
    if (!json.is_number()) refuse(name, "a number");
    return json.get<double>();
  }

  void check(const Parameters& p) const
  {
    const char* wrong = nullptr;
    if (berm_macro_element_check(&p, &wrong) == BERM_MACRO_ELEMENT_OK) return;
    const std::string name = wrong;
    if (name == "backbone_w" || name == "backbone_V") refuse(name, "numbers that ascend, the first more than 0");
    for (const berm_macro_element_member& m : berm_macro_element_members) {
      if (name != m.name) continue;
      const double value = value_of(p, m);
      if (!(value >= m.least && value <= m.most)) refuse(name, fmt::format("{:g} is not {}", value, range_of(m)));
      if (value == 0) refuse(name, "more than 0 where backbone_w has no numbers");
      if (name == "uplift_ratio" && value > p.surface_beta) refuse(name, "surface_beta or less");
      refuse(name, fmt::format("{:g} is beyond any pipe and soil", value));
    }
  }

  std::string name_;
  Json all_;
};

}  // namespace

double& value_of(Parameters& parameters, const berm_macro_element_member& member)
{
  return *reinterpret_cast<double*>(reinterpret_cast<char*>(&parameters) + member.offset);
}

double value_of(const Parameters& parameters, const berm_macro_element_member& member)
{
  return *reinterpret_cast<const double*>(reinterpret_cast<const char*>(&parameters) + member.offset);
}

Json json_of(const Parameters& p)
{
  Json all;
  all["version"] = p.version;
  for (const berm_macro_element_member& m : berm_macro_element_members)
    all["parameters"][m.name] = {{"value", value_of(p, m)}, {"unit", m.unit}};
  for (const Points& points : backbone) {
    const double* const values = p.*points.member;
    all["parameters"][points.name] = {{"value", std::vector<double>(values, values + p.backbone_points)}, {"unit", points.unit}};
  }
  return all;
}

Parameters parameters_in(const std::string& text, const std::string& name)
{
  return Reader(text, name).parameters();
}

Parameters read_parameters(const std::filesystem::path& named)
{
  constexpr std::uintmax_t max_bytes = 1'000'000;
  std::error_code ignored;
  const std::filesystem::path file = std::filesystem::is_directory(named, ignored) ? named / "macro_element.json" : named;
  const FileBytes found = read_file(file, max_bytes);
  if (!found.fault.empty()) throw InputError(fmt::format("{}: {}", file.string(), found.fault));
  return parameters_in(found.bytes, file.string());
}

}  // namespace berm::macro_element
