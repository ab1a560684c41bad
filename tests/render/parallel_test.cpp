#include <latch>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <fairlight/render/parallel.h>

namespace fairlight {
namespace {

TEST(ForEachUnit, RunsEachUnitOnce) {
  for (int threads : {1, 2, 7, 100}) {
    std::vector<int> runs(50);
    for_each_unit(50, threads, [&](std::size_t unit) { ++runs[unit]; });
    EXPECT_EQ(runs, std::vector<int>(50, 1)) << threads << " threads";
  }
}

TEST(ForEachUnit, DoesNothingForNoUnits) {
  for_each_unit(0, 4, [](std::size_t) { FAIL(); });
}

// Two units fail at once, whichever is noticed first.
TEST(ForEachUnit, ReportsTheFailureOfTheLowestUnit) {
  for (int time = 0; time < 64; ++time) {
    std::latch both(2);
    try {
      for_each_unit(2, 2, [&](std::size_t unit) {
        both.arrive_and_wait();
        throw std::runtime_error("unit " + std::to_string(unit));
      });
      FAIL();
    } catch (const std::runtime_error& error) {
      ASSERT_STREQ(error.what(), "unit 0");
    }
  }
}

TEST(ForEachUnit, BeginsNoUnitAfterAFailure) {
  std::vector<std::size_t> begun;
  const auto fail_at_two = [&](std::size_t unit) {
    begun.push_back(unit);
    if (unit == 2) throw std::runtime_error("unit 2");
  };
  EXPECT_THROW(for_each_unit(50, 1, fail_at_two), std::runtime_error);
  EXPECT_EQ(begun, (std::vector<std::size_t>{0, 1, 2}));
}

TEST(ForEachUnit, ReportsTheFractionDone) {
  std::vector<double> told;
  for_each_unit(
      4, 2, [](std::size_t) {}, [&](double done) { told.push_back(done); });
  EXPECT_EQ(told, (std::vector<double>{0.25, 0.5, 0.75, 1}));
}

TEST(ForEachUnit, RefusesNoThreads) {
  EXPECT_THROW(for_each_unit(3, 0, [](std::size_t) {}), std::invalid_argument);
}

TEST(HardwareThreads, AreAtLeastOne) { EXPECT_GE(hardware_threads(), 1); }

}  // namespace
}  // namespace fairlight
