#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <fairlight/stats/betting_test.h>
#include <fairlight/stats/domains.h>
#include <fairlight/stats/manifest.h>

namespace fairlight {

/// A grid of cells over a domain's square, with their probabilities under a density.
struct LawCells {
  int rows;
  int columns;
  std::vector<double> probabilities;
  double error;  ///< the quadrature's error bound for the sum of the probabilities

  /// The index of the cell that contains a point of the square. Throws std::out_of_range unless
  /// both coordinates are in [0,1].
  std::size_t index(const Eigen::Vector2d& place) const;
};

/// The checks for NaN and infinity below are compiled in the library, which never uses -ffast-math.
/// In templates that a user compiles with -ffast-math, the compiler could remove them.

/// Throws BadDraw unless both coordinates of draw `i` are in [0,1]; a NaN is not.
void check_place(std::uint64_t i, const Eigen::Vector2d& place);

/// Throws BadDraw unless the density at draw `i` is positive and finite.
void check_density_of_draw(std::uint64_t i, double density);

/// Returns the density's value. Throws std::domain_error, with the position (s, t), if it is
/// negative or not finite.
double checked_density(double value, double s, double t);

/// The probabilities of rows x columns cells, by quadrature of `density(s, t)` over the square.
/// Throws std::domain_error, with the position, if the density is negative or not finite.
LawCells cells_of_square(int rows, int columns, const std::function<double(double s, double t)>& density);

/// The probabilities of the cells, by quadrature of `pdf(point)` over the domain. An interval has
/// 128 cells. Other domains have 16 x 8; the 8 columns are eighths of a turn if t is an angle.
template <class Domain, class Pdf>
LawCells law_cells(const Domain& domain, const Pdf& pdf) {
  constexpr bool line = std::is_same_v<Domain, IntervalDomain>;
  constexpr int eighths = 8;
  return cells_of_square(line ? 128 : 16, line ? 1 : eighths,
                         [&](double s, double t) { return pdf(domain.at(s, t)) * domain.size(); });
}

/// One cell per integer, with its probability. Throws std::invalid_argument unless n is in 2 ..
/// 2^20.
LawCells cells_of_numbers(std::int64_t n, const std::function<double(std::int64_t i)>& probability);

template <class Pdf>
LawCells law_cells(const DiscreteDomain& domain, const Pdf& pdf) {
  return cells_of_numbers(domain.n, pdf);
}

/// Draws that many more samples and returns their counts per cell.
using CountMore = std::function<std::vector<std::uint64_t>(std::uint64_t draws)>;

/// Tests counts of draws against the probabilities of cells:
/// * the probabilities sum to 1 within 1e-6 and the quadrature's error;
/// * chi-square on all cells, both tails; the margin, a relative L2 distance, sets the most draws;
/// * the exact binomial law of each cell, which finds one wrong cell among many.
/// Each of the two statistical parts has half of alpha. Up to four looks share alpha and beta
/// equally; right laws mostly have their verdict by the second look, at 35 % of the draws.
/// Guarantee: asymptotic. Throws std::invalid_argument for a margin that needs more than 10^15
/// draws.
Finding test_counts(const Trial& trial, const LawCells& cells, const CountMore& count);

/// The tails of a cell's binomial law: the probabilities of at most and of at least `count` draws
/// in it. Both are 1 for a cell of probability 0 without draws.
struct CellTails {
  double too_few, too_many;
};
CellTails cell_tails(std::uint64_t count, double draws, double probability);

namespace detail {
/// Thrown to end a count when Trial::watch asks for it.
struct ToldToEnd {};

Finding refuted_density(const Trial& trial, const std::string& why);

/// The coordinates of a point in the square, or of another point in the same cell.
template <class Domain, class Point>
Eigen::Vector2d place_of_cell(const Domain& domain, const Point& x) {
  if constexpr (requires { domain.eighths(x); }) {
    return domain.eighths(x);
  } else {
    return domain.coordinates(x);
  }
}
}  // namespace detail

/// Tests that draws follow their density, and that the density is nonnegative, positive at every
/// draw, and integrates to 1 over the domain. `draw(i)` returns draw i, `pdf(point)` its density
/// with respect to the domain's measure.
template <class Domain, class Pdf, class Draw>
Finding test_law(const Trial& trial, const Domain& domain, const Pdf& pdf, Draw&& draw) {
  LawCells cells;
  try {
    cells = law_cells(domain, pdf);
  } catch (const std::domain_error& bad) {
    return detail::refuted_density(trial, bad.what());
  }
  std::uint64_t i = 0;  // continues from look to look
  double done = 0;
  return test_counts(trial, cells, [&](std::uint64_t draws) {
    std::vector<std::uint64_t> counts(cells.probabilities.size());
    for (const std::uint64_t end = i + draws; i < end; ++i) {
      if (i % 1024 == 1023) {
        // The fraction done of this look, which is mostly the last. It must not fall at a next
        // look.
        done = std::max(done, static_cast<double>(i) / static_cast<double>(end));
        if (!goes_on(trial, done)) throw detail::ToldToEnd();
      }
      const auto x = draw(i);
      const Eigen::Vector2d place = detail::place_of_cell(domain, x);
      check_place(i, place);  // first: a density may be a table of the domain's points
      check_density_of_draw(i, pdf(x));
      ++counts[cells.index(place)];
    }
    return counts;
  });
}

}  // namespace fairlight
