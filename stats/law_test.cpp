#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>

#include <fairlight/stats/chi_square.h>
#include <fairlight/stats/evidence.h>
#include <fairlight/stats/law_test.h>
#include <fairlight/stats/outcomes.h>
#include <fairlight/stats/text.h>

namespace fairlight {
namespace {

Finding refuted(const Trial& trial, const std::string& why) {
  Finding finding{Verdict::biased, Guarantee::deterministic, trial.margin};
  finding.note = why;
  return with_token(trial, finding);
}

Finding undecided(const Trial& trial, const std::string& why) {
  Finding finding{Verdict::undecided, Guarantee::asymptotic, trial.margin};
  finding.interval.hi = std::numeric_limits<double>::infinity();
  finding.note = why;
  return with_token(trial, finding);
}

// A confidence interval of the distance between the two laws; each end is wrong with probability
// beta.
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

// The cell whose count has the least binomial tail, if that is below alpha / (2 cells), so that all
// cells and both tails together have level alpha; -1 if none is.
int wrong_cell(const std::vector<std::uint64_t>& counts, const LawCells& cells, std::uint64_t draws, double alpha) {
  double least = alpha / (2 * static_cast<double>(counts.size()));
  int wrong = -1;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (cells.probabilities[i] == 0 && counts[i] == 0) continue;
    const CellTails tails = cell_tails(counts[i], static_cast<double>(draws), cells.probabilities[i]);
    const double tail = std::min(tails.too_few, tails.too_many);
    if (!(tail < least)) continue;
    least = tail;
    wrong = static_cast<int>(i);
  }
  return wrong;
}

// Chi-square on groups of cells. Its distance is over the groups, so the finding says how many.
Finding judged_in_groups(const Trial& trial, const LawCells& cells, const std::vector<std::uint64_t>& counts,
                         std::uint64_t draws, double part, double beta) {
  const ChiSquare result = chi_square(counts, cells.probabilities);
  const double alpha = trial.alpha / 2 * part;
  Finding finding{judge(result, draws, trial.margin, alpha, beta), Guarantee::asymptotic, trial.margin};
  finding.note = formatted(
      "asymptotic: chi-square's law is the limit of many draws; the margin is over %.0f groups, of %zu cells, "
      "that each expect at least 80",
      result.degrees + 1, cells.probabilities.size());
  const auto n = static_cast<double>(draws);
  finding.draws = draws;
  finding.bias = std::sqrt(std::max(result.statistic - result.degrees, 0.0) / n);
  finding.interval = distance_interval(result, n, beta);
  return finding;
}

// The finding of one look, which has the fraction `part` of alpha and beta.
Finding judged(const Trial& trial, const LawCells& cells, const std::vector<std::uint64_t>& counts,
               std::uint64_t draws, double part) {
  const auto n = static_cast<double>(draws);
  const bool in_groups = ends_of_groups(cells.probabilities, n).size() > 1;
  if (!in_groups && !cells.each_alone)
    throw TooFewDraws("all of the law's mass is in one cell (give a domain or cuts that divide it)");
  // A cell that chi-square sees only in a group is bounded alone, by half of beta.
  const double beta = trial.beta * part / (in_groups && cells.each_alone ? 2 : 1);
  Finding finding{Verdict::certified, Guarantee::exact, trial.margin};
  finding.draws = draws;
  if (in_groups) finding = judged_in_groups(trial, cells, counts, draws, part, beta);
  if (cells.each_alone) {
    const OutcomeBounds bounds = bound_rare_outcomes(counts, cells.probabilities, n, beta, !in_groups);
    if (bounds.deviation >= trial.margin) finding.verdict = worse(finding.verdict, Verdict::undecided);
    if (!in_groups) {
      finding.bias = bounds.estimate;
      finding.interval = {0, bounds.deviation};
      finding.note = "each outcome by its binomial law; the margin is of |q - p| / sqrt(p), with p at least 1e-7";
    }
  }
  const int wrong = wrong_cell(counts, cells, draws, trial.alpha / 2 * part);
  if (wrong >= 0) {
    const auto cell = static_cast<std::size_t>(wrong);
    finding.verdict = Verdict::biased;
    finding.note = "cell " + std::to_string(wrong) + " has " + std::to_string(counts[cell]) + " draws where " +
                   std::to_string(n * cells.probabilities[cell]) + " are expected";
  }
  return finding;
}

// The looks: their numbers of draws, and the fraction of alpha and beta that each has.
struct Looks {
  std::vector<std::uint64_t> at;
  double part;
};

// Right laws mostly have their verdict at the first or second look. Drops the looks at which the
// cells are pooled differently than at the last.
Looks looks_for(const Trial& trial, const LawCells& cells) {
  const std::vector<double>& probabilities = cells.probabilities;
  std::vector<double> shares{0.25, 0.35, 0.5, 1};
  for (;;) {
    Looks looks{{}, 1 / static_cast<double>(shares.size())};
    const double alpha = trial.alpha / 2 * looks.part, beta = trial.beta * looks.part;
    auto most = static_cast<double>(
        draws_to_tell_apart(probabilities.size(), trial.margin, alpha, cells.each_alone ? beta / 2 : beta));
    if (cells.each_alone) most = draws_for_outcomes(probabilities, trial.margin, most);
    for (double share : shares) looks.at.push_back(static_cast<std::uint64_t>(std::ceil(share * most)));
    const auto groups = [&](double share) { return ends_of_groups(probabilities, std::ceil(share * most)); };
    const auto otherwise = [&](double share) { return groups(share) != groups(1); };
    if (std::erase_if(shares, otherwise) == 0) return looks;
  }
}

// The finding of one look; biased or undecided if the counts are not valid.
Finding seen(const Trial& trial, const LawCells& cells, const std::vector<std::uint64_t>& counts,
             std::uint64_t draws, double part) try {
  if (std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}) != draws) {
    return refuted(trial, "the counts do not add up to the number of draws");
  }
  return with_token(trial, judged(trial, cells, counts, draws, part));
} catch (const TooFewDraws& few) {
  return undecided(trial, few.what());
} catch (const std::invalid_argument& bad) {
  return refuted(trial, bad.what());
}

