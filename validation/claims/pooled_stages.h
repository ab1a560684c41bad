#pragma once

#include <cmath>

namespace fairlight {

/// The mean of a pixel under naive::PooledStages in two stages, in closed form: four pixels, each other's
/// neighbours, whose draws are 1/p with probability p and else 0, so that the truth is 1; after the pilot 12 samples
/// more. The stages are independent; the two samples of a pilot are as well, or are strata of each other.
///
/// Let a pixel's pilot of m samples have sum S, and n further samples follow. Given the pilots n is fixed, so
///     E[I | pilots] = (S + n 1) / (m + n).
/// What is left is to sum over S and n; shares of 12 are whole numbers in every case, so nothing is rounded.
class PooledSpikes {
 public:
  /// p in (0,1), both samples of a pilot of two meeting the spike with probability `both`: p^2 where they are
  /// independent, 0 where p <= 1/2 and each has its half of the unit interval, as the points of any set.
  PooledSpikes(double p, double both) : p_(p), both_(both) {}

  /// By deviation or variance, m = 2. A pilot varies when one of its two samples met the spike, with probability
  /// q = 2 (p - both), and all that vary do so alike. With j of the other three varying, a pixel that varies gets
  /// n = 12 / (1 + j); one that does not gets nothing, or 3 when j = 0, since then no pixel varies.
  double by_history() const {
    const double q = 2 * (p_ - both_);
    const double none = std::pow(1 - q, 3);
    double mean = 0;
    for (int j = 0; j <= 3; ++j) mean += q * binomial(j, q) * pooled(1, 2, 12.0 / (1 + j));
    mean += both_ * (none * pooled(2, 2, 3) + (1 - none) * pooled(2, 2, 0));
    mean += (1 - q - both_) * none * pooled(0, 2, 3);
    return mean;
  }

  /// By neighbours, m = 1. When h of the four pilots met the spike, the contrast of those is in proportion to 4 - h
  /// and that of the others to h; the sum is 2 h (4 - h), so the shares are 1 / (2 h) and 1 / (2 (4 - h)) of the
  /// 12, and a quarter where h is 0 or 4.
  double by_neighbours() const {
    double mean = 0;
    for (int j = 0; j <= 3; ++j) {  // of the other three
      const double hit = j == 3 ? 3 : 6.0 / (1 + j);
      const double missed = j == 0 ? 3 : 6.0 / (4 - j);
      mean += binomial(j, p_) * (p_ * pooled(1, 1, hit) + (1 - p_) * pooled(0, 1, missed));
    }
    return mean;
  }

 private:
  /// The mean of a pixel whose pilot of m samples met `spikes` spikes, and that gets n more.
  double pooled(double spikes, double m, double n) const { return (spikes / p_ + n) / (m + n); }

  /// The probability that j of three do what each does with probability q.
  static double binomial(int j, double q) {
    const double ways = j == 0 || j == 3 ? 1 : 3;
    return ways * std::pow(q, j) * std::pow(1 - q, 3 - j);
  }

  double p_, both_;
};

}  // namespace fairlight
