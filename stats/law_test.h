#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <fairlight/stats/betting_test.h>
#include <fairlight/stats/domain_options.h>
#include <fairlight/stats/domains.h>
#include <fairlight/stats/law_cells.h>
#include <fairlight/stats/manifest.h>
#include <fairlight/stats/outcomes.h>

namespace fairlight {

/// The checks for NaN and infinity below are compiled in the library, which never uses -ffast-math.
/// In templates that a user compiles with -ffast-math, the compiler could remove them.

/// Throws BadDraw unless both coordinates of draw `i` are in [0,1]; a NaN is not.
void check_place(std::uint64_t i, const Eigen::Vector2d& place);

/// Whether a coordinate of a place is outside [0,1]; a NaN or an infinity is neither out nor in.
bool is_outside(const Eigen::Vector2d& place);

/// Throws BadDraw for a lost draw unless the domain says that some are.
void check_lost(std::uint64_t i, bool lossy);

/// Throws BadDraw unless the density at draw `i` is positive and finite.
void check_density_of_draw(std::uint64_t i, double density);

/// The number of draws that show where a law has its mass. They are not counted.
inline constexpr std::uint64_t pilot_draws = 256;

/// Throws std::domain_error unless a domain's size is positive and finite.
void check_size(double size);

namespace detail {
template <class Domain>
void check_size_of(const Domain& domain) {
  if constexpr (requires { domain.jacobian(0.5, 0.5); }) {
    check_size(domain.scale);
  } else {
    check_size(domain.size());
  }
}
}  // namespace detail

/// The cells of a domain and of `pdf(point)`, for the place of `pilot` draws if there are any.
template <class Domain, class Pdf>
LawCells law_cells(const Domain& domain, const Pdf& pdf, std::span<const Eigen::Vector2d> pilot = {}) {
  return with_lost(
      cells_of_square(detail::density_on_square(domain, pdf), with_pilot(detail::landmarks_of(domain), pilot)),
      detail::lost_share(domain));
}

template <class Domain, class Pdf>
requires std::is_base_of_v<DiscreteDomain, Domain> LawCells law_cells(const Domain& domain, const Pdf& pdf,
                                                                      std::span<const Eigen::Vector2d> = {}) {
  return with_lost(cells_of_numbers(domain.n, pdf), detail::lost_share(domain));
}

/// Draws that many more samples and returns their counts per cell.
using CountMore = std::function<std::vector<std::uint64_t>(std::uint64_t draws)>;

/// Tests counts of draws against the probabilities of cells:
/// * the probabilities sum to 1 within 1e-6 and the quadrature's error;
/// * chi-square on groups of cells, both tails; the margin, a relative L2 distance over these
///   groups, sets the most draws;
/// * the exact binomial law of each cell, which finds one wrong cell among many. Outcomes and cells
///   of tables must also be certified so.
/// Each of the two statistical parts has half of alpha. Up to four looks share alpha and beta
/// equally. Guarantee: asymptotic; exact where binomial laws alone decide. Throws
/// std::invalid_argument for a margin that needs more than 10^15 draws.
Finding test_counts(const Trial& trial, const LawCells& cells, const CountMore& count);

namespace detail {
/// Thrown to end a count when Trial::watch asks for it.
struct ToldToEnd {};

Finding refuted_density(const Trial& trial, const std::string& why);

/// The finding of a test; of a density that is none, and of draws that are none, that they are.
Finding guarded(const Trial& trial, const std::function<Finding()>& test);

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

/// Counts draws in cells, for test_counts. Asks `check(i, x)` of each draw that lies in the domain.
template <class Domain, class Draw, class Check>
class CellCounter {
 public:
  CellCounter(const Trial& trial, const LawCells& cells, const Domain& domain, Draw& draw, const Check& check,
              std::uint64_t first)
      : trial_(trial), cells_(cells), domain_(domain), draw_(draw), check_(check), first_(first), i_(first) {}

