#include <algorithm>
#include <cmath>
#include <numeric>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>

#include <fairlight/validation/checks.h>

namespace fairlight {
namespace {

Finding refuted(const Trial& trial, Guarantee guarantee, const std::string& why) {
  Finding finding;
  finding.verdict = Verdict::biased;
  finding.guarantee = guarantee;
  finding.margin = trial.margin;
  finding.note = why;
  return finding;
}

bool open(const BettingTest& test) { return test.verdict() == Verdict::undecided; }

// Runs the tests to their verdicts, or until the last of them has lost patience.
void run(std::vector<BettingTest>& tests, const DrawBlock& draw_block) {
  std::vector<std::vector<double>> channels(tests.size());
  for (std::uint64_t drawn = 0;;) {
    std::uint64_t block = 0;
    double patience = 0;
    for (const BettingTest& test : tests) {
      if (!open(test)) continue;
      block = block == 0 ? test.block_size() : std::min(block, test.block_size());
      patience = std::max(patience, test.patience());
    }
    const bool refuted =
        std::any_of(tests.begin(), tests.end(), [](auto& t) { return t.verdict() == Verdict::biased; });
    if (block == 0 || refuted || static_cast<double>(drawn) > patience) return;
    for (auto& channel : channels) channel.resize(block);
    draw_block(drawn, channels);
    for (std::size_t c = 0; c < tests.size(); ++c) tests[c].add(channels[c]);
    drawn += block;
  }
}

Finding channel_finding(const BettingTest& test, const Reference& reference, double margin) {
  const Interval interval = test.interval();
  Finding finding;
  finding.verdict = test.verdict();
  finding.guarantee = Guarantee::exact;
  finding.margin = margin;
  finding.bias = (test.moments().mean() - reference.mean) / reference.scale;
  finding.interval = {(interval.lo - reference.mean) / reference.scale,
                      (interval.hi - reference.mean) / reference.scale};
  finding.draws = test.moments().count();
  return finding;
}

// The bias of the worst channel over a few draws, for the report alone: the verdict rests on a draw out of its
// range.
double rough_bias(const std::vector<Reference>& references, const DrawBlock& draw_block) {
  std::vector<std::vector<double>> channels(references.size(), std::vector<double>(4096));
  draw_block(0, channels);
  double worst = 0;
  for (std::size_t c = 0; c < references.size(); ++c) {
    const double bias = (Moments::of(channels[c]).mean() - references[c].mean) / references[c].scale;
    if (!(std::abs(bias) <= std::abs(worst))) worst = bias;
  }
  return worst;
}

// What the statistic says of the distance between the two laws: each end wrong with probability beta.
Interval distance_interval(const ChiSquare& result, double draws, double beta) {
  const auto distance = [&](double probability_below) {
    if (boost::math::cdf(boost::math::chi_squared(result.degrees), result.statistic) <= probability_below)
      return 0.0;
    return std::sqrt(boost::math::non_central_chi_squared::find_non_centrality(result.degrees, result.statistic,
                                                                               probability_below) /
                     draws);
  };
  return {distance(1 - beta), distance(beta)};
}

}  // namespace

Finding check_means(const Trial& trial, const std::vector<Reference>& references, const DrawBlock& draw_block) {
  std::vector<BettingTest> tests;
  const double alpha = trial.alpha / static_cast<double>(references.size());
  for (const Reference& r : references) {
    tests.emplace_back(MeanHypothesis{r.mean, trial.margin * r.scale, r.lower, r.upper, r.tail_slack}, alpha,
                       trial.beta);
  }
  try {
    run(tests, draw_block);
  } catch (const BadDraw& bad) {
    Finding finding = refuted(trial, Guarantee::exact, bad.what());
    finding.draws = bad.draw() + 1;
    finding.bias = rough_bias(references, draw_block);
    return finding;
  }
  Finding worst;
  for (std::size_t c = 0; c < tests.size(); ++c) {
    const Finding finding = channel_finding(tests[c], references[c], trial.margin);
    const Verdict verdict = c == 0 ? finding.verdict : worse(worst.verdict, finding.verdict);
    const std::uint64_t draws = std::max(worst.draws, finding.draws);
    if (c == 0 || std::abs(finding.bias) > std::abs(worst.bias)) worst = finding;
    worst.verdict = verdict;
    worst.draws = draws;
  }
  return worst;
}

Finding check_counts(const Trial& trial, const LawCells& cells,
                     const std::function<std::vector<std::uint64_t>(std::uint64_t draws)>& count) {
  const double total = std::accumulate(cells.probabilities.begin(), cells.probabilities.end(), 0.0);
  if (!(std::abs(total - 1) <= 1e-6 + cells.total_error) || cells.total_error > 1e-6) {
    return refuted(trial, Guarantee::deterministic,
                   "the density integrates to " + std::to_string(total) + ", not to 1");
  }
  const std::uint64_t draws =
      draws_to_tell_apart(cells.probabilities.size(), trial.margin, trial.alpha, trial.beta);
  try {
    const std::vector<std::uint64_t> counts = count(draws);
    const ChiSquare result = chi_square(counts, cells.probabilities);
    Finding finding;
    finding.verdict = judge(result, draws, trial.margin, trial.alpha, trial.beta);
    finding.guarantee = Guarantee::asymptotic;
    finding.margin = trial.margin;
    finding.draws = draws;
    const auto n = static_cast<double>(draws);
    finding.bias = std::sqrt(std::max(result.statistic - result.degrees, 0.0) / n);
    finding.interval = distance_interval(result, n, trial.beta);
    return finding;
  } catch (const std::runtime_error& bad) {
    return refuted(trial, Guarantee::deterministic, bad.what());
  } catch (const std::invalid_argument& bad) {
    return refuted(trial, Guarantee::deterministic, bad.what());
  }
}

}  // namespace fairlight
