// SPDX-License-Identifier: BSD-3-Clause
#include "element/element_table.hpp"

#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::element {
namespace {

KeyResult stress(const char* name, Real value, const char* label, const char* meaning)
{
  return {name, value, "Pa", label, meaning, 1e-3, "kPa"};
}
KeyResult modulus(const char* name, Real value, const char* label, const char* meaning)
{
  return {name, value, "Pa", label, meaning, 1e-6, "MPa"};
}
KeyResult angle(const char* name, Real value, const char* label, const char* meaning)
{
  return {name, value, "rad", label, meaning, 180 / pi, "deg"};
}
KeyResult strain(const char* name, Real value, const char* label, const char* meaning)
{
  return {name, value, "1", label, meaning, 100, "%"};
}
KeyResult ratio(const char* name, Real value, const char* label, const char* meaning)
{
  return {name, value, "1", label, meaning, 1, ""};
}

/// What a test measures over its strain: q, in simple shear the shear stress, in the oedometer the vertical stress.
Real measured(const TestSettings& settings, const TestRow& row)
{
  if (std::holds_alternative<SimpleShear>(settings.kind)) return shear_stress(row);
  return std::holds_alternative<Oedometer>(settings.kind) ? vertical_stress(row) : deviator_stress(row);
}

/// Rise of what is measured over the strain, both in the direction of the test, between two rows.
Real slope(const TestSettings& settings, const TestRow& a, const TestRow& b)
{
  const bool shears = std::holds_alternative<SimpleShear>(settings.kind);
  const auto along = [&](const TestRow& row) { return shears ? driven_strain(settings, row) : -row.strain[1]; };
  return (measured(settings, b) - measured(settings, a)) / (along(b) - along(a));
}

/// The first row that has the largest size of what is measured, but for rounding.
const TestRow& peak_of(const TestRecord& record)
{
  const auto size = [&](const TestRow& row) { return std::abs(measured(record.settings, row)); };
  Real largest = 0;
  for (const TestRow& row : record.rows) largest = std::max(largest, size(row));
  constexpr Real rounding = 1e-6;
  return *std::find_if(record.rows.begin(), record.rows.end(), [&](const TestRow& row) { return size(row) >= (1 - rounding) * largest; });
}

/// From the start to where half of the rise to the peak is reached, interpolated.
Real secant_modulus_at_half(const TestRecord& record, const TestRow& peak)
{
  const TestSettings& settings = record.settings;
  const Real start = measured(settings, record.rows.front()), half = (measured(settings, peak) - start) / 2;
  const auto share = [&](const TestRow& row) { return (measured(settings, row) - start) / half; };
  if (half == 0) return nan;
  for (std::size_t k = 1; k < record.rows.size(); ++k) {
    const TestRow &a = record.rows[k - 1], &b = record.rows[k];
    if (share(b) < 1) continue;
    const Real part = (1 - share(a)) / (share(b) - share(a));
    return half / (-a.strain[1] - part * (b.strain[1] - a.strain[1]));
  }
  return nan;
}

/// Over the last step, compression positive: in plane strain sin psi = -(d e1 + d e3)/(d e1 - d e3); in the triaxial test, e_a axial, d e_v / (d e_v - 2 d e_a) in
/// compression and -d e_v / (d e_v - 2 d e_a) in extension. Not known of a law without strength and of soil without pressure.
Real dilation_angle(const TestRecord& record)
{
  if (!material::yields(record.material) || !(middle_stress(record.rows.back()) > 0)) return nan;
  const std::size_t n = record.rows.size();
  const TestRow &a = record.rows[n - 2], &b = record.rows[n - 1];
  const Real volume = volumetric_strain(b) - volumetric_strain(a), axial = a.strain[1] - b.strain[1], lateral = a.strain[0] - b.strain[0];
  const Real sine = std::holds_alternative<Biaxial>(record.settings.kind) ? -(axial + lateral) / std::abs(axial - lateral)
                    : axial > 0                                           ? volume / (volume - 2 * axial)
                                                                          : -volume / (volume - 2 * axial);
  return std::asin(std::clamp(sine, Real(-1), Real(1)));
}

/// The undrained strength of each cycle of a specimen that is consolidated again between them.
void add_strengths_of_cycles(std::vector<KeyResult>& all, const TestRecord& record)
{
  const int legs = legs_of_cycle(record.settings);
  std::vector<Real> largest;
  for (const TestRow& row : record.rows) {
    if (row.leg % legs == legs - 1) continue;
    largest.resize(static_cast<std::size_t>(row.leg / legs + 1));
    largest.back() = std::max(largest.back(), std::abs(deviator_stress(row)) / 2);
  }
  for (std::size_t k = 0; k < largest.size(); ++k) {
    const std::string cycle = std::to_string(k + 1);
    all.push_back({"s_u_" + cycle, largest[k], "Pa", "s_u, cycle " + cycle, "largest |q| / 2 of cycle " + cycle, 1e-3, "kPa"});
  }
}

void add_strength(std::vector<KeyResult>& all, const TestRecord& record)
{
  if (!shows_effective_stress(record)) return;
  Real largest = 0;
  for (const TestRow& row : record.rows) largest = std::max(largest, mobilised_friction_angle(row));
  all.push_back(angle("friction_angle_peak", largest, "mobilised friction, peak", "largest asin((s1 - s3)/(s1 + s3))"));
  all.push_back(angle("friction_angle_end", mobilised_friction_angle(record.rows.back()), "mobilised friction, end",
                      "asin((s1 - s3)/(s1 + s3)) at the end"));
  if (drained(record.settings.kind)) return;
  Real highest = 0;
  for (const TestRow& row : record.rows) highest = std::max(highest, *excess_pore_pressure(record, row));
  all.push_back(stress("excess_pore_pressure_max", highest, "excess pore pressure, largest", "largest excess pore pressure"));
  all.push_back(stress("excess_pore_pressure_end", *excess_pore_pressure(record, record.rows.back()), "excess pore pressure, end",
                       "excess pore pressure at the end"));
  all.push_back(stress("p_end", mean_stress(record.rows.back()), "p', end", "mean effective stress at the end"));
}

std::vector<KeyResult> axial_results(const TestRecord& record)
{
  const TestSettings& settings = record.settings;
  const TestRow &first = record.rows[0], &second = record.rows[1], &last = record.rows.back(), &peak = peak_of(record);
  std::vector<KeyResult> all = {
      stress("q_peak", deviator_stress(peak), "q, peak",
             "vertical minus lateral stress where its magnitude is largest; in extension negative"),
      strain("axial_strain_at_peak", driven_strain(settings, peak), "axial strain there", "axial strain at q_peak"),
      stress("q_end", deviator_stress(last), "q, end", "vertical minus lateral stress at the end")};
  if (!drained(settings.kind))
    all.push_back(stress("s_u", std::abs(deviator_stress(peak)) / 2, "s_u", "undrained shear strength, |q_peak| / 2"));
  if (reconsolidated(settings.kind)) add_strengths_of_cycles(all, record);
  add_strength(all, record);
  if (drained(settings.kind))
    all.push_back(angle("dilation_angle_end", dilation_angle(record), "dilation, end", "angle of dilation over the last step"));
  const Real shear =
      (deviator_stress(second) - deviator_stress(first)) / 2 / (first.strain[1] - second.strain[1] - (first.strain[0] - second.strain[0]));
  all.push_back(modulus("E_initial", slope(settings, first, second), "E, initial", "d q / d axial strain over the first step"));
  all.push_back(
      modulus("E_50", secant_modulus_at_half(record, peak), "E_50", "secant of q from the start to half of its rise to the peak"));
  all.push_back(modulus("G_initial", shear, "G, initial", "shear modulus over the first step"));
  return all;
}

std::vector<KeyResult> shear_results(const TestRecord& record)
{
  const TestSettings& settings = record.settings;
  const TestRow& peak = peak_of(record);
  std::vector<KeyResult> all = {
      stress("tau_peak", shear_stress(peak), "tau, peak", "horizontal shear stress where its magnitude is largest"),
      strain("shear_strain_at_peak", driven_strain(settings, peak), "shear strain there", "shear strain at tau_peak"),
      stress("tau_end", shear_stress(record.rows.back()), "tau, end", "horizontal shear stress at the end")};
  if (!drained(settings.kind)) all.push_back(stress("s_u", std::abs(shear_stress(peak)), "s_u", "undrained shear strength, |tau_peak|"));
  add_strength(all, record);
  all.push_back(modulus("G_initial", slope(settings, record.rows[0], record.rows[1]), "G, initial", "shear modulus over the first step"));
  return all;
}

/// The last row of the way to the first entry of the path.
std::size_t end_of_first_leg(const TestRecord& record)
{
  std::size_t n = 1;
  while (n + 1 < record.rows.size() && record.rows[n + 1].leg == 0) ++n;
  return n;
}

std::vector<KeyResult> oedometer_results(const TestRecord& record)
{
  const TestSettings& settings = record.settings;
  const TestRow& last = record.rows.back();
  const std::size_t n = end_of_first_leg(record);
  return {
      stress("vertical_stress_end", vertical_stress(last), "vertical stress, end", "vertical stress at the end"),
      strain("axial_strain_end", driven_strain(settings, last), "axial strain, end", "axial strain at the end"),
      modulus("E_oed_initial", slope(settings, record.rows[0], record.rows[1]), "E_oed, initial", "oedometer modulus over the first step"),
      modulus("E_oed", slope(settings, record.rows[n - 1], record.rows[n]), "E_oed, first loading",
              "oedometer modulus over the last step to the first entry of the path"),
      ratio("k0_end", lateral_stress(last) / vertical_stress(last), "K0, end", "ratio of horizontal to vertical stress at the end")};
}

std::vector<KeyResult> isotropic_results(const TestRecord& record)
{
  const TestRow& last = record.rows.back();
  const std::size_t n = end_of_first_leg(record);
  const auto bulk_modulus = [&](std::size_t to) {
    const TestRow &a = record.rows[to - 1], &b = record.rows[to];
    return (mean_stress(b) - mean_stress(a)) / (volumetric_strain(b) - volumetric_strain(a));
  };
  return {stress("mean_stress_end", mean_stress(last), "mean stress, end", "mean effective stress at the end"),
          strain("volumetric_strain_end", volumetric_strain(last), "volumetric strain, end", "volumetric strain at the end"),
          modulus("K_initial", bulk_modulus(1), "K, initial", "bulk modulus over the first step"),
          modulus("K", bulk_modulus(n), "K, first loading", "bulk modulus over the last step to the first entry of the path")};
}

}  // namespace

std::string KeyResult::heading() const
{
  return shown_unit.empty() ? label : fmt::format("{} ({})", label, shown_unit);
}

std::string KeyResult::shown() const
{
  return text::table_number(value * per_si);
}

std::vector<KeyResult> key_results(const TestRecord& record)
{
  if (record.rows.size() < 2) return {};
  if (std::holds_alternative<SimpleShear>(record.settings.kind)) return shear_results(record);
  if (std::holds_alternative<Isotropic>(record.settings.kind)) return isotropic_results(record);
  return std::holds_alternative<Oedometer>(record.settings.kind) ? oedometer_results(record) : axial_results(record);
}

}  // namespace berm::element
