#include <set>
#include <stdexcept>
#include <type_traits>

#include <gtest/gtest.h>

#include <fairlight/render/strategy_table.h>

namespace fairlight {
namespace {

TEST(StrategyTable, FindsEveryStrategyByItsNameAndNoOther) {
  for_each_strategy_kind([]<class Strategy>(const StrategyTable<Strategy>& table) {
    std::set<std::string> names;
    std::set<Strategy> values;
    for (const StrategyRow<Strategy>& row : table.rows) {
      EXPECT_TRUE(names.insert(row.name).second) << row.name;
      EXPECT_TRUE(values.insert(row.value).second) << row.name;
      ASSERT_NE(find_strategy<Strategy>(row.name), nullptr) << row.name;
      EXPECT_EQ(find_strategy<Strategy>(row.name)->value, row.value) << row.name;
      EXPECT_STREQ(name_of(row.value), row.name);
    }
    for (const char* name : {"", "sideways", "TENT"}) EXPECT_EQ(find_strategy<Strategy>(name), nullptr) << name;
    EXPECT_THROW((void)name_of(static_cast<Strategy>(99)), std::invalid_argument);
  });
}

TEST(StrategyTable, HasEachKindOnce) {
  std::set<std::string> settings;
  for_each_strategy_kind([&](const auto& table) { EXPECT_TRUE(settings.insert(table.setting).second); });
  EXPECT_EQ(settings.size(), 8u);
}

TEST(OptionOf, IsTheSettingWithDashes) {
  EXPECT_EQ(option_of("light_sampling"), "--light-sampling");
  EXPECT_EQ(option_with(LightPoints::solid_angle), "--light-sampling solid-angle");
}

}  // namespace
}  // namespace fairlight
