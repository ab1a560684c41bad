#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace fairlight {

/// The count, mean vector and covariance of vector draws; mergeable like Moments.
/// Source   Chan, Golub, LeVeque 1979, with an outer product in place of the square
class VectorMoments {
 public:
  /// For draws of `dimension` components. Throws std::invalid_argument for a dimension below 1.
  explicit VectorMoments(Eigen::Index dimension);

  /// The moments of a block, one draw per row. Throws std::invalid_argument for a block without
  /// rows.
  static VectorMoments of(const Eigen::MatrixXd& draws);

  /// Throws std::invalid_argument when the dimensions differ.
  void merge(const VectorMoments& other);

  std::uint64_t count() const { return count_; }
  const Eigen::VectorXd& mean() const { return mean_; }
  /// The unbiased covariance of one draw. Throws std::logic_error with fewer than two draws.
  Eigen::MatrixXd covariance() const;

 private:
  std::uint64_t count_ = 0;
  Eigen::VectorXd mean_;
  Eigen::MatrixXd scatter_;  // sum of outer products of deviations
};

}  // namespace fairlight
