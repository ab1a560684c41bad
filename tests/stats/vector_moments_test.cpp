#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/stats/vector_moments.h>

namespace fairlight {
namespace {

TEST(VectorMoments, OfThreePairs) {
  const Eigen::MatrixXd draws{{1, 0}, {2, 3}, {6, 0}};
  const VectorMoments moments = VectorMoments::of(draws);
  EXPECT_EQ(moments.count(), 3u);
  EXPECT_EQ(moments.mean(), Eigen::Vector2d(3, 1));
  const Eigen::Matrix2d covariance{{7, -1.5}, {-1.5, 3}};
  EXPECT_TRUE(moments.covariance().isApprox(covariance, 1e-15)) << moments.covariance();
}

RC_GTEST_PROP(VectorMoments, MergingIsCountingTogether, ()) {
  const auto rows = *rc::gen::inRange(2, 30);
  const auto cut = *rc::gen::inRange(1, rows);
  Eigen::MatrixXd draws(rows, 3);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < 3; ++j) draws(i, j) = *rc::gen::inRange(-1000, 1000);
  }
  VectorMoments merged = VectorMoments::of(draws.topRows(cut));
  merged.merge(VectorMoments::of(draws.bottomRows(rows - cut)));
  const VectorMoments whole = VectorMoments::of(draws);
  RC_ASSERT((merged.mean() - whole.mean()).norm() <= 1e-10);
  RC_ASSERT((merged.covariance() - whole.covariance()).norm() <= 1e-8 * (1 + whole.covariance().norm()));
}

TEST(VectorMoments, RefuseWhatHasNoMeaning) {
  EXPECT_THROW(VectorMoments(0), std::invalid_argument);
  EXPECT_THROW(VectorMoments::of(Eigen::MatrixXd(0, 2)), std::invalid_argument);
  EXPECT_THROW((void)VectorMoments::of(Eigen::MatrixXd::Zero(1, 2)).covariance(), std::logic_error);
  VectorMoments two(2);
  EXPECT_THROW(two.merge(VectorMoments(3)), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight
