#include <stdexcept>

#include <fairlight/stats/moments.h>

namespace fairlight {

Moments Moments::of(std::span<const double> draws) {
  Moments moments;
  if (draws.empty()) return moments;
  double sum = 0;
  for (double x : draws) sum += x;
  moments.count_ = draws.size();
  moments.mean_ = sum / static_cast<double>(draws.size());
  for (double x : draws) moments.squares_ += (x - moments.mean_) * (x - moments.mean_);
  return moments;
}

void Moments::merge(const Moments& other) {
  if (other.count_ == 0) return;
  const auto mine = static_cast<double>(count_);
  const auto theirs = static_cast<double>(other.count_);
  const double shift = other.mean_ - mean_;
  const double all = mine + theirs;
  mean_ += shift * (theirs / all);
  squares_ += other.squares_ + shift * shift * (mine * theirs / all);
  count_ += other.count_;
}

double Moments::variance() const {
  if (count_ < 2) throw std::logic_error("a variance needs at least two draws");
  return squares_ / static_cast<double>(count_ - 1);
}

}  // namespace fairlight
