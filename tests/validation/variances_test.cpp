#include <gtest/gtest.h>

#include <fairlight/validation/variances.h>

namespace fairlight {
namespace {

const Trial trial{"variances_test", 1, 1e-6, 0.01, 0.1};

// 0 or 1, of variance 1/4.
const Contender coin{"a coin", [](PhiloxStream<double>& source) { return source.next() < 0.5 ? 0.0 : 1.0; }, 0, 1};

TEST(MeanOf, AveragesItsDraws) {
  PhiloxStream<double> source(StreamKey(1, "mean"), 0, 0);
  const Contender ramp{"a ramp", [n = 0.0](PhiloxStream<double>&) mutable { return n++; }, 0, 10};
  EXPECT_EQ(mean_of(4, ramp).draw(source), (0 + 1 + 2 + 3) / 4.0);
  EXPECT_EQ(mean_of(4, ramp).name, "the mean of 4 draws of a ramp");
}

TEST(CheckVariances, CertifiesTheRatioAndFindsALargerOne) {
  EXPECT_EQ(check_variances(trial, 0.25, mean_of(4, coin), coin).verdict, Verdict::certified);
  EXPECT_EQ(check_variances(trial, 0.2, mean_of(4, coin), coin).verdict, Verdict::biased);
  EXPECT_EQ(check_variances(trial, 1, coin, coin).verdict, Verdict::certified);
}

TEST(CheckVariances, SaysTheRatioAndItsInterval) {
  const Finding finding = check_variances(trial, 0.5, mean_of(2, coin), coin);
  EXPECT_TRUE(finding.note.starts_with("variance ratio 0.")) << finding.note;
  EXPECT_LT(0.5 * (1 + finding.interval.lo), 0.5);
  EXPECT_GT(0.5 * (1 + finding.interval.hi), 0.5);
}

TEST(CheckVariances, NamesADrawOutOfItsRange) {
  const Contender wrong{"wrong", [](PhiloxStream<double>&) { return 2.0; }, 0, 1};
  const Finding finding = check_variances(trial, 1, wrong, coin);
  EXPECT_EQ(finding.verdict, Verdict::biased);
  EXPECT_NE(finding.note.find("is 2 "), std::string::npos) << finding.note;
}

}  // namespace
}  // namespace fairlight
