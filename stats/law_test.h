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

/// A grid of cells over a domain's square, with the probabilities that a density gives them.
struct LawCells {
  int rows;
  int columns;
  std::vector<double> probabilities;
  double error;  ///< of their sum, as the quadrature states it

  /// The cell of a place. Throws std::out_of_range unless both of its coordinates are in [0,1].
  std::size_t index(const Eigen::Vector2d& place) const;
};

/// What is decided about numbers that may be NaN or infinite is decided in the library: it is never compiled with
/// -ffast-math, which would leave such decisions out of templates that a user compiles with it.

/// Throws BadDraw unless both coordinates of draw `i` are in [0,1]. A NaN is not.
void check_place(std::uint64_t i, const Eigen::Vector2d& place);

/// Throws BadDraw unless the density where draw `i` fell is positive and finite.
void check_density_of_draw(std::uint64_t i, double density);

/// A density's value, as it is. Throws std::domain_error where it is negative or not finite, saying where.
double checked_density(double value, double s, double t);

/// The probabilities of rows x columns cells, by quadrature of `density(s, t)` over the square. Throws std::domain_error where
/// that is negative or not finite, saying where.
LawCells cells_of_square(int rows, int columns, const std::function<double(double s, double t)>& density);

/// The cells' probabilities, by quadrature of `pdf(point)` over the domain: 16 x 8 cells, eighths of a turn where it has one, or 128 of an
/// interval.
template <class Domain, class Pdf>
LawCells law_cells(const Domain& domain, const Pdf& pdf) {
  constexpr bool line = std::is_same_v<Domain, IntervalDomain>;
  constexpr int eighths = 8;
  return cells_of_square(line ? 128 : 16, line ? 1 : eighths,
                         [&](double s, double t) { return pdf(domain.at(s, t)) * domain.size(); });
}

/// One cell a number, whose probability is read off; 2 to 2^20 of them, else std::invalid_argument.
LawCells cells_of_numbers(std::int64_t n, const std::function<double(std::int64_t i)>& probability);

template <class Pdf>
LawCells law_cells(const DiscreteDomain& domain, const Pdf& pdf) {
  return cells_of_numbers(domain.n, pdf);
}

/// The counts of so many draws more.
using CountMore = std::function<std::vector<std::uint64_t>(std::uint64_t draws)>;

/// Counts against cells.
///  * the probabilities sum to one within 1e-6 and the quadrature's error;
///  * chi-square on all cells, both tails, with at most as many draws as the margin (a relative L2 distance) asks for;
///  * the exact binomial law of every cell, so that one wrong cell among many is seen.
/// There are up to four looks, which share alpha and beta evenly; right laws mostly have their verdict by the second, a third of the way. Each
/// statistical part has half of alpha. Guarantee: asymptotic, as chi-square is. Throws std::invalid_argument for a margin that asks for
/// more than 10^15 draws.
Finding test_counts(const Trial& trial, const LawCells& cells, const CountMore& count);

/// The tails of a cell's binomial law: the probabilities of so few draws in it, and of so many. Both are 1 for a cell that
/// cannot be hit and is not.
struct CellTails {
  double too_few, too_many;
};
CellTails cell_tails(std::uint64_t count, double draws, double probability);

namespace detail {
/// Ends a count that was told to end.
struct ToldToEnd {};

Finding refuted_density(const Trial& trial, const std::string& why);

/// A point's place in the square, or one in the same cell.
template <class Domain, class Point>
Eigen::Vector2d place_of_cell(const Domain& domain, const Point& x) {
  if constexpr (requires { domain.eighths(x); }) {
    return domain.eighths(x);
  } else {
    return domain.coordinates(x);
  }
}
}  // namespace detail

/// Draws follow their density, which is nowhere negative, is positive where they fall and integrates to one over the domain.
/// `draw(i)` gives draw i, `pdf(point)` its density against the domain's measure.
template <class Domain, class Pdf, class Draw>
Finding test_law(const Trial& trial, const Domain& domain, const Pdf& pdf, Draw&& draw) {
  LawCells cells;
  try {
    cells = law_cells(domain, pdf);
  } catch (const std::domain_error& bad) {
    return detail::refuted_density(trial, bad.what());
  }
  std::uint64_t i = 0;  // runs on over the looks
  double done = 0;
  return test_counts(trial, cells, [&](std::uint64_t draws) {
    std::vector<std::uint64_t> counts(cells.probabilities.size());
    for (const std::uint64_t end = i + draws; i < end; ++i) {
      if (i % 1024 == 1023) {
        // Of this look, which is mostly the last; it does not fall where there is another.
        done = std::max(done, static_cast<double>(i) / static_cast<double>(end));
        if (!goes_on(trial, done)) throw detail::ToldToEnd();
      }
      const auto x = draw(i);
      check_density_of_draw(i, pdf(x));
      const Eigen::Vector2d place = detail::place_of_cell(domain, x);
      check_place(i, place);
      ++counts[cells.index(place)];
    }
    return counts;
  });
}

}  // namespace fairlight
