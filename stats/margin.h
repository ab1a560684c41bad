#pragma once

#include <string>

namespace fairlight {

/// The bias that an expectation excludes. A plain number in (0,1) is a share of the reference. A
/// mean of 0 has no such share: give the margin in the unit of the draws, absolute(0.01), or as a
/// share of another scale, Margin(0.01, scale).
class Margin {
 public:
  Margin(double share) : share_(share) {}  // NOLINT: a number is a margin
  /// Throws std::invalid_argument for a scale that is not positive and finite.
  Margin(double share, double scale);

  double share() const { return share_; }
  /// What the share is of: the caller's scale, or else `reference`. Throws std::invalid_argument,
  /// with what to give, where the reference is 0.
  double scale(double reference) const;
  bool has_scale() const { return scale_ != 0; }

  /// The unit in which a bias relative to `scale` is printed, as a factor and in words.
  double unit(double scale) const { return absolute_ ? scale : 1; }
  std::string unit_name(double scale) const;

  friend Margin absolute(double margin);

 private:
  double share_;
  double scale_ = 0;
  bool absolute_ = false;
};

/// A margin in the unit of the draws; positive and finite, or it throws std::invalid_argument.
Margin absolute(double margin);

}  // namespace fairlight
