// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/material/shansep_test.cpp
#include "material/shansep.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::material {

void describe(Describe& d, Shansep& shansep)
{
  d.value("ratio", shansep.ratio,
          {.meaning = "S: undrained strength divided by vertical effective stress of the normally consolidated clay (0.2 to 0.35 for most)",
           .range = positive,
           .required = true});
  d.value("exponent", shansep.exponent, {.meaning = "m, of the overconsolidation ratio (0.7 to 1)", .range = {0, 2}});
  d.value("ocr", shansep.ocr,
          {.meaning = "overconsolidation ratio, the same at all depths; left out with pop and profile.ocr: 1", .range = {0, 1e4, true}});
  d.value("pop", shansep.pop,
          {.meaning = "pre-overburden pressure, instead of ocr: OCR = (sigma'_v0 + pop) / sigma'_v0", .unit = "Pa", .range = not_negative});
  d.value("surcharge", shansep.surcharge,
          {.meaning = "vertical effective stress on the seabed under which the clay has consolidated, added to the overburden in "
                      "sigma'_v0; it does not load the soil: a traction does",
           .unit = "Pa",
           .range = not_negative});
  d.value("min_strength", shansep.min_strength,
          {.meaning = "the strength is never less: clay without overburden would have none", .unit = "Pa", .range = not_negative});
}

Real strength_by(const Shansep& shansep, Real weight_above, const std::optional<Real>& ocr)
{
  const Real stress = std::max(Real(0), weight_above) + shansep.surcharge, m = shansep.exponent;
  const Real strength = shansep.pop ? shansep.ratio * std::pow(stress, 1 - m) * std::pow(stress + *shansep.pop, m)
                                    : shansep.ratio * stress * std::pow(ocr ? *ocr : shansep.ocr.value_or(1), m);
  return std::max(strength, shansep.min_strength);
}

std::string formula_words(const Shansep& shansep)
{
  std::string words = fmt::format("{:.3g} σ'v0 OCR^{:.3g}", shansep.ratio, shansep.exponent);
  if (shansep.pop) words += fmt::format(", POP = {:.4g} kPa", *shansep.pop / 1e3);
  if (shansep.ocr) words += fmt::format(", OCR = {:.3g}", *shansep.ocr);
  if (shansep.surcharge > 0) words += fmt::format(", {:.4g} kPa on the surface", shansep.surcharge / 1e3);
  if (shansep.min_strength > 0) words += fmt::format(", {:.4g} kPa at least", shansep.min_strength / 1e3);
  return words;
}

void check_shansep(Describe& d, const std::string& path, const Shansep& shansep, bool ocr_in_profile)
{
  d.check(!shansep.pop || !shansep.ocr, path + ".pop", "is another way to give ocr: keep one of them");
  d.check(!ocr_in_profile || !shansep.ocr, path + ".ocr", "is given by profile.ocr: leave it out");
  d.check(!ocr_in_profile || !shansep.pop, path + ".pop", "is another way to give profile.ocr: keep one of them");
  d.check(!shansep.pop || shansep.exponent <= 1 || shansep.surcharge > 0, path + ".exponent",
          "above 1 with pop makes the strength increase without limit towards the surface: take at most 1, or give ocr instead of pop");
}

}  // namespace berm::material
