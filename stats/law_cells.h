#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <fairlight/stats/domains.h>

namespace fairlight {

/// A density on the unit square [0,1]^2, dimensionless. For a domain: its pdf at at(s, t), times
/// size().
using SquareDensity = std::function<double(double s, double t)>;

/// Where a quadrature over the unit square divides first: at the jumps and poles that the caller
/// names, and at quantiles of pilot draws, without which it could miss a narrow lobe.
struct Landmarks {
  std::vector<double> s, t;  ///< sorted, in (0,1)
  bool line = false;         ///< whether the density does not depend on t
};

/// Adds 15 quantiles of the pilot's coordinates to the landmarks, and steps into both tails.
Landmarks with_pilot(Landmarks landmarks, std::span<const Eigen::Vector2d> pilot);

/// Thrown for a density whose quadrature does not reach 1e-6.
struct CannotIntegrate : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline constexpr const char* cannot_integrate =
    "the density cannot be integrated to 1e-6 (say where it jumps or has poles: cut_at)";

/// Cells of the unit square, with their probabilities under a density. Without edges, the cells
/// are a grid of rows x columns. With edges, each row has columns of its own.
struct LawCells {
  int rows;
  int columns;
  std::vector<double> probabilities;
  double error;                                     ///< the quadrature's error bound for their sum
  std::vector<double> row_edges{};                  ///< inner edges in s, sorted
  std::vector<std::vector<double>> column_edges{};  ///< of each row, inner edges in t, sorted
  std::vector<std::size_t> first_of_row{};          ///< the index of each row's first cell
  bool even_columns = false;  ///< whether all rows have the even columns, so that t may be rounded to them
  bool each_alone = false;    ///< whether each cell must be certified alone: outcomes, or a table
  bool lossy = false;         ///< whether the last cell is that of lost draws

  /// The index of the cell that contains a point of the square. Throws std::out_of_range unless
  /// both coordinates are in [0,1].
  std::size_t index(const Eigen::Vector2d& place) const;
};

/// Returns the density's value. Throws std::domain_error, with the position (s, t), if it is
/// negative or not finite.
double checked_density(double value, double s, double t);

/// Cells that follow the domain and the law: 16 rows and 8 columns of equal area (128 rows on a
/// line), of which those with more than 1.5 shares of the mass are divided at its quantiles. Their
/// probabilities are by adaptive quadrature. Throws std::domain_error, with the position, if the
/// density is negative or not finite.
LawCells cells_of_square(const SquareDensity& density, const Landmarks& landmarks = {});

/// One cell per integer, with its probability. Throws std::invalid_argument unless n is in 2 ..
/// 2^20.
LawCells cells_of_numbers(std::int64_t n, const std::function<double(std::int64_t i)>& probability);

/// A law that is given as the probabilities of rows x columns cells of equal area of a domain, row
/// by row (s, then t). Within a cell anything is allowed.
struct LawTable {
  int rows, columns;
  std::vector<double> probabilities;
};

/// Adds a cell for the lost draws, unless their share is 0.
LawCells with_lost(LawCells cells, double share);

/// Throws std::invalid_argument unless there are rows x columns probabilities, at least two.
LawCells cells_of_table(const LawTable& table);

}  // namespace fairlight
