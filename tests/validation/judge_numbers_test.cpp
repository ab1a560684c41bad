#include <cmath>
#include <random>
#include <sstream>

#include <boost/math/distributions/binomial.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fairlight/stats/mean_test.h>
#include <fairlight/stats/seed.h>
#include <fairlight/stats/sequential_t_test.h>
#include <fairlight/validation/run/judge_numbers.h>

namespace fairlight {
namespace {

using ::testing::HasSubstr;

constexpr Interval unit{0, 1};

Trial trial_with(double alpha, double margin) { return {"judge", 1, alpha, 0.01, margin}; }

std::string bytes_of(const std::vector<double>& numbers) {
  return std::string(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
}

std::vector<double> uniform_numbers(std::size_t n, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<double> numbers(n);
  for (double& x : numbers) x = std::uniform_real_distribution<double>(0, 1)(generator);
  return numbers;
}

// The finding of `judge` about binary rows of so many columns.
template <class Judge>
Finding judged(const std::vector<double>& numbers, std::size_t columns, const Judge& judge) {
  std::istringstream in(bytes_of(numbers));
  NumberStream stream(in, NumberFormat::f64, columns);
  return judge(Numbers{stream});
}

Finding mean_of(const std::vector<double>& numbers, double mean, double margin, double alpha = 1e-6) {
  return judged(numbers, 1,
                [&](Numbers rows) { return judge_mean(trial_with(alpha, margin), rows, mean, 0.5, unit); });
}

void expect_same(const Finding& a, const Finding& b) {
  EXPECT_EQ(a.verdict, b.verdict);
  EXPECT_EQ(a.draws, b.draws);
  EXPECT_EQ(a.bias, b.bias);
  EXPECT_EQ(a.interval.lo, b.interval.lo);
  EXPECT_EQ(a.interval.hi, b.interval.hi);
}

TEST(JudgeNumbers, TakesTheDrawsOfTheTestOfMeans) {
  const std::uint64_t seed = fresh_seed();
  SCOPED_TRACE(seed_text(seed));
  const std::vector<double> numbers = uniform_numbers(1 << 18, seed);
  for (const double mean : {0.5, 0.55}) {
    std::size_t i = 0;
    const Finding expected =
        test_mean(trial_with(1e-6, 0.02), {mean, 0, 1, 0, 0.5}, [&] { return numbers.at(i++); });
    expect_same(mean_of(numbers, mean, 0.02), expected);
  }
}

TEST(JudgeNumbers, TakesTheDrawsOfStudentsTest) {
  const std::uint64_t seed = fresh_seed();
  SCOPED_TRACE(seed_text(seed));
  const std::vector<double> numbers = uniform_numbers(1 << 20, seed);
  const Trial trial = trial_with(1e-6, 0.02);
  std::size_t i = 0;
  const Finding expected =
      sequential_t_test(trial, 0.5, 0.5, one_channel([&](std::uint64_t) { return numbers.at(i++); }));
  expect_same(judged(numbers, 1, [&](Numbers rows) { return judge_mean(trial, rows, 0.5, 0.5, {}); }), expected);
}

TEST(JudgeNumbers, IsUndecidedWhereTheInputEnds) {
  const Finding finding = mean_of({0.5}, 0.5, 0.01);
  EXPECT_EQ(finding.verdict, Verdict::undecided);
  EXPECT_THAT(finding.note, HasSubstr("ended after 1 draws"));
  const auto student = [](Numbers rows) { return judge_mean(trial_with(1e-6, 0.01), rows, 0.5, 0.5, {}); };
  EXPECT_EQ(judged({0.5, 0.25}, 1, student).verdict, Verdict::undecided);
}

TEST(JudgeNumbers, ReadsNoMoreThanTheCap) {
  const std::vector<double> numbers(1000, 0.5);
  std::istringstream in(bytes_of(numbers));
  NumberStream stream(in, NumberFormat::f64, 1);
  const Finding finding = judge_mean(trial_with(1e-6, 1e-3), {stream, 100}, 0.5, 0.5, unit);
  EXPECT_EQ(finding.verdict, Verdict::undecided);
  EXPECT_THAT(finding.note, HasSubstr("largest number of draws, 100"));
  EXPECT_LE(stream.rows(), 100U);
}

TEST(JudgeNumbers, ABadDrawIsAFinding) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1.5, -0.1}) {
    std::vector<double> numbers = uniform_numbers(5000, 1);
    numbers[700] = bad;
    const Finding finding = mean_of(numbers, 0.5, 1e-3);
    EXPECT_EQ(finding.verdict, Verdict::biased) << bad;
    EXPECT_THAT(finding.note, HasSubstr("draw 700"));
    const auto agrees = [](Numbers rows) {
      return judge_agreement(trial_with(1e-6, 1e-3), rows, nullptr, 0.5, unit);
    };
    EXPECT_THAT(judged(numbers, 2, agrees).note, HasSubstr("draw 350")) << bad;
    const auto uniform = [](Numbers rows) { return judge_uniform(trial_with(1e-6, 0.05), rows); };
    EXPECT_THAT(judged(numbers, 1, uniform).note, HasSubstr("draw 700")) << bad;
  }
}

