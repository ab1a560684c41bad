#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fairlight/validation/run/replay_token.h>

namespace fairlight {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::ThrowsMessage;

TEST(ReplayToken, NamesTheSeedAndTheSources) {
  const std::string token = replay_token(0xab);
  EXPECT_THAT(token, MatchesRegex("00000000000000ab-[0-9a-f]{8}"));
  EXPECT_EQ(parse_replay_token(token), 0xabu);
}

TEST(ReplayToken, MayBeASeedAlone) {
  EXPECT_EQ(parse_replay_token("ab"), 0xabu);
  EXPECT_EQ(parse_replay_token("00000000000000AB"), 0xabu);
}

TEST(ReplayToken, OfOtherSourcesIsRefusedAndSaysHowToGoOn) {
  std::string token = replay_token(0xab);
  token.back() = token.back() == '0' ? '1' : '0';
  EXPECT_THAT([&] { parse_replay_token(token); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("give \"00000000000000ab\" to run")));
}

TEST(ReplayToken, IsRefusedWhereItIsMalformed) {
  const std::string token = replay_token(0xab);
  const std::string shorter = token.substr(14);
  std::string other = token, longer = token;
  other[0] = 'x';
  longer.push_back('0');
  const std::string no_digit = "00000000000000ab-0123456g";
  for (const std::string& text : {std::string(), std::string("-"), std::string("ab-"), token.substr(0, 20), other,
                                  shorter, longer, no_digit}) {
    EXPECT_THROW(parse_replay_token(text), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace fairlight
