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
    for_each_unit(50, threads, [&](int unit) { ++runs[static_cast<std::size_t>(unit)]; });
    EXPECT_EQ(runs, std::vector<int>(50, 1)) << threads << " threads";
  }
}

TEST(ForEachUnit, DoesNothingForNoUnits) {
  for_each_unit(0, 4, [](int) { FAIL(); });
}

TEST(ForEachUnit, ReportsTheFirstFailureAndStops) {
  try {
    for_each_unit(1, 3, [](int unit) { throw std::runtime_error("unit " + std::to_string(unit)); });
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "unit 0");
  }
}

TEST(ForEachUnit, RefusesNoThreads) {
  EXPECT_THROW(for_each_unit(3, 0, [](int) {}), std::invalid_argument);
}

TEST(HardwareThreads, AreAtLeastOne) { EXPECT_GE(hardware_threads(), 1); }

}  // namespace
}  // namespace fairlight
