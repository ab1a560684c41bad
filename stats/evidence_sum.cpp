#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include <fairlight/stats/evidence_sum.h>

namespace fairlight {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr int levels_a_run = 12;  // finest margin = coarsest / 45

bool certifies(const EvidenceSum::Sum& sum, double threshold) {
  return sum.below_upper_margin >= threshold && sum.above_lower_margin >= threshold;
}

}  // namespace

double margin_of_level(int level) { return std::exp2(-0.5 * level); }

int first_level(double margin) {
  return std::clamp(static_cast<int>(std::floor(-2 * std::log2(margin))), 0, margin_levels - levels_a_run);
}

std::vector<int> levels_of_run(double margin) {
  std::vector<int> all(levels_a_run);
  std::iota(all.begin(), all.end(), first_level(margin));
  return all;
}

std::vector<Wealth> wealth_at_levels(const BettingTest& test, double margin, double scale) {
  std::vector<Wealth> margin_grid;
  for (int level : levels_of_run(margin)) {
    Wealth wealth = test.wealth_for(margin_of_level(level) * scale);
    if (test.sides() == Sides::not_above)
      wealth = {wealth.above_reference, 0, wealth.below_upper_margin, unlimited};
    if (test.sides() == Sides::not_below)
      wealth = {0, wealth.below_reference, unlimited, wealth.above_lower_margin};
    margin_grid.push_back(wealth);
  }
  return margin_grid;
}

MarginGrid refuted_grid(double margin, std::size_t channels) {
  const std::vector<Wealth> channel(levels_a_run, Wealth{unlimited, unlimited, 0, 0});
  return {first_level(margin), std::vector(channels, channel)};
}

EvidenceSum::EvidenceSum(const MarginGrid& run) : first_(run.first) {
  for (const auto& channel : run.channels) {
    auto& sums = channels_.emplace_back();
    for (const Wealth& w : channel)
      sums.push_back({w, std::max(0.0, w.below_upper_margin), std::max(0.0, w.above_lower_margin)});
  }
}

// Extends the levels to begin at `first` or before, and to end at `end` or after.
void EvidenceSum::reach(int first, std::size_t end) {
  for (auto& channel : channels_) {
    if (first < first_) channel.insert(channel.begin(), static_cast<std::size_t>(first_ - first), channel.front());
    const std::size_t begin = static_cast<std::size_t>(std::min(first, first_));
    channel.resize(std::max(channel.size(), end - begin));
  }
  first_ = std::min(first, first_);
}

void EvidenceSum::append(EvidenceSum later) {
  if (later.empty()) return;
  if (empty()) {
    *this = std::move(later);
    return;
  }
  if (later.channels_.size() != channels_.size()) {
    throw std::invalid_argument(
        "the runs of a claim have different numbers of channels (they are of different claims)");
  }
  const auto end = [](const EvidenceSum& a) { return static_cast<std::size_t>(a.first_) + a.channels_[0].size(); };
  reach(later.first_, end(later));
  later.reach(first_, end(*this));
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    for (std::size_t r = 0; r < channels_[c].size(); ++r) {
      Sum& sum = channels_[c][r];
      const Sum& more = later.channels_[c][r];
      sum.below_upper_margin =
          std::max(sum.below_upper_margin, sum.total.below_upper_margin + more.below_upper_margin);
      sum.above_lower_margin =
          std::max(sum.above_lower_margin, sum.total.above_lower_margin + more.above_lower_margin);
      sum.total.above_reference += more.total.above_reference;
      sum.total.below_reference += more.total.below_reference;
      sum.total.below_upper_margin += more.total.below_upper_margin;
      sum.total.above_lower_margin += more.total.above_lower_margin;
    }
  }
}

// The levels before the first count like the first, so it has their weight too; those after the
// last have no evidence.
bool EvidenceSum::biased(double alpha) const {
  double top = 0;
  for (const auto& channel : channels_) {
    for (const Sum& sum : channel) top = std::max({top, sum.total.above_reference, sum.total.below_reference});
  }
  if (top == unlimited) return true;
  double mixture = 0;
  for (const auto& channel : channels_) {
    for (std::size_t r = 0; r < channel.size(); ++r) {
      const double weight = r == 0 ? first_ + 1 : 1;
      const Wealth& total = channel[r].total;
      mixture += weight * (std::exp(total.above_reference - top) + std::exp(total.below_reference - top));
    }
  }
  const double shares = 2.0 * margin_levels * static_cast<double>(channels_.size());
  return !empty() && top + std::log(mixture / shares) >= -std::log(alpha);
}

double EvidenceSum::certified_margin(double beta) const {
  double margin = unlimited;
  for (std::size_t r = 0; !empty() && r < channels_[0].size(); ++r) {
    if (!std::ranges::all_of(channels_, [&](const auto& sums) { return certifies(sums[r], -std::log(beta)); }))
      break;
    margin = margin_of_level(first_ + static_cast<int>(r));
  }
  return margin;
}

}  // namespace fairlight
