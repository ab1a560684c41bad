#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>

#include <fairlight/stats/chi_square.h>
#include <fairlight/stats/evidence.h>
#include <fairlight/stats/law_test.h>
#include <fairlight/stats/quadrature.h>

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

// The first cell whose count has a binomial tail below alpha / (2 cells), so that all cells and
// both tails together have level alpha; -1 if there is none.
int wrong_cell(const std::vector<std::uint64_t>& counts, const LawCells& cells, std::uint64_t draws, double alpha) {
  const double level = alpha / (2 * static_cast<double>(counts.size()));
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (cells.probabilities[i] == 0) continue;  // chi_square throws if it has draws
    const CellTails tails = cell_tails(counts[i], static_cast<double>(draws), cells.probabilities[i]);
    if (tails.too_few < level || tails.too_many < level) return static_cast<int>(i);
  }
  return -1;
}

// The finding of one look, which has the fraction `part` of alpha and beta.
Finding judged(const Trial& trial, const LawCells& cells, const std::vector<std::uint64_t>& counts,
               std::uint64_t draws, double part) {
  const ChiSquare result = chi_square(counts, cells.probabilities);
  const double alpha = trial.alpha / 2 * part;
  Finding finding{judge(result, draws, trial.margin, alpha, trial.beta * part), Guarantee::asymptotic,
                  trial.margin};
  finding.note = "asymptotic: chi-square's law is the limit of many draws (every cell here expects at least 80)";
  const auto n = static_cast<double>(draws);
  finding.draws = draws;
  finding.bias = std::sqrt(std::max(result.statistic - result.degrees, 0.0) / n);
  finding.interval = distance_interval(result, n, trial.beta * part);
  const int wrong = wrong_cell(counts, cells, draws, alpha);
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
Looks looks_for(const Trial& trial, const std::vector<double>& probabilities) {
  std::vector<double> shares{0.25, 0.35, 0.5, 1};
  for (;;) {
    Looks looks{{}, 1 / static_cast<double>(shares.size())};
    const auto most = static_cast<double>(draws_to_tell_apart(
        probabilities.size(), trial.margin, trial.alpha / 2 * looks.part, trial.beta * looks.part));
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
  Evidence::Cells all{cells.rows, cells.columns, cells.probabilities, {}, 0};
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

CellTails cell_tails(std::uint64_t count, double draws, double probability) {
  if (probability == 0) return {1, count == 0 ? 1.0 : 0.0};
  const boost::math::binomial law(draws, probability);
  const auto k = static_cast<double>(count);
  return {cdf(law, k), k > 0 ? cdf(complement(law, k - 1)) : 1};
}

std::size_t LawCells::index(const Eigen::Vector2d& place) const {
  const auto cut = [](double x, int n) {
    if (!(x >= 0 && x <= 1))
      throw std::out_of_range("a place outside the unit square (check its coordinates first)");
    return static_cast<std::size_t>(std::min(static_cast<int>(x * n), n - 1));
  };
  return cut(place.x(), rows) * static_cast<std::size_t>(columns) + cut(place.y(), columns);
}

void check_place(std::uint64_t i, const Eigen::Vector2d& place) {
  for (double x : place) {
    if (!(x >= 0 && x <= 1)) throw BadDraw(i, x, "the coordinate of a point outside the domain");
  }
}

void check_density_of_draw(std::uint64_t i, double density) {
  if (!(density > 0 && std::isfinite(density))) throw BadDraw(i, density, "the density where it fell");
}

double checked_density(double value, double s, double t) {
  if (value >= 0 && std::isfinite(value)) return value;
  throw std::domain_error("the density is " + std::to_string(value) + " at (" + std::to_string(s) + ", " +
                          std::to_string(t) + ") of its domain's square (it must be nonnegative and finite)");
}

LawCells cells_of_square(int rows, int columns, const std::function<double(double s, double t)>& density) {
  LawCells cells{rows, columns, {}, 0};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Integral cell = integrate_rectangle(
          [&](double s, double t) { return checked_density(density(s, t), s, t); }, double(row) / rows,
          double(row + 1) / rows, double(column) / columns, double(column + 1) / columns);
      cells.probabilities.push_back(cell.value);
      cells.error += cell.error;
    }
  }
  return cells;
}

LawCells cells_of_numbers(std::int64_t n, const std::function<double(std::int64_t i)>& probability) {
  if (n < 2 || n > 1 << 20) throw std::invalid_argument("a discrete law must have 2 .. 2^20 outcomes");
  LawCells cells{static_cast<int>(n), 1, {}, 0};
  for (std::int64_t i = 0; i < n; ++i) cells.probabilities.push_back(checked_density(probability(i), double(i), 0));
  return cells;
}

Finding detail::refuted_density(const Trial& trial, const std::string& why) { return refuted(trial, why); }

Finding test_counts(const Trial& trial, const LawCells& cells, const CountMore& count) {
  const double total = std::accumulate(cells.probabilities.begin(), cells.probabilities.end(), 0.0);
  check_trial(trial);
  if (cells.error > 1e-6)
    return undecided(trial, "the density cannot be integrated to 1e-6 (give a domain that it suits)");
  if (!(std::abs(total - 1) <= 1e-6 + cells.error)) {
    return refuted(trial, "the density integrates to " + std::to_string(total) + ", not to 1");
  }
  const Looks looks = looks_for(trial, cells.probabilities);
  try {
    return look_until_decided(trial, cells, looks, count);
  } catch (const BadDraw& bad) {
    return refuted(trial, bad.what());
  } catch (const NoMoreDraws& spent) {
    return undecided(trial, spent.what());
  } catch (const detail::ToldToEnd&) {
    return undecided(trial, told_to_end);
  }
}

}  // namespace fairlight
