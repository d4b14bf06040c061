// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/build.hpp"

#include "core/vector_unit.hpp"
#include "io/sha256.hpp"

#include <dlfcn.h>

namespace berm::run_folder {
namespace {

namespace fs = std::filesystem;

constexpr const char* program_entry = "program_build";
constexpr const char* engine_entry = "engine_build";
constexpr const char* unit_entry = "vector_unit";
constexpr const char* baseline = "baseline";

const void* in_engine()
{
  return reinterpret_cast<const void*>(&vector_unit);
}

std::string program_build()
{
  return io::build_id_at(reinterpret_cast<const void*>(&program_build));
}

std::string entry(const RunSummary& summary, const char* name)
{
  const auto found = summary.text.find(name);
  return found == summary.text.end() ? "" : found->second;
}

/// The engine of this build for another vector unit: where the loader looks for it.
fs::path engine_file_for(const std::string& unit)
{
  Dl_info info{};
  if (::dladdr(in_engine(), &info) == 0 || info.dli_fname == nullptr) return {};
  const fs::path loaded = info.dli_fname;
  const fs::path libraries =
      vector_unit() == std::string(baseline) ? loaded.parent_path() : loaded.parent_path().parent_path().parent_path();
  return unit == baseline ? libraries / loaded.filename() : libraries / "glibc-hwcaps" / unit / loaded.filename();
}

/// "" where this build has no engine for that unit.
std::string engine_build_for(const std::string& unit)
{
  if (unit == vector_unit()) return io::build_id_at(in_engine());
  return unit.find('/') == std::string::npos ? io::build_id_in(engine_file_for(unit)) : "";
}

}  // namespace

std::vector<std::pair<std::string, std::string>> this_build()
{
  return {{program_entry, program_build()}, {engine_entry, engine_build_for(vector_unit())}, {unit_entry, vector_unit()}};
}

bool by_this_build(const RunSummary& summary, settings::Method method)
{
  const std::string unit = vector_unit_of(summary), engine = entry(summary, engine_entry);
  if (entry(summary, "version") != BERM_VERSION || unit.empty() || engine.empty() || engine != engine_build_for(unit)) return false;
  return method != settings::Method::fem || recorded_by_this_program(summary);
}

bool recorded_by_this_program(const RunSummary& summary)
{
  return entry(summary, program_entry) == program_build();
}

std::string vector_unit_of(const RunSummary& summary)
{
  return entry(summary, unit_entry);
}

}  // namespace berm::run_folder
