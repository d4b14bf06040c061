// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sanity/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace berm::sanity {

/// Whether a case that makes no sense is not run at all, or run with a warning.
enum class Severity { warn, refuse };

/// What is doubtful of a case: the key that says it ("stage[1].velocity"), the number found, what is expected, and what to change.
struct Finding {
  Severity severity;
  std::string key, message;
};

/// What the questions found.
class Findings {
public:
  void warn(const std::string& key, const std::string& message) { all_.push_back({Severity::warn, key, message}); }
  void refuse(const std::string& key, const std::string& message) { all_.push_back({Severity::refuse, key, message}); }
  const std::vector<Finding>& all() const { return all_; }

private:
  std::vector<Finding> all_;
};

/// Asks all questions (questions.hpp): does what is asked make sense? Refusals come first.
std::vector<Finding> ask(const Scene& scene);

/// What `berm check` says of supports that move, line by line: speed, travel and frequency of each, and the frequency that the cells resolve.
std::vector<std::string> motion_words(const Scene& scene);

/// About what frames and history take of the disk, bytes; stages of unknown duration are counted with their begin and end.
Real disk_of(const Scene& scene);

/// "322 MB".
std::string words_of_bytes(Real bytes);

/// "18 mm", "1.25 m", "3 kg/m": three digits and the unit, of lengths, times and speeds a thousandth of it where that reads better.
std::string words_of(Real value, const char* unit);

/// "12.35 m", "499876.543 m": a place, four digits and at least millimetres of survey coordinates.
std::string place_words(Real metres);

/// "stage[2].until", the key of a stage.
std::string stage_key(std::size_t stage, const std::string& key);

/// The value rounded down (up) to one digit, for a proposal: 0.0437 gives 0.04 (0.05).
Real rounded_down(Real value);
Real rounded_up(Real value);

/// Weight of the soil of a body, N/m3.
Real unit_weight_of(const Scene& s, Index body);

/// The strength that decides how quickly a body may be driven: at a depth of its width, under the weight above, Pa; empty where nothing is known of it.
std::optional<Real> strength_at_depth_of(const Scene& s, Index body, Real width);

/// The key of a law's strength without friction.
std::string strength_key(const material::Material& material);

/// Whether a force moves the body of a stage along some axis.
bool is_by_force(const settings::StageSettings& stage);

}  // namespace berm::sanity
