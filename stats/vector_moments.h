#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace fairlight {

/// Count, mean vector and covariance of vector draws, mergeable as Moments are.
/// Source: Chan, Golub, LeVeque 1979, with an outer product for the square.
class VectorMoments {
 public:
  /// For draws of `dimension` components; at least 1, or throws std::invalid_argument.
  explicit VectorMoments(Eigen::Index dimension);

  /// The moments of a block, one draw a row. At least one row; throws std::invalid_argument otherwise.
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