TEST(JudgeNumbers, OneIsNotInTheHalfOpenInterval) {
  const auto uniform = [](Numbers rows) { return judge_uniform(trial_with(1e-6, 0.05), rows); };
  EXPECT_EQ(judged({0.5, 1.0, 0.25, 0.75}, 2, uniform).verdict, Verdict::biased);
}

TEST(JudgeNumbers, RefusesColumnsThatDoNotFit) {
  const auto agrees = [](Numbers rows) { return judge_agreement(trial_with(1e-6, 0.1), rows, nullptr, {}, {}); };
  EXPECT_THROW(judged({0.5, 0.5}, 1, agrees), BadInput);
  const auto student = [](Numbers rows) { return judge_mean(trial_with(1e-6, 0.1), rows, 0.5, 0.5, {}); };
  EXPECT_THROW(judged({0.5, 0.5}, 2, student), BadInput);
}

// False alarms at alpha = 0.01 and misses at beta = 0.01 of a bias of the margin, each in 1500 runs
// through a stream, inside the binomial limit of level 1e-6.
TEST(JudgeNumbers, KeepsItsLevelAndItsMissRate) {
  constexpr int runs = 1500;
  constexpr double margin = 0.1;
  const std::uint64_t seed = fresh_seed();
  SCOPED_TRACE(seed_text(seed));
  int alarms = 0, misses = 0;
  for (std::uint64_t run = 0; run < runs; ++run) {
    const std::vector<double> numbers = uniform_numbers(8192, seed + run);
    alarms += mean_of(numbers, 0.5, margin, 0.01).verdict == Verdict::biased;
    const double off = run % 2 == 0 ? 0.55 : 0.45;  // the margin is 0.05
    misses += mean_of(numbers, off, margin, 0.01).verdict == Verdict::certified;
  }
  const boost::math::binomial law(runs, 0.01);
  EXPECT_GT(cdf(complement(law, std::max(alarms - 1, 0))), 1e-6) << alarms << " false alarms";
  EXPECT_GT(cdf(complement(law, std::max(misses - 1, 0))), 1e-6) << misses << " misses";
}

TEST(JudgeNumbers, CertifiesAndRefutesLaws) {
  const std::uint64_t seed = fresh_seed();
  SCOPED_TRACE(seed_text(seed));
  std::vector<double> numbers = uniform_numbers(1 << 18, seed);
  const IntervalLaw half{{0, 0.5, 0.75, 1}, {0.5, 0.25, 0.25}};
  const auto law = [&](Numbers rows) { return judge_law(trial_with(1e-6, 0.05), rows, half); };
  const auto uniform = [](Numbers rows) { return judge_uniform(trial_with(1e-6, 0.05), rows); };
  const auto agrees = [](Numbers rows) { return judge_agreement(trial_with(1e-6, 0.05), rows, nullptr, {}, unit); };
  EXPECT_EQ(judged(numbers, 1, law).verdict, Verdict::certified);
  EXPECT_EQ(judged(numbers, 1, uniform).verdict, Verdict::certified);
  EXPECT_EQ(judged(numbers, 3, uniform).verdict, Verdict::certified);
  EXPECT_EQ(judged(numbers, 2, agrees).verdict, Verdict::certified);
  for (std::size_t i = 0; i < numbers.size(); i += 2) numbers[i] *= numbers[i];
  EXPECT_EQ(judged(numbers, 1, law).verdict, Verdict::biased);
  EXPECT_EQ(judged(numbers, 1, uniform).verdict, Verdict::biased);
  EXPECT_EQ(judged(numbers, 2, uniform).verdict, Verdict::biased);
  EXPECT_EQ(judged(numbers, 2, agrees).verdict, Verdict::biased);
}

}  // namespace
}  // namespace fairlight
