#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>

#include <fairlight/stats/chi_square.h>

namespace fairlight {
namespace {

constexpr double least_expected = 80;

struct Cell {
  double count = 0;
  double expected = 0;
};

std::vector<Cell> pool(std::span<const std::uint64_t> counts, std::span<const double> probabilities, double draws) {
  std::vector<Cell> cells;
  std::size_t i = 0;
  for (const std::size_t end : ends_of_groups(probabilities, draws)) {
    Cell& cell = cells.emplace_back();
    for (; i < end; ++i) {
      cell.count += static_cast<double>(counts[i]);
      cell.expected += draws * probabilities[i];
    }
  }
  return cells;
}

void check_input(std::span<const std::uint64_t> counts, std::span<const double> probabilities) {
  if (counts.size() != probabilities.size()) {
    throw std::invalid_argument("a histogram and its probabilities must have as many cells as each other");
  }
  if (counts.empty()) throw std::invalid_argument("a histogram without cells (there is nothing to compare)");
  if (std::all_of(counts.begin(), counts.end(), [](std::uint64_t count) { return count == 0; })) {
    throw std::invalid_argument("an empty histogram (nothing was drawn, or nothing was counted)");
  }
  double sum = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (!(probabilities[i] >= 0)) throw std::invalid_argument("a cell's probability is negative or not a number");
    if (probabilities[i] == 0 && counts[i] != 0) {
      throw std::invalid_argument(
          "a cell of probability zero was hit (the density has a hole, or the sampler strays)");
    }
    sum += probabilities[i];
  }
  if (!(std::abs(sum - 1) <= 1e-6)) {
    throw std::invalid_argument("the cells' probabilities sum to " + std::to_string(sum) + " (a law sums to 1)");
  }
}

}  // namespace

ChiSquare chi_square(std::span<const std::uint64_t> counts, std::span<const double> probabilities) {
  check_input(counts, probabilities);
  const auto draws = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
  const std::vector<Cell> cells = pool(counts, probabilities, draws);
  if (cells.size() < 2) throw TooFewDraws("too few draws for two cells of 80 expected (draw more, or merge cells)");
  ChiSquare result{};
  for (const Cell& cell : cells) {
    const double deviation = cell.count - cell.expected;
    result.statistic += deviation * deviation / cell.expected;
  }
  result.degrees = static_cast<double>(cells.size() - 1);
  const boost::math::chi_squared law(result.degrees);
  result.too_far = cdf(complement(law, result.statistic));
  result.too_near = cdf(law, result.statistic);
  return result;
}

std::vector<std::size_t> ends_of_groups(std::span<const double> probabilities, double draws) {
  std::vector<std::size_t> ends;
  double expected = 0;
  for (std::size_t i = 0; i < probabilities.size(); ++i) {
    expected += draws * probabilities[i];
    if (expected < least_expected) continue;
    ends.push_back(i + 1);
    expected = 0;
  }
  // The last group takes the remaining cells.
  if (!ends.empty()) ends.back() = probabilities.size();
  return ends;
}

std::uint64_t draws_to_tell_apart(std::uint64_t cells, double distance, double alpha, double beta) {
  const auto degrees = static_cast<double>(cells - 1);
  const double critical = quantile(complement(boost::math::chi_squared(degrees), alpha / 2));
  const double noncentrality = boost::math::non_central_chi_squared::find_non_centrality(degrees, critical, beta);
  const double floor_of_cells = 2 * least_expected * static_cast<double>(cells);
  const double draws = std::ceil(std::max(noncentrality / (distance * distance), floor_of_cells));
  if (!(draws < 1e15))
    throw std::invalid_argument("the distance asks for more than 10^15 draws (give a larger one)");
  return static_cast<std::uint64_t>(draws);
}

Verdict judge(const ChiSquare& result, std::uint64_t draws, double distance, double alpha, double beta) {
  // With few cells the statistic is discrete and often takes its least value, so a good fit is no
  // sign of a fault.
  constexpr double fewest_degrees = 10;
  const bool too_near = result.degrees >= fewest_degrees && result.too_near < alpha / 2;
  if (result.too_far < alpha / 2 || too_near) return Verdict::biased;
  const double noncentrality = static_cast<double>(draws) * distance * distance;
  const boost::math::non_central_chi_squared alternative(result.degrees, noncentrality);
  return cdf(alternative, result.statistic) <= beta ? Verdict::certified : Verdict::undecided;
}

}  // namespace fairlight
