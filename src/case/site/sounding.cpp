// SPDX-License-Identifier: BSD-3-Clause
#include "site/sounding.hpp"

#include "input/message_text.hpp"
#include "input/text_table.hpp"
#include "os/error.hpp"
#include "os/text_file.hpp"
#include "site/table.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::site {

Sounding read_sounding(const std::filesystem::path& file, const std::string& location)
{
  std::string kind = file.extension().string();
  std::transform(kind.begin(), kind.end(), kind.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (kind != ".ags" && kind != ".gef" && kind != ".csv")
    throw InputError(fmt::format("{}: a sounding is a file of AGS 4 (.ags), GEF (.gef) or a table (.csv)", file.string()));
  if (kind != ".ags" && !location.empty()) throw InputError(fmt::format("{}: only a file of AGS names its locations", file.string()));
  const auto [text, fault] = read_text(file, 100'000'000);
  if (!fault.empty()) throw InputError(fmt::format("{}: {}", file.string(), fault));
  return sounding_of(kind == ".ags"   ? read_ags(file.string(), text, location)
                     : kind == ".gef" ? read_gef(file.string(), text)
                                      : read_csv(file.string(), text));
}

std::string rows_of(const Sounding& sounding)
{
  std::string text = fmt::format("{}: {} of {} rows", sounding.file, sounding.depth.size(), sounding.rows);
  if (!sounding.depth.empty()) text += fmt::format(", {:.2f} to {:.2f} m", sounding.depth.front(), sounding.depth.back());
  for (std::size_t i = 0; i < sounding.left_out.size(); ++i)
    text += fmt::format("{}{} {}", i == 0 ? "; left out: " : ", ", sounding.left_out[i].rows, sounding.left_out[i].why);
  return text;
}

Real friction_ratio(const Sounding& sounding, Real submerged_unit_weight)
{
  Real sum = 0;
  Index count = 0;
  for (std::size_t i = 0; i < sounding.f_s.size(); ++i) {
    const Real net = sounding.q_t[i] - (submerged_unit_weight + gamma_w) * sounding.depth[i];
    if (net <= 0 || std::isnan(sounding.f_s[i])) continue;
    sum += sounding.f_s[i] / net;
    ++count;
  }
  return count > 0 ? sum / static_cast<Real>(count) : 0;
}

Real number_of(const std::string& text, const std::string& file, int line, const std::string& of)
{
  if (const std::optional<Real> number = input::number_in(text)) return *number;
  const std::string fault = input::fault_of_commas(text);
  throw InputError(fmt::format("{}{}: {} {}", at(file, line), of, input::in_quotes(text), fault.empty() ? "is not a number" : fault));
}

std::optional<Real> area_ratio_of(const std::string& text, const std::string& file, int line, const std::string& of)
{
  const Real ratio = text.empty() ? 0 : number_of(text, file, line, of);
  if (ratio > 1)
    throw InputError(fmt::format(
        "{}{}: the area ratio of a cone is above 0 and at most 1, such as 0.8, and this is {:g}; leave it out where it is not known",
        at(file, line), of, ratio));
  return ratio > 0 ? std::optional(ratio) : std::nullopt;
}

std::string at(const std::string& file, int line)
{
  return fmt::format("{}:{}: ", file, line);
}

}  // namespace berm::site