  std::vector<std::uint64_t> operator()(std::uint64_t draws) {
    std::vector<std::uint64_t> counts(cells_.probabilities.size());
    for (const std::uint64_t end = i_ + draws; i_ < end; ++i_) {
      if (i_ % 1024 == 1023) {
        // The fraction done of this look, which is mostly the last. It must not fall at a next
        // look.
        done_ = std::max(done_, static_cast<double>(i_ - first_) / static_cast<double>(end - first_));
        if (!goes_on(trial_, done_)) throw detail::ToldToEnd();
      }
      ++counts[cell_of(draw_(i_))];
    }
    return counts;
  }

 private:
  template <class Point>
  std::size_t cell_of(const Point& x) const {
    if constexpr (detail::is_optional<Point>) {
      return x ? cell_of(*x) : lost_cell(i_);
    } else {
      const Eigen::Vector2d place =
          cells_.even_columns ? detail::place_of_cell(domain_, x) : domain_.coordinates(x);
      if (cells_.lossy && is_outside(place)) return lost_cell(i_);
      check_place(i_, place);  // first: a density may be a table of the domain's points
      check_(i_, x);
      return cells_.index(place);
    }
  }

  std::size_t lost_cell(std::uint64_t i) const {
    check_lost(i, cells_.lossy);
    return cells_.probabilities.size() - 1;
  }

  const Trial& trial_;
  const LawCells& cells_;
  const Domain& domain_;
  Draw& draw_;
  const Check& check_;
  std::uint64_t first_, i_;  // continue from look to look
  double done_ = 0;
};

/// The places of the draws 0 .. pilot_draws - 1 that lie in the domain.
template <class Domain, class Draw>
std::vector<Eigen::Vector2d> pilot_places(const Domain& domain, Draw& draw) {
  std::vector<Eigen::Vector2d> places;
  const auto add = [&](std::uint64_t i, const auto& x) {
    const Eigen::Vector2d place = domain.coordinates(x);
    if (detail::lost_share(domain) > 0 && is_outside(place)) return;
    check_place(i, place);
    places.push_back(place);
  };
  for (std::uint64_t i = 0; i < pilot_draws; ++i) {
    const auto x = draw(i);
    if constexpr (detail::is_optional<std::remove_cvref_t<decltype(x)>>) {
      if (x) add(i, *x);
    } else {
      add(i, x);
    }
  }
  return places;
}

/// Tests that draws follow their density, and that the density is nonnegative, positive at every
/// draw, and integrates to 1 over the domain, or to 1 - lost. `draw(i)` returns draw i,
/// `pdf(point)` its density with respect to the domain's measure, which is asked only in the domain.
/// The first 256 draws are a pilot, which shows the quadrature where to look.
template <class Domain, class Pdf, class Draw>
Finding test_law(const Trial& trial, const Domain& domain, const Pdf& pdf, Draw&& draw) {
  return detail::guarded(trial, [&] {
    detail::check_size_of(domain);
    const bool numbers = std::is_base_of_v<DiscreteDomain, Domain>;
    const auto places = numbers ? std::vector<Eigen::Vector2d>{} : pilot_places(domain, draw);
    const LawCells cells = law_cells(domain, pdf, places);
    const auto check = [&](std::uint64_t i, const auto& x) { check_density_of_draw(i, pdf(x)); };
    return test_counts(trial, cells,
                       CellCounter<Domain, std::remove_reference_t<Draw>, decltype(check)>(
                           trial, cells, domain, draw, check, numbers ? 0 : pilot_draws));
  });
}

/// The same for a law that is given as the probabilities of the cells of its domain.
template <class Domain, class Draw>
Finding test_law(const Trial& trial, const Domain& domain, const LawTable& table, Draw&& draw) {
  return detail::guarded(trial, [&] {
    detail::check_size_of(domain);
    const LawCells cells = with_lost(cells_of_table(table), detail::lost_share(domain));
    const auto check = [](std::uint64_t, const auto&) {};
    return test_counts(
        trial, cells,
        CellCounter<Domain, std::remove_reference_t<Draw>, decltype(check)>(trial, cells, domain, draw, check, 0));
  });
}

}  // namespace fairlight
