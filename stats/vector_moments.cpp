#include <stdexcept>

#include <fairlight/stats/vector_moments.h>

namespace fairlight {

VectorMoments::VectorMoments(Eigen::Index dimension) {
  if (dimension < 1) throw std::invalid_argument("vector draws need at least one component");
  mean_ = Eigen::VectorXd::Zero(dimension);
  scatter_ = Eigen::MatrixXd::Zero(dimension, dimension);
}

VectorMoments VectorMoments::of(const Eigen::MatrixXd& draws) {
  if (draws.rows() < 1) throw std::invalid_argument("a block must hold at least one draw");
  VectorMoments moments(draws.cols());
  moments.count_ = static_cast<std::uint64_t>(draws.rows());
  moments.mean_ = draws.colwise().mean();
  const Eigen::MatrixXd deviations = draws.rowwise() - moments.mean_.transpose();
  moments.scatter_ = deviations.transpose() * deviations;
  return moments;
}

void VectorMoments::merge(const VectorMoments& other) {
  if (other.mean_.size() != mean_.size())
    throw std::invalid_argument("moments of different dimensions cannot be merged");
  if (other.count_ == 0) return;
  const auto a = static_cast<double>(count_);
  const auto b = static_cast<double>(other.count_);
  const Eigen::VectorXd shift = other.mean_ - mean_;
  scatter_ += other.scatter_ + shift * shift.transpose() * (a * (b / (a + b)));
  mean_ += shift * (b / (a + b));
  count_ += other.count_;
}

Eigen::MatrixXd VectorMoments::covariance() const {
  if (count_ < 2) throw std::logic_error("a covariance needs at least two draws");
  return scatter_ / static_cast<double>(count_ - 1);
}

}  // namespace fairlight
