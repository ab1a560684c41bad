#pragma once

#include <array>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include <fairlight/estimators/concepts.h>

namespace fairlight {

/// The point u of cell i, where n cells divide [0,1). If the quotient rounds to 1, returns the
/// largest number below 1.
template <class Real>
Real in_cell(int i, int n, Real u) {
  const Real place = (rounded<Real>(i) + u) / rounded<Real>(n);
  return select(place < Real(1), place, Real(Real(1) - Real(ulp<Real> / 2)));
}

/// The mean of an estimator over a jittered grid: its first two numbers fall once into each cell of
/// the unit square; the others are unstratified. One draw is the whole grid. The terms are not
/// draws, as they depend on their cells.
/// Formula  1/(columns rows) sum over cells (i, j) of F((i + u)/columns, (j + v)/rows, ...)
/// Domain   columns and rows at least 1 (throws std::invalid_argument otherwise)
/// Random   the dimensions of the estimator, for each cell
/// Bound    the estimator's
/// Source   Cook 1986, "Stochastic sampling in computer graphics"; Cochran 1977, chapter 5
template <class Inner>
class StratifiedMean {
 public:
  using Scalar = typename Inner::Scalar;

  StratifiedMean(Inner inner, int columns, int rows) : inner_(std::move(inner)), columns_(columns), rows_(rows) {
    if (columns < 1 || rows < 1) throw std::invalid_argument("a grid without cells (give columns and rows)");
  }

  template <UniformSource<Scalar> Source>
  auto estimate(Source& source) const {
    using Value = std::remove_cvref_t<decltype(inner_.estimate(source))>;
    Value sum = zero<Value>();
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        Cell<Source> cell{source, {column, row}, {columns_, rows_}};
        sum += inner_.estimate(cell);
        source = cell.numbers;
      }
    }
    return Value(sum / rounded<Scalar>(static_cast<double>(columns_) * rows_));
  }

  Bound bound() const { return inner_.bound(); }

 private:
  // The numbers of one cell; the first two fall into the cell. It owns its source, so a copy of it
  // repeats the numbers.
  template <class Source>
  struct Cell {
    Source numbers;
    std::array<int, 2> place, of;
    std::size_t used = 0;

    Scalar next() {
      const Scalar u = numbers.next();
      if (used == 2) return u;
      const std::size_t dimension = used++;
      return in_cell(place[dimension], of[dimension], u);
    }
  };

  Inner inner_;
  int columns_, rows_;
};

}  // namespace fairlight
