#pragma once

#include <functional>
#include <string>
#include <vector>

#include <fairlight/estimators/vec.h>
#include <fairlight/validation/checks/direction_checks.h>

namespace fairlight {

/// The number of draws at which an identity is checked.
inline constexpr int identity_draws = 1 << 14;

/// A statement that holds at every draw, with its largest violation so far and where that was.
struct Identity {
  const char* check;
  const char* statement;
  double worst = 0;
  std::string where{};

  /// `place()` says where; it is called for a new largest violation alone.
  void see(double gap, const auto& place) {
    if (gap <= worst) return;
    worst = gap;
    where = place();
  }
};

/// Biased if the largest violation is above the rounding. The note says where it was, or in which
/// share of draws there is none, at the trial's miss rate.
PartFinding finding_of(const Trial& trial, const Identity& identity, double rounding);

/// Calls f(u) with every combination of numbers at the edge of [0,1): 0, 2^-53, 1/2, the largest
/// float and the largest double below 1.
void for_each_edge(std::size_t dimensions, const std::function<void(const std::vector<double>& u)>& f);

/// The difference relative to the larger magnitude; infinite where one is not finite. Values near
/// the smallest floats keep few digits, so those below 1e-20, which nobody sees, count as 1e-20.
double gap_between(double x, double y);
double gap_between(const Rgb<double>& x, const Rgb<double>& y);

/// Whether it is finite and not negative.
bool is_valid(double x);
bool is_valid(const Rgb<double>& colour);

/// What is wrong with a sampled direction and its density by themselves; empty if nothing is.
std::string problem_of(const Vec3<double>& direction, double pdf, double rounding);

std::string text_of(const Vec3<double>& v);
std::string text_of(const Rgb<double>& colour);
std::string text_of(const std::vector<double>& numbers);

}  // namespace fairlight
