// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "user_law/crash_guard.hpp"
#include "user_law/function.hpp"

#include <atomic>
#include <mutex>

namespace berm::user_law {

/// A law of a shared library as the methods call it: increments that the law finds too large are halved, the tangent is completed, and what fails is noted.
class LoadedLaw : public material::PointLaw {
public:
  using Function = std::variant<OwnFunction, Umat>;
  static constexpr int max_halvings = 10;  ///< of an increment

  /// `words` is what messages call the law: `the law "umat" of [material.clay] (umat_ of /a/b.so)`. With one_at_a_time threads wait for each other.
  LoadedLaw(const Function& function, const Constants& constants, const std::string& words, bool one_at_a_time);

  void advance(material::UserIncrement& increment) const override;

  std::string failure() const override;
  void forget_failure() const override;
  const std::string& words() const { return words_; }
  const Constants& constants() const { return constants_; }
  const Function& function() const { return function_; }

private:
  /// Stress and state at the beginning of an increment.
  struct Before {
    Before(const material::UserIncrement& increment, int state_variables);
    void restore(material::UserIncrement& increment, int state_variables) const;

    Real stress[6], state[material::max_user_state];
  };

  Answer follow(material::UserIncrement& increment, const Before& before, bool& tangent_given, int halvings) const;
  Answer follow_halves(material::UserIncrement& increment, bool& tangent_given, int halvings) const;
  void take_differences(const Before& before, material::UserIncrement& end) const;
  void note_failure(const Before& before, const material::UserIncrement& increment, Answer answer) const;

  Function function_;
  Constants constants_;
  std::string words_;
  bool one_at_a_time_;
  CrashGuard guard_;
  mutable std::mutex calls_, notes_;
  mutable std::atomic<bool> failed_ = false;
  mutable std::string failure_;
};

}  // namespace berm::user_law