Finding look_until_decided(const Trial& trial, const LawCells& cells, const Looks& looks, const CountMore& count) {
  const auto size = static_cast<int>(cells.probabilities.size());
  Evidence::Cells all{cells.lossy ? size : cells.rows, cells.lossy ? 1 : cells.columns, cells.probabilities, {}, 0};
  all.counts.resize(cells.probabilities.size());
  Finding finding;
  std::uint64_t drawn = 0;
  for (const std::uint64_t draws : looks.at) {
    const std::vector<std::uint64_t> more = count(draws - drawn);
    if (more.size() != all.counts.size()) return refuted(trial, "there must be one count for each cell of the law");
    std::transform(more.begin(), more.end(), all.counts.begin(), all.counts.begin(), std::plus<>());
    drawn = draws;
    all.draws = static_cast<double>(draws);
    finding = seen(trial, cells, all.counts, draws, looks.part);
    if (finding.verdict != Verdict::undecided) break;
  }
  if (trial.evidence != nullptr) trial.evidence->laws.push_back(all);
  return finding;
}

}  // namespace

void check_place(std::uint64_t i, const Eigen::Vector2d& place) {
  for (double x : place) {
    if (!(x >= 0 && x <= 1)) throw BadDraw(i, x, "the coordinate of a point outside the domain");
  }
}

bool is_outside(const Eigen::Vector2d& place) {
  return std::isfinite(place.x()) && std::isfinite(place.y()) && !(place.minCoeff() >= 0 && place.maxCoeff() <= 1);
}

void check_lost(std::uint64_t i, bool lossy) {
  if (!lossy) throw BadDraw(i, std::numeric_limits<double>::quiet_NaN(), "lost, in a domain that loses none");
}

void check_size(double size) {
  if (!(size > 0 && std::isfinite(size)))
    throw std::domain_error(
        formatted("the domain has the size %g (a law needs one that is positive and finite)", size));
}

void check_density_of_draw(std::uint64_t i, double density) {
  if (!(density > 0 && std::isfinite(density))) throw BadDraw(i, density, "the density where it fell");
}

Finding detail::refuted_density(const Trial& trial, const std::string& why) { return refuted(trial, why); }

Finding detail::guarded(const Trial& trial, const std::function<Finding()>& test) try {
  check_trial(trial);
  return test();
} catch (const BadDraw& bad) {
  return refuted(trial, bad.what());
} catch (const std::domain_error& bad) {
  return refuted(trial, bad.what());
} catch (const CannotIntegrate& hard) {
  return undecided(trial, hard.what());
} catch (const NoMoreDraws& spent) {
  return undecided(trial, spent.what());
} catch (const detail::ToldToEnd&) {
  return undecided(trial, told_to_end);
}

Finding test_counts(const Trial& trial, const LawCells& cells, const CountMore& count) {
  return detail::guarded(trial, [&] {
    if (cells.error > 1e-6) throw CannotIntegrate(cannot_integrate);
    const double lost = cells.lossy ? cells.probabilities.back() : 0;
    const double total = std::accumulate(cells.probabilities.begin(), cells.probabilities.end(), -lost);
    if (!(std::abs(total + lost - 1) <= 1e-6 + cells.error))
      return refuted(trial, formatted("the density integrates to %f, not to %g", total, 1 - lost));
    return look_until_decided(trial, cells, looks_for(trial, cells), count);
  });
}

}  // namespace fairlight
