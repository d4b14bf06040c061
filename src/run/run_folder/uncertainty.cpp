// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/uncertainty.hpp"

#include "io/atomic_file.hpp"
#include "os/error.hpp"
#include "run_folder/json_file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm::run_folder {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::pair<const char*, Real Band::*> numbers_of_band[] = {
    {"value", &Band::value}, {"converged", &Band::converged}, {"half_width", &Band::half_width}};
constexpr std::pair<const char*, Real Band::*> parts_of_band[] = {
    {"extrapolation", &Band::extrapolation}, {"mesh", &Band::mesh}, {"noise", &Band::noise}, {"speed", &Band::speed}};

[[noreturn]] void refuse_bands(const std::string& why)
{
  throw RunError(fmt::format("is damaged: in \"uncertainty\", {}", why));
}

const Json& member_of(const Json& json, const char* name)
{
  const auto found = json.find(name);
  if (!json.is_object() || found == json.end()) refuse_bands(fmt::format("there is no \"{}\"", name));
  return *found;
}

Real number(const Json& json)
{
  if (json.is_null()) return nan;
  if (!json.is_number()) refuse_bands("a number is none");
  return json.get<Real>();
}

std::string words(const Json& json)
{
  if (!json.is_string()) refuse_bands("a text is none");
  return json.get<std::string>();
}

const Json& list(const Json& json, const char* name)
{
  const Json& found = member_of(json, name);
  if (!found.is_array()) refuse_bands(fmt::format("\"{}\" is not a list", name));
  return found;
}

const Json& table_of(const Json& json, const char* name)
{
  const Json& found = member_of(json, name);
  if (!found.is_object()) refuse_bands(fmt::format("\"{}\" is not a table", name));
  return found;
}

std::vector<Real> numbers(const Json& json, const char* name)
{
  std::vector<Real> all;
  for (const Json& each : list(json, name)) all.push_back(number(each));
  return all;
}

Json json_of(const Grains& grains)
{
  Json json{{"size", grains.size}, {"d50_m", grains.d50}, {"quantities", Json::object()}};
  for (const auto& [name, unit, without, with] : grains.numbers)
    json["quantities"][name] = {{"without", without}, {"with", with}, {"unit", unit}};
  return json;
}

Grains grains_of(const Json& json)
{
  Grains grains{number(member_of(json, "size")), numbers(json, "d50_m"), {}};
  for (const auto& [name, entry] : table_of(json, "quantities").items()) {
    grains.numbers.push_back({name, words(member_of(entry, "unit")), number(member_of(entry, "without")), numbers(entry, "with")});
    if (grains.numbers.back().with.size() != grains.d50.size()) refuse_bands("there is not a number for each d50");
  }
  return grains;
}

CurveBand curve_of(const Json& json)
{
  CurveBand curve{words(member_of(json, "chart")), numbers(json, "x"), numbers(json, "low"), numbers(json, "high")};
  if (curve.low.size() != curve.x.size() || curve.high.size() != curve.x.size())
    refuse_bands("x, low and high of a curve are not as long as each other");
  return curve;
}

}  // namespace

const Band* Uncertainty::find(const std::string& quantity) const
{
  const auto found = std::find_if(quantities.begin(), quantities.end(), [&](const QuantityBand& q) { return q.name == quantity; });
  return found == quantities.end() ? nullptr : &found->band;
}

Json json_of(const Uncertainty& uncertainty)
{
  Json json;
  if (!uncertainty.missing.empty()) json["missing"] = uncertainty.missing;
  json["quantities"] = Json::object();
  for (const auto& [name, unit, band] : uncertainty.quantities) {
    Json& entry = json["quantities"][name];
    for (const auto& [key, part] : numbers_of_band) entry[key] = band.*part;
    entry["order"] = band.order;
    entry["unit"] = unit;
    for (const auto& [key, part] : parts_of_band) entry["parts"][key] = band.*part;
  }
  json["without"] = Json::object();
  for (const auto& [name, why] : uncertainty.without) json["without"][name] = why;
  json["left_out"] = uncertainty.left_out;
  json["runs"] = Json::array();
  for (const BandRun& run : uncertainty.runs)
    json["runs"].push_back({{"name", run.name}, {"size", run.size}, {"speed", run.speed}, {"wall_s", run.wall_s}});
  if (!uncertainty.grains.d50.empty()) json["grains"] = json_of(uncertainty.grains);
  json["curves"] = Json::array();
  for (const CurveBand& curve : uncertainty.curves)
    json["curves"].push_back({{"chart", curve.chart}, {"x", curve.x}, {"low", curve.low}, {"high", curve.high}});
  return json;
}

Uncertainty uncertainty_of(const Json& json)
{
  if (!json.is_object()) refuse_bands("it is not a table");
  Uncertainty uncertainty;
  if (json.contains("missing")) uncertainty.missing = words(json["missing"]);
  for (const auto& [name, entry] : table_of(json, "quantities").items()) {
    QuantityBand& q = uncertainty.quantities.emplace_back(QuantityBand{name, words(member_of(entry, "unit")), {}});
    for (const auto& [key, part] : numbers_of_band) q.band.*part = number(member_of(entry, key));
    q.band.order = entry.contains("order") ? number(entry["order"]) : nan;
    for (const auto& [key, part] : parts_of_band) q.band.*part = number(member_of(member_of(entry, "parts"), key));
  }
  for (const auto& [name, why] : table_of(json, "without").items()) uncertainty.without.emplace_back(name, words(why));
  for (const Json& why : list(json, "left_out")) uncertainty.left_out.push_back(words(why));
  for (const Json& run : list(json, "runs"))
    uncertainty.runs.push_back(
        {words(member_of(run, "name")), number(member_of(run, "size")), number(member_of(run, "speed")), number(member_of(run, "wall_s"))});
  if (json.contains("grains")) uncertainty.grains = grains_of(json["grains"]);
  for (const Json& curve : list(json, "curves")) uncertainty.curves.push_back(curve_of(curve));
  return uncertainty;
}

void add_to_summary(const std::filesystem::path& run_folder, const Uncertainty& uncertainty)
{
  const std::filesystem::path file = run_folder / "summary.json";
  Json root = read_json(file);
  if (!root.is_object()) throw RunError(fmt::format("{} is damaged: it is not a table", file.string()));
  root["uncertainty"] = json_of(uncertainty);
  io::write_atomically(file, root.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

}  // namespace berm::run_folder
