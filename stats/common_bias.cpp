#include <algorithm>
#include <cmath>

#include <fairlight/stats/common_bias.h>

namespace fairlight {
namespace {

// The log wealths of a claim at its r-th level.
Wealth of_channels(const EvidenceSum& claim, std::size_t r) {
  std::vector<double> above, below, below_upper, above_lower;
  for (const auto& channel : claim.channels()) {
    const Wealth& wealth = channel[r].total;
    above.push_back(wealth.above_reference);
    below.push_back(wealth.below_reference);
    below_upper.push_back(wealth.below_upper_margin);
    above_lower.push_back(wealth.above_lower_margin);
  }
  return {log_mean_exp(above), log_mean_exp(below), std::ranges::min(below_upper), std::ranges::min(above_lower)};
}

void multiply(Wealth& total, const Wealth& more) {
  total.above_reference += more.above_reference;
  total.below_reference += more.below_reference;
  total.below_upper_margin += more.below_upper_margin;
  total.above_lower_margin += more.above_lower_margin;
}

}  // namespace

double log_mean_exp(std::span<const double> logs) {
  const double top = *std::ranges::max_element(logs);
  if (std::isinf(top)) return top;
  double sum = 0;
  for (double x : logs) sum += std::exp(x - top);
  return top + std::log(sum / static_cast<double>(logs.size()));
}

// A claim's first level stands for all coarser ones: what excludes a small bias excludes a larger
// one. Beyond its last level it has no evidence.
void CommonBias::add(const EvidenceSum& claim) {
  if (claim.empty()) return;
  ++claims_;
  const auto first = static_cast<std::size_t>(claim.first());
  const std::size_t end = std::min(first + claim.channels()[0].size(), total_.size());
  for (std::size_t r = 0; first + r < end; ++r) {
    const Wealth wealth = of_channels(claim, r);
    for (std::size_t level = r == 0 ? 0 : first + r; level <= first + r; ++level) multiply(total_[level], wealth);
  }
}

bool CommonBias::upward() const {
  double up = 0, down = 0;
  for (const Wealth& wealth : total_) {
    up = std::max(up, wealth.above_reference);
    down = std::max(down, wealth.below_reference);
  }
  return up > down;
}

EvidenceSum CommonBias::joint() const {
  std::vector<EvidenceSum::Sum> sums;
  for (const Wealth& wealth : total_)
    sums.push_back({wealth, wealth.below_upper_margin, wealth.above_lower_margin});
  return {0, {sums}};
}

}  // namespace fairlight
