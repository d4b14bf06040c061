// SPDX-License-Identifier: BSD-3-Clause
#include "sea/sea_settings.hpp"

#include "input/override.hpp"
#include "input/places.hpp"
#include "input/reader.hpp"
#include "input/table_file.hpp"
#include "os/error.hpp"

#include <fmt/format.h>

namespace berm::sea {
namespace {

void describe_wind_sea(Describe& d, WindSea& sea)
{
  d.value("significant_height", sea.height,
          {.meaning = "significant wave height H_s", .unit = "m", .range = {0, 30, true, false}, .required = true});
  d.value("peak_period", sea.period, {.meaning = "period T_p of the largest density", .unit = "s", .range = {1, 30}, .required = true});
}

}  // namespace

void describe(Describe& d, Jonswap& sea)
{
  describe_wind_sea(d, sea);
  d.value("peakedness", sea.peakedness, {.meaning = "gamma; absent: by T_p/sqrt(H_s) as in DNV-RP-F109, from 1 to 5", .range = {1, 7}});
}

void describe(Describe& d, PiersonMoskowitz& sea)
{
  describe_wind_sea(d, sea);
}

void describe(Describe& d, SpectrumTable& sea)
{
  d.value("table", sea.table,
          {.meaning = "CSV file of columns frequency_Hz and density (m2/Hz), of the sea's elevation, relative to this file's folder",
           .required = true});
}

void describe(Describe& d, SeaState& sea)
{
  d.one_of("spectrum", sea.spectrum, {"jonswap", "pierson_moskowitz", "table"}, {.meaning = "form of the wave spectrum", .required = true});
  d.value("depth", sea.depth, {.meaning = "water depth", .unit = "m", .range = positive, .required = true});
  d.value("direction", sea.direction,
          {.meaning = "angle between the main direction of the waves and the axis of the pipe; 90 deg is across",
           .unit = "rad",
           .range = {0, pi / 2}});
  d.value("spreading", sea.spreading,
          {.meaning = "exponent s of the directions' spreading, cos^s around the main one; absent: long-crested waves",
           .range = {0, 100, true, false}});
  d.value("duration", sea.duration, {.meaning = "duration of the sea state", .unit = "s", .range = {60, 864000}});
  d.value("water_density", sea.water_density, {.meaning = "density of the water", .unit = "kg/m^3", .range = {900, 1300}});
}

void describe(Describe& d, Current& current)
{
  d.value("velocity", current.velocity,
          {.meaning = "velocity at the reference height", .unit = "m/s", .range = not_negative, .required = true});
  d.value("height", current.height, {.meaning = "reference height above the seabed", .unit = "m", .range = positive, .required = true});
  d.value("direction", current.direction,
          {.meaning = "angle between the current and the axis of the pipe; 90 deg is across", .unit = "rad", .range = {0, pi / 2}});
  d.value("roughness", current.roughness,
          {.meaning = "bottom roughness z_0 of the logarithmic profile: 5e-6 m silt and clay, 1e-5 fine, 4e-5 medium, 1e-4 coarse sand",
           .unit = "m",
           .range = {0, 0.1, true, false},
           .required = true});
}

void describe(Describe& d, Pipe& pipe)
{
  d.value("diameter", pipe.diameter,
          {.meaning = "outer diameter, with coating", .unit = "m", .range = {0, 10, true, false}, .required = true});
  d.value("submerged_weight", pipe.weight, {.meaning = "submerged weight", .unit = "N/m", .range = positive, .required = true});
  d.value("embedment", pipe.embedment,
          {.meaning = "embedment of the invert; absent: on sand that under the weight [Verley and Sotberg 1994], else 0",
           .unit = "m",
           .range = not_negative});
  d.value("drag", pipe.drag,
          {.meaning = "drag coefficient C_D of a pipe on the seabed, often 0.7 to 1.2", .range = {0, 10}, .required = true});
  d.value("inertia", pipe.inertia,
          {.meaning = "inertia coefficient C_M (1 + added mass) of a pipe on the seabed; 3.29 in potential flow",
           .range = {0, 10},
           .required = true});
  d.value("lift", pipe.lift,
          {.meaning = "lift coefficient C_L of a pipe on the seabed, often 0.9 to 1.3", .range = {0, 10}, .required = true});
  d.value("mass", pipe.mass,
          {.meaning = "mass with contents, displaced water and added mass; absent: w_s/g + C_M rho pi D^2/4",
           .unit = "kg/m",
           .range = positive});
}

void describe(Describe& d, Bed& bed)
{
  d.value("friction", bed.friction,
          {.meaning = "friction coefficient between pipe and seabed: DNV-RP-F109 has 0.6 on sand, 0.2 on clay",
           .range = {0, 2},
           .required = true});
  d.value("submerged_unit_weight", bed.unit_weight,
          {.meaning = "submerged unit weight of sand, for the passive resistance; absent: clay, without it",
           .unit = "N/m^3",
           .range = positive});
  d.value("grain_size", bed.grain_size,
          {.meaning = "median grain size d_50 of sand: whether the waves move it", .unit = "m", .range = {1e-5, 0.1}});
  d.value("permeable", bed.permeable,
          {.meaning = "whether water flows through the seabed below the pipe: sand, where lift is 0.7 times as large"});
  d.value("trench_depth", bed.trench_depth, {.meaning = "depth of the trench in which the pipe lies", .unit = "m", .range = not_negative});
  d.value("trench_angle", bed.trench_angle, {.meaning = "slope of the walls of the trench", .unit = "rad", .range = {0, 45 * degree}});
  d.value("safety_factor", bed.safety_factor, {.meaning = "safety factor on the loads, gamma_SC", .range = {0.5, 5}});
}

void describe(Describe& d, Soil& soil)
{
  d.value(
      "macro_element", soil.macro_element,
      {.meaning =
           "folder of berm macro-element, or its macro_element.json, of this pipe in this soil, relative to this file's folder: it gives "
           "the displacement of each realisation",
       .required = true});
  d.value("laying_force", soil.laying_force,
          {.meaning = "vertical force with which the pipe was laid; absent: its submerged weight", .unit = "N/m", .range = positive});
  d.value("runs", soil.runs,
          {.meaning = "run folders of stages through waves_SEED.csv of this sea state, whose displacements are compared, relative to this "
                      "file's folder"});
}

void describe(Describe& d, Record& record)
{
  d.value("seeds", record.seeds, {.meaning = "number of realisations of the sea state", .range = {1, 100}});
  d.value("waves", record.waves,
          {.meaning = "number of the largest waves that a load table holds, in the order in which they occur", .range = {1, 1000}});
  d.value("step", record.step, {.meaning = "time between rows; absent: a fortieth of T_p", .unit = "s", .range = positive});
}

void describe(Describe& d, SeaCase& c)
{
  d.value("title", c.title, {.meaning = "title of the page"});
  d.table("sea", c.sea, {.meaning = "sea state"});
  d.optional_table("current", c.current, {.meaning = "steady current"});
  d.table("pipe", c.pipe, {.meaning = "pipe or cable on the seabed"});
  d.table("bed", c.bed, {.meaning = "seabed and safety factor"});
  d.optional_table("soil", c.soil, {.meaning = "displacement of the pipe in the sea state"});
  d.table("record", c.record, {.meaning = "loads over time"});
  constexpr Real flat = 5 * degree * (1 - 1e-9);
  d.check(c.bed.trench_depth == 0 || c.bed.trench_angle >= flat, "bed.trench_angle", "of a trench is from 5 to 45 deg");
  d.check(c.pipe.embedment.value_or(0) <= c.pipe.diameter, "pipe.embedment", "is more than the diameter: waves do not reach the pipe");
  d.check(!c.soil || c.soil->laying_force.value_or(infinity) >= c.pipe.weight, "soil.laying_force", "is less than the submerged weight");
  if (const auto* wind = std::get_if<Jonswap>(&c.sea.spectrum))
    d.check(c.record.step.value_or(0) <= wind->period / 8, "record.step", "is more than an eighth of T_p: it does not resolve the waves");
}

namespace {

formulas::WaveSpectrum read_spectrum(const std::filesystem::path& file)
{
  const input::TableForm form{.of = "spectrum",
                              .columns = {{"density", ""}},
                              .header = "frequency_Hz,density",
                              .first = {"frequency", "Hz"},
                              .over = "the frequency"};
  std::vector<Real> frequency, density;
  const auto take = [&](Real f, const std::vector<std::size_t>&, const std::vector<Real>& values) -> std::string {
    if (!(f > 0)) return fmt::format("frequency = {:.6g} Hz is not more than 0", f);
    if (!frequency.empty() && !(2 * pi * f > frequency.back())) return "frequencies must ascend";
    if (!(values.front() >= 0)) return fmt::format("density = {:.6g} is negative", values.front());
    frequency.push_back(2 * pi * f), density.push_back(values.front() / (2 * pi));
    return "";
  };
  input::read_table("sea.table", file, form, take);
  if (std::all_of(density.begin(), density.end(), [](Real value) { return value == 0; })) throw KeyError("sea.table: every density is 0");
  return formulas::WaveSpectrum::table(std::move(frequency), std::move(density));
}

macro_element::Parameters read_macro_element(const std::filesystem::path& named, Real diameter)
{
  constexpr Real same = 0.01;
  macro_element::Parameters parameters;
  try {
    parameters = macro_element::read_parameters(named);
  } catch (const InputError& error) {
    throw KeyError(fmt::format("soil.macro_element: {}", error.what()));
  }
  if (std::abs(parameters.diameter / diameter - 1) > same)
    throw KeyError(
        fmt::format("soil.macro_element: is of a pipe of {:.4g} m, and pipe.diameter is {:.4g} m", parameters.diameter, diameter));
  return parameters;
}

}  // namespace

settings::WaterSettings water_of(const SeaCase& c)
{
  return {.density = c.sea.water_density,
          .drag = c.pipe.drag,
          .inertia = c.pipe.inertia,
          .lift = c.pipe.lift,
          .weight = c.pipe.weight,
          .permeable = c.bed.permeable,
          .trench_depth = c.bed.trench_depth,
          .trench_angle = c.bed.trench_angle};
}

SeaCase read_sea_case(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  input::Document document = input::parse_file(file);
  for (const std::string& override : overrides) input::apply_override(document, override);
  SeaCase c;
  read(document, c);
  c.folder = file.parent_path();
  const input::Places places(std::move(document));
  try {
    if (const auto* table = std::get_if<SpectrumTable>(&c.sea.spectrum)) {
      c.spectrum = read_spectrum(file.parent_path() / table->table);
    } else {
      const auto* jonswap = std::get_if<Jonswap>(&c.sea.spectrum);
      const WindSea& wind = jonswap != nullptr ? static_cast<const WindSea&>(*jonswap) : std::get<PiersonMoskowitz>(c.sea.spectrum);
      if (jonswap != nullptr) c.peakedness = jonswap->peakedness.value_or(formulas::wave_peakedness(wind.height, wind.period).value);
      constexpr Real breaking = 0.78, steepest = 0.142;  // of depth and of length
      if (wind.height > breaking * c.sea.depth)
        throw KeyError(
            fmt::format("sea.significant_height: {:.3g} m is more than {} times the depth: such waves break", wind.height, breaking));
      const Real length = 2 * pi / formulas::wave_number(2 * pi / wind.period, c.sea.depth);
      if (wind.height > steepest * length)
        throw KeyError(
            fmt::format("sea.peak_period: waves of {:.3g} s are {:.3g} m long, too steep for H_s = {:.3g} m: is the period right?",
                        wind.period, length, wind.height));
      c.spectrum = formulas::WaveSpectrum::jonswap(wind.height, wind.period, c.peakedness);
    }
    constexpr Real still = 1e-3;  // m/s
    if (const Real velocity = formulas::waves_at_seabed(*c.spectrum, c.sea.depth).velocity; !(velocity > still))
      throw KeyError(
          fmt::format("sea.depth: the waves do not reach the seabed: U_s is {:.2g} m/s in {:.4g} m of water", velocity, c.sea.depth));
    if (c.soil) c.macro_element = read_macro_element(c.folder / c.soil->macro_element, c.pipe.diameter);
  } catch (const KeyError& error) {
    throw input::LocatedError(places.located(error));
  }
  return c;
}

input::Listed sea_catalogue()
{
  return input::catalogue_of<SeaCase>();
}

}  // namespace berm::sea
