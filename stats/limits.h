#pragma once

#include <chrono>
#include <cstdint>

namespace fairlight {

/// The most that one expectation may take. A member that is 0 stands for the environment's
/// FAIRLIGHT_DRAWS or FAIRLIGHT_SECONDS, or else for 1e10 draws and 60 s.
struct Limits {
  double draws = 0;
  double seconds = 0;
};

/// The limits with no 0 in them. Throws std::invalid_argument for a member or a variable that is not
/// a positive number.
Limits resolved(const Limits& limits);

/// Counts the draws of an expectation, and ends it at its limits.
class Meter {
 public:
  explicit Meter(const Limits& limits);

  /// Call it before each draw. Throws NoMoreDraws when a limit is reached.
  void draw() {
    if (++drawn_ >= next_look_) look();
  }

  std::uint64_t drawn() const { return drawn_; }

 private:
  using Clock = std::chrono::steady_clock;

  void look();

  Limits limits_;
  Clock::time_point begin_ = Clock::now(), last_ = begin_;
  std::uint64_t drawn_ = 0, next_look_ = 1, stride_ = 1;
};

}  // namespace fairlight
