#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Core>

#include <fairlight/stats/moments.h>

namespace fairlight {

namespace {

using Eight = Eigen::Array<double, 8, 1>;

// Calls f with eight draws at a time; fills up the last eight with `filler`.
template <class F>
void by_eights(std::span<const double> draws, double filler, const F& f) {
  std::size_t i = 0;
  for (; i + 8 <= draws.size(); i += 8) f(Eight(Eigen::Map<const Eight>(&draws[i])));
  if (i == draws.size()) return;
  Eight rest = Eight::Constant(filler);
  for (Eigen::Index k = 0; i < draws.size(); ++i) rest[k++] = draws[i];
  f(rest);
}

}  // namespace

Moments Moments::of(std::span<const double> draws) {
  Moments moments;
  if (draws.empty()) return moments;
  moments.count_ = draws.size();
  moments.minimum_ = moments.maximum_ = moments.mean_ = draws[0];
  if (draws.size() == 1) return moments;
  moments.add_mean(draws);
  moments.add_powers(draws);
  return moments;
}

// Searches for a NaN only if the sum is NaN, as the search is slower. If all draws are equal, the
// mean is their exact value; sum / n could round.
void Moments::add_mean(std::span<const double> draws) {
  const Eigen::Map<const Eigen::ArrayXd> all(draws.data(), static_cast<Eigen::Index>(draws.size()));
  Eight least = Eight::Constant(draws[0]), most = least;
  by_eights(draws, draws[0], [&](const Eight& x) {
    least = least.min(x);
    most = most.max(x);
  });
  const double sum = all.sum();
  minimum_ = std::isnan(sum) ? all.minCoeff<Eigen::PropagateNaN>() : least.minCoeff();
  maximum_ = std::isnan(sum) ? all.maxCoeff<Eigen::PropagateNaN>() : most.maxCoeff();
  if (minimum_ != maximum_) mean_ = sum / static_cast<double>(draws.size());
}

void Moments::add_powers(std::span<const double> draws) {
  Eight squares = Eight::Zero(), cubes = Eight::Zero(), fourths = Eight::Zero();
  by_eights(draws, mean_, [&](const Eight& x) {
    const Eight deviation = x - mean_, square = deviation.square();
    squares += square;
    cubes += square * deviation;
    fourths += square.square();
  });
  m2_ = squares.sum();
  m3_ = cubes.sum();
  m4_ = fourths.sum();
}

void Moments::merge(const Moments& other) {
  if (other.count_ == 0) return;
  const double n = static_cast<double>(count_) + static_cast<double>(other.count_);
  const double a = static_cast<double>(count_) / n, b = static_cast<double>(other.count_) / n;
  const double d = other.mean_ - mean_;
  // The squared deviations of the two means from the common mean, weighted by the counts.
  const double spread = d * d * a * static_cast<double>(other.count_);
  m4_ += other.m4_ + d * d * spread * (a * a - a * b + b * b) + 6 * d * d * (a * a * other.m2_ + b * b * m2_) +
         4 * d * (a * other.m3_ - b * m3_);
  m3_ += other.m3_ + d * spread * (a - b) + 3 * d * (a * other.m2_ - b * m2_);
  m2_ += other.m2_ + spread;
  mean_ += d * b;
  count_ += other.count_;
  minimum_ = std::isnan(other.minimum_) ? other.minimum_ : std::min(minimum_, other.minimum_);
  maximum_ = std::isnan(other.maximum_) ? other.maximum_ : std::max(maximum_, other.maximum_);
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

double Moments::variance_of_variance() const {
  return m2_ == 0 ? 0 : m4_ / (m2_ * m2_) - 1 / static_cast<double>(count_);
}

}  // namespace fairlight
