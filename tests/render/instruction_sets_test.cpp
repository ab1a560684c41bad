#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/render/instruction_sets.h>

namespace fairlight {
namespace {

// A machine that has the first two of three.
const std::vector<InstructionSet> sets{
    {"narrow", true, 4, nullptr}, {"wide", true, 8, nullptr}, {"wider", false, 16, nullptr}};

TEST(InstructionSets, AreChosenByNameOrTheWidestThatTheMachineHas) {
  EXPECT_EQ(choose_instructions("narrow", sets).lanes, 4u);
  EXPECT_EQ(choose_instructions("", sets).name, "wide");
}

TEST(InstructionSets, AreRefusedWhereTheMachineLacksThem) {
  EXPECT_THROW(choose_instructions("wider", sets), std::invalid_argument);
  EXPECT_THROW(choose_instructions("widest", sets), std::invalid_argument);
}

TEST(InstructionSets, OfThisMachineHaveAtLeastOne) { EXPECT_FALSE(choose_instructions("").name.empty()); }

}  // namespace
}  // namespace fairlight
