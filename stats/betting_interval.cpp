#include <algorithm>
#include <cmath>

#include <boost/math/tools/toms748_solve.hpp>

#include <fairlight/stats/betting_test.h>

namespace fairlight {

// Padded with zero bets to a multiple of four, as `evidence` multiplies four factors at a time.
BettingTest::Stakes BettingTest::stakes(bool above, double margin) const {
  const auto& h = hypothesis_;
  const auto n = static_cast<Eigen::Index>(blocks_.size());
  Stakes all{Eigen::ArrayXd::Zero((n + 3) / 4 * 4), Eigen::ArrayXd::Zero((n + 3) / 4 * 4),
             largest_stake / (above ? h.mean - h.lower : h.upper - h.mean + h.tail_slack)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const Block& block = blocks_[static_cast<std::size_t>(i)];
    all.bets[i] = margin == h.margin ? block.bet : bet_on(margin, block.outlook.variance, block.outlook.skew);
    all.on[i] = above ? block.mean : -h.tail_slack - block.capped;
  }
  return all;
}

// The log wealth of betting, with the whole mixture, against a mean at most (or at least) the
// candidate, less a log threshold. It falls as the candidate moves towards the draws. All bets stay
// affordable for candidates inside the search range.
double BettingTest::evidence(const Stakes& stakes, double candidate, double threshold) {
  std::array<LogProduct, 3> wealth;
  for (Eigen::Index i = 0; i < stakes.bets.size(); i += 4) {
    const Eigen::Array4d bets = stakes.bets.segment<4>(i), gains = stakes.on.segment<4>(i) - candidate;
    for (std::size_t k = 0; k < wealth.size(); ++k)
      wealth[k].multiply((1 + (mixture_factors[k] * bets).min(stakes.largest) * gains).prod());
  }
  return log_mixture(wealth) - threshold;
}

// Finds the candidate at which `evidence` is 0: tries the margin, then four margins from the mean of
// the draws, then the bound; on the other side it ends where bets are not affordable.
double BettingTest::end_of_interval(bool above, double margin, double threshold) const {
  const auto& h = hypothesis_;
  const Stakes all = stakes(above, margin);
  const double sign = above ? 1 : -1, bound = above ? h.lower : h.upper;
  if (std::isinf(bound)) return bound;
  const double limit = bound + (h.mean - bound) / (1.05 * largest_stake);
  const auto excess = [&](double candidate) { return evidence(all, sign * candidate, threshold); };
  double open = above ? std::min(moments_.mean(), limit) : std::max(moments_.mean(), limit);
  double at_open = excess(open);
  if (at_open >= 0) at_open = excess(open = limit);
  if (at_open >= 0) return limit;
  double proven = bound, at_proven = -1;
  for (double candidate : {h.mean - sign * margin, open - 4 * sign * margin, bound}) {
    if (sign * (candidate - bound) < 0 || sign * (open - candidate) <= 0) continue;
    at_proven = excess(proven = candidate);
    if (at_proven >= 0) break;
  }
  if (at_proven < 0) return bound;
  const double low = std::min(open, proven), high = std::max(open, proven);
  std::uintmax_t iterations = 100;
  const auto near_enough = [&](double a, double b) { return b - a < 1e-3 * margin; };
  const auto bracket = boost::math::tools::toms748_solve(excess, low, high, above ? at_proven : at_open,
                                                         above ? at_open : at_proven, near_enough, iterations);
  return above ? bracket.first : bracket.second;
}

Interval BettingTest::interval() const {
  const double threshold = std::log(mixture_weights[0] / beta_);
  if (verdict_ == Verdict::undecided && blocks_.size() <= most_blocks_for_grid) return interval_of_grid();
  return {end_of_interval(true, hypothesis_.margin, threshold),
          end_of_interval(false, hypothesis_.margin, threshold)};
}

// Bets for a fine margin say little before it is reached. This is what bets for margins 1, 4, 16, ...
// times as large say together, each with a part of beta/8.
Interval BettingTest::interval_of_grid() const {
  const auto& h = hypothesis_;
  std::vector<double> margins;
  for (double m = h.margin; margins.empty() || m < reach(); m *= 4) margins.push_back(m);
  const double threshold = std::log(8 * static_cast<double>(margins.size()) / beta_);
  Interval all{h.lower, h.upper};
  for (double margin : margins) {
    all.lo = std::max(all.lo, end_of_interval(true, margin, threshold));
    all.hi = std::min(all.hi, end_of_interval(false, margin, threshold));
  }
  return all;
}

}  // namespace fairlight
