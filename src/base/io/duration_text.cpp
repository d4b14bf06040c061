// SPDX-License-Identifier: BSD-3-Clause
#include "io/duration_text.hpp"

#include <cmath>
#include <fmt/format.h>

namespace berm::io {

std::string duration_text(Real s)
{
  if (!std::isfinite(s) || s < 0) return "?";
  if (s < 0.0995) return fmt::format("{:.0f} ms", s * 1000);
  if (s < 9.95) return fmt::format("{:.1f} s", s);
  if (s < 59.5) return fmt::format("{:.0f} s", s);
  if (s < 3599.5) return fmt::format("{} min {:02} s", std::lround(s) / 60, std::lround(s) % 60);
  constexpr Real year = 365.25 * 24 * 3600;
  if (s > year) return fmt::format("{:.3g} years", s / year);
  const long minutes = std::lround(s / 60);
  return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
}

}  // namespace berm::io
