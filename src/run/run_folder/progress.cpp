// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/progress.hpp"

#include "io/duration_text.hpp"
#include "io/log.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::run_folder {
namespace {

constexpr std::chrono::milliseconds between_lines_in_place{200};
constexpr std::chrono::seconds between_plain_lines{30};

std::string words_of_speed(Real per_s)
{
  return per_s >= 1e6   ? fmt::format("{:.1f} M ", per_s / 1e6)
         : per_s >= 1e3 ? fmt::format("{:.1f} k ", per_s / 1e3)
                        : fmt::format("{:.0f} ", per_s);
}

Real seconds_of(std::chrono::steady_clock::duration duration)
{
  return std::chrono::duration<Real>(duration).count();
}

}  // namespace

std::string progress_line(const ProgressReport& r, Real elapsed)
{
  std::string line = r.stage;
  if (!std::isnan(r.done)) line += fmt::format("  {:.0f} %", 100 * std::clamp<Real>(r.done, 0, 1));
  if (r.done > 0 && r.done < 1) line += fmt::format("  {} left", io::duration_text(elapsed * (1 - r.done) / r.done));
  if (r.drag && !std::isnan(r.u))
    line += r.diameter > 0 ? fmt::format("  u/D {:.3f}", r.u / r.diameter) : fmt::format("  u {:.2f} mm", r.u * 1000);
  if (!std::isnan(r.w)) line += fmt::format("  w {:.2f} mm", r.w * 1000);
  if (!std::isnan(r.V)) line += fmt::format("  V {:.3f}", r.V / 1000);
  if (!std::isnan(r.H)) line += fmt::format("  H {:.3f}", r.H / 1000);
  if (!std::isnan(r.V) || !std::isnan(r.H)) line += r.whole ? " kN" : " kN/m";
  if (r.particle_steps > 0 && elapsed > 0) line += fmt::format("  {}particle-steps/s", words_of_speed(r.particle_steps / elapsed));
  return line;
}

Progress::Progress(RunLog& log) : log_(log), start_(Clock::now()), shown_(start_ - between_lines_in_place), told_(start_) {}

Progress::~Progress()
{
  log_.rewrite_line("");
}

bool Progress::due() const
{
  return Clock::now() - shown_ >= between_lines_in_place;
}

void Progress::count_from(Real seconds_before)
{
  start_ -= std::chrono::duration_cast<Clock::duration>(std::chrono::duration<Real>(seconds_before));
}

void Progress::update(const ProgressReport& report)
{
  const auto now = Clock::now();
  const int tenth = std::isnan(report.done) ? 0 : static_cast<int>(std::floor(std::clamp<Real>(report.done, 0, 1) * 10 + 1e-9));
  const std::string line = progress_line(report, seconds_of(now - start_));
  if (tenth > tenth_ || now - told_ >= between_plain_lines || report.stage != stage_) {
    if (log_.has_terminal())
      log_.info_to_file(line);
    else
      io::info("{}", line);
    tenth_ = std::max(tenth, tenth_);
    told_ = now;
    stage_ = report.stage;
  }
  if (due()) {
    log_.rewrite_line(line);
    shown_ = now;
  }
}

}  // namespace berm::run_folder
