#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <fairlight/stats/follows.h>
#include <fairlight/stats/mean_test.h>

namespace fairlight {

/// Cells of about equal mass, and ranks, learnt from the draws of a pilot: quantiles in s and, in
/// each row, quantiles in t. A place that the pilot meets again and again has a cell of its own.
class PilotCells {
 public:
  /// 8 rows of 4 columns, or 32 rows on a line. Throws std::invalid_argument for an empty pilot.
  PilotCells(std::span<const Eigen::Vector2d> pilot, bool line);

  std::size_t size() const { return first_.back(); }
  std::size_t index(const Eigen::Vector2d& place) const;
  /// Both coordinates as ranks in the pilot, in [0,1].
  Eigen::Vector2d ranks(const Eigen::Vector2d& place) const;

 private:
  std::vector<double> rows_;                  // edges, from 0 to beyond 1
  std::vector<std::vector<double>> columns_;  // of each row
  std::vector<std::size_t> first_;            // the index of each row's first cell, and that after the last
};

/// The place of draw i in the unit square of a domain; none if it is lost.
using PlaceOfDraw = std::function<std::optional<Eigen::Vector2d>(std::uint64_t)>;

/// Tests whether two samplers follow the same law, without a density, by means of differences of
/// pairs of draws, which all are 0 for equal laws:
/// * for each of 32 cells c that a pilot has learnt, 1[a in c] - 1[b in c];
/// * for each of the 15 cosine moments of ranks, its difference (3 on a line);
/// * f(a) - f(b) for a witness f, the sign of the difference of counts so far, in finer cells.
/// Biased: exact at any stopping time, by Ville's inequality. Certified, at the miss rate, is only:
/// P(a in c) and P(b in c) differ by less than margin sqrt(P(c)) in each cell, and each moment by
/// less than the margin. Source: Shekhar and Ramdas 2023, "Nonparametric two-sample testing by
/// betting".
Finding test_same_law(const Trial& trial, const PlaceOfDraw& a, const PlaceOfDraw& b, bool line);

}  // namespace fairlight
