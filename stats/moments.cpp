#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Core>

#include <fairlight/stats/moments.h>

namespace fairlight {

Moments Moments::of(std::span<const double> draws) {
  Moments moments;
  if (draws.empty()) return moments;
  const Eigen::Map<const Eigen::ArrayXd> x(draws.data(), static_cast<Eigen::Index>(draws.size()));
  moments.count_ = draws.size();
  moments.minimum_ = x.minCoeff<Eigen::PropagateNaN>();
  moments.maximum_ = x.maxCoeff<Eigen::PropagateNaN>();
  const bool equal = moments.minimum_ == moments.maximum_;  // whose mean is what they are, where a sum would round
  moments.mean_ = equal ? moments.minimum_ : x.sum() / static_cast<double>(draws.size());
  moments.add_powers(draws);
  return moments;
}

// The powers of all deviations in one pass, eight at a time.
void Moments::add_powers(std::span<const double> draws) {
  using Eight = Eigen::Array<double, 8, 1>;
  Eight squares = Eight::Zero(), cubes = Eight::Zero(), fourths = Eight::Zero();
  const auto add = [&](const Eight& deviation) {
    const Eight square = deviation.square();
    squares += square;
    cubes += square * deviation;
    fourths += square.square();
  };
  std::size_t i = 0;
  for (; i + 8 <= draws.size(); i += 8) add(Eigen::Map<const Eight>(&draws[i]) - mean_);
  Eight rest = Eight::Zero();
  for (Eigen::Index k = 0; i < draws.size(); ++i) rest[k++] = draws[i] - mean_;
  add(rest);
  m2_ = squares.sum();
  m3_ = cubes.sum();
  m4_ = fourths.sum();
}

void Moments::merge(const Moments& other) {
  if (other.count_ == 0) return;
  const auto a = static_cast<double>(count_);
  const auto b = static_cast<double>(other.count_);
  const double n = a + b;
  const double d = other.mean_ - mean_;
  const double ab = a * (b / n);  // a b / n without overflow
  m4_ += other.m4_ + d * d * d * d * ab * ((a * a - a * b + b * b) / (n * n)) +
         6 * d * d * (a / n * (a / n) * other.m2_ + b / n * (b / n) * m2_) +
         4 * d * (a / n * other.m3_ - b / n * m3_);
  m3_ += other.m3_ + d * d * d * ab * ((a - b) / n) + 3 * d * (a / n * other.m2_ - b / n * m2_);
  m2_ += other.m2_ + d * d * ab;
  mean_ += d * (b / n);
  count_ += other.count_;
  minimum_ = std::min(minimum_, other.minimum_);
  maximum_ = std::max(maximum_, other.maximum_);
}

double Moments::variance() const {
  if (count_ < 2) throw std::logic_error("a variance needs at least two draws");
  return m2_ / static_cast<double>(count_ - 1);
}

double Moments::standard_error() const { return std::sqrt(variance() / static_cast<double>(count_)); }

double Moments::skewness() const {
  if (count_ == 0) throw std::logic_error("a skewness needs at least one draw");
  return m2_ == 0 ? 0 : std::sqrt(static_cast<double>(count_)) * m3_ / (m2_ * std::sqrt(m2_));
}

double Moments::kurtosis() const {
  if (count_ == 0) throw std::logic_error("a kurtosis needs at least one draw");
  return m2_ == 0 ? 0 : static_cast<double>(count_) * m4_ / (m2_ * m2_);
}

double Moments::variance_of_variance() const {
  return m2_ == 0 ? 0 : m4_ / (m2_ * m2_) - 1 / static_cast<double>(count_);
}

}  // namespace fairlight
