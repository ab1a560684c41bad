#pragma once

#include <cmath>

namespace fairlight {

/// The mean of a pixel under naive::PooledStages in two stages, in closed form. There are four
/// pixels, all neighbours of each other. Their draws are 1/p with probability p and else 0, so the
/// true mean is 1. After the pilot come 12 more samples. The stages are independent. The two
/// samples of a pilot are independent, or are strata of each other.
class PooledSpikes {
  // Let the pilot of a pixel have m samples of sum S, and let n further samples follow. Given the
  // pilots n is fixed, so
  //     E[I | pilots] = (S + n 1) / (m + n).
  // The rest is a sum over S and n. Shares of 12 are integers in every case, so nothing is rounded.
 public:
  /// p is in (0,1). `both` is the probability that both samples of a pilot of two hit the spike:
  /// p^2 if they are independent; 0 if p <= 1/2 and each has its half of the unit interval, as in
  /// any point set.
  PooledSpikes(double p, double both) : p_(p), both_(both) {}

  /// The mean by deviation or variance, m = 2. A pilot varies if one of its two samples hit the
  /// spike, with the probability q = 2 (p - both); all that vary do so equally. If j of the other
  /// three vary, a pixel that varies gets n = 12 / (1 + j). One that does not gets nothing, or 3 if
  /// j = 0, as then no pixel varies.
  double by_history() const {
    const double q = 2 * (p_ - both_);
    const double none = std::pow(1 - q, 3);
    double mean = 0;
    for (int j = 0; j <= 3; ++j) mean += q * binomial(j, q) * pooled(1, 2, 12.0 / (1 + j));
    mean += both_ * (none * pooled(2, 2, 3) + (1 - none) * pooled(2, 2, 0));
    mean += (1 - q - both_) * none * pooled(0, 2, 3);
    return mean;
  }

  /// The mean by neighbours, m = 1. If h of the four pilots hit the spike, their contrast is
  /// proportional to 4 - h, and that of the others to h. The sum is 2 h (4 - h), so the shares of
  /// the 12 are 1 / (2 h) and 1 / (2 (4 - h)), and a quarter if h is 0 or 4.
  double by_neighbours() const {
    double mean = 0;
    for (int j = 0; j <= 3; ++j) {  // pilots of the other three that hit
      const double hit = j == 3 ? 3 : 6.0 / (1 + j);
      const double missed = j == 0 ? 3 : 6.0 / (4 - j);
      mean += binomial(j, p_) * (p_ * pooled(1, 1, hit) + (1 - p_) * pooled(0, 1, missed));
    }
    return mean;
  }

 private:
  /// The mean of a pixel whose pilot of m samples hit `spikes` spikes, and that gets n more
  /// samples.
  double pooled(double spikes, double m, double n) const { return (spikes / p_ + n) / (m + n); }

  /// The probability that exactly j of three pilots have a property of probability q.
  static double binomial(int j, double q) {
    const double ways = j == 0 || j == 3 ? 1 : 3;
    return ways * std::pow(q, j) * std::pow(1 - q, 3 - j);
  }

  double p_, both_;
};

}  // namespace fairlight
