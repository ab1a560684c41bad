#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include <fairlight/stats/tail.h>

namespace fairlight {

LargestScores::LargestScores(std::size_t keep) : keep_(keep) {
  if (keep < 2) throw std::invalid_argument("a tail needs at least two scores");
}

void LargestScores::add(std::span<const double> draws) {
  for (double x : draws) {
    const double score = std::abs(x);
    if (heap_.size() == keep_) {
      if (score <= heap_.front()) continue;
      std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
      heap_.pop_back();
    }
    heap_.push_back(score);
    std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
  }
}

double LargestScores::slope(std::size_t k) const {
  constexpr double none = std::numeric_limits<double>::infinity();
  constexpr std::size_t fewest = 25;
  std::vector<double> largest = heap_;
  std::ranges::sort(largest, std::greater<>());
  largest.resize(std::min(k, largest.size()));
  if (largest.size() < fewest || largest.back() == 0) return none;
  double sum = 0;
  for (double score : largest) sum += std::log(score / largest.back());
  return sum == 0 ? none : 1 + static_cast<double>(largest.size() - 1) / sum;
}

}  // namespace fairlight
