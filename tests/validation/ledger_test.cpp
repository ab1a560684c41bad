#include <latch>
#include <limits>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>
#include <support/temporary_folder.h>

#include <fairlight/stats/hash.h>
#include <fairlight/validation/run/ledger.h>
#include <fairlight/validation/run/ledger_text.h>

namespace fairlight {
namespace {

using testing::read_file;
using testing::TemporaryFolder;
using testing::write_file;

constexpr double unlimited = std::numeric_limits<double>::infinity();

// A run of one channel whose first level, the margin 1/2, shows this much on both sides.
LedgerEntry run(const std::string& claim, std::uint64_t seed, double shown, std::uint64_t content = 7) {
  return {claim,
          content,
          {seed},
          1000,
          EvidenceSum(MarginGrid{2, {{{-1, -0.5, shown, shown}, {-1, 0.25, 0.5, unlimited}}}})};
}

double certified(const Ledger& ledger, const std::string& claim, std::uint64_t content = 7) {
  const LedgerEntry* entry = ledger.find({claim, content});
  return entry == nullptr ? unlimited : entry->evidence_sum.certified_margin(0.01);
}

std::string what_reading_says(const std::string& path) {
  try {
    Ledger::read(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(LedgerText, ReadsWhatItWrites) {
  LedgerEntry sum = run("a.b", 1, 3);
  sum.evidence_sum.append(run("a.b", 2, -1).evidence_sum);
  sum.seeds.insert(0xFFFFFFFFFFFFFFFFu);
  for (const LedgerEntry& entry : {run("a.b", 1, 3), run("c", 0xABCDEF, -3), sum}) {
    const std::string line = line_of(entry);
    ASSERT_EQ(line.back(), '\n');
    const auto again = entry_of(std::string_view(line).substr(0, line.size() - 1));
    ASSERT_TRUE(again);
    EXPECT_EQ(line_of(*again), line);
    EXPECT_EQ(again->claim, entry.claim);
    EXPECT_EQ(again->seeds, entry.seeds);
    EXPECT_EQ(again->draws, entry.draws);
    EXPECT_EQ(again->evidence_sum.channels()[0][0].below_upper_margin,
              entry.evidence_sum.channels()[0][0].below_upper_margin);
    EXPECT_EQ(again->evidence_sum.channels()[0][1].total.above_lower_margin, unlimited);
  }
}

TEST(LedgerText, RoundsDown) {
  LedgerEntry entry = run("a", 1, 0);
  entry.evidence_sum = EvidenceSum(MarginGrid{0, {{{1.0009, -1.0001, 1e-5, -1e-5}}}});
  const std::string line = line_of(entry);
  const Wealth total =
      entry_of(std::string_view(line).substr(0, line.size() - 1))->evidence_sum.channels()[0][0].total;
  EXPECT_EQ(total.above_reference, 1);
  EXPECT_EQ(total.below_reference, -1 - 0x1p-10);
  EXPECT_EQ(total.below_upper_margin, 0);
  EXPECT_EQ(total.above_lower_margin, -0x1p-10);
}

TEST(LedgerText, RefusesEveryLineThatIsNotWhole) {
  const std::string line = line_of(run("a", 1, 3));
  for (std::size_t length = 0; length + 1 < line.size(); ++length)
    EXPECT_FALSE(entry_of(line.substr(0, length))) << length;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    std::string damaged = line.substr(0, line.size() - 1);
    damaged[i] = static_cast<char>(damaged[i] ^ 1);
    EXPECT_FALSE(entry_of(damaged)) << i;
  }
  for (const char* body :
       {"run a 7 1 10 2", "run a 7 1 10 2 0 0 0 0 0", "run a 7 1 10 2 1 0 0 0", "run a 7 1 10 64 1 0 0 0 0",
        "run a 7 1 10 -1 1 0 0 0 0", "run a 7 q 10 2 1 0 0 0 0", "ran a 7 1 10 2 1 0 0 0 0", "run"}) {
    const std::string text = body;
    std::string checksum = line_of(run("a", 1, 0));
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash_of(text)));
    EXPECT_FALSE(entry_of(text + " " + digits)) << body;
  }
}

TEST(Ledger, AddsUpTheRunsOfAClaim) {
  const TemporaryFolder folder;
  Ledger::append(folder / "l", {run("a", 1, 3), run("b", 1, 3)});
  EXPECT_EQ(certified(Ledger::read(folder / "l"), "a"), unlimited);
  Ledger::append(folder / "l", {run("a", 2, 3)});
  const Ledger ledger = Ledger::read(folder / "l");
  EXPECT_EQ(certified(ledger, "a"), 0.5);
  EXPECT_EQ(certified(ledger, "b"), unlimited);
  EXPECT_EQ(ledger.find({"a", 7})->draws, 2000u);
}

TEST(Ledger, CountsARunThatIsReplayedOnce) {
  const TemporaryFolder folder;
  for (int i = 0; i < 3; ++i) Ledger::append(folder / "l", {run("a", 1, 3)});
  const Ledger ledger = Ledger::read(folder / "l");
  EXPECT_EQ(ledger.find({"a", 7})->seeds.size(), 1u);
  EXPECT_EQ(certified(ledger, "a"), unlimited);
  EXPECT_EQ(ledger.repeated(), 2u);
}

TEST(Ledger, BeginsAnewWithOtherSources) {
  const TemporaryFolder folder;
  Ledger::append(folder / "l", {run("a", 1, 3, 7), run("a", 2, 3, 8)});
  const Ledger ledger = Ledger::read(folder / "l");
  EXPECT_EQ(certified(ledger, "a", 7), unlimited);
  EXPECT_EQ(certified(ledger, "a", 8), unlimited);
  EXPECT_EQ(ledger.entries().size(), 2u);
}

TEST(Ledger, MergesToWhatOneWouldHold) {
  Ledger a;
  Ledger b;
  Ledger one;
  for (std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    (seed < 3 ? a : b).add(run("a", seed, seed == 3 ? -9.0 : 3.0));
    one.add(run("a", seed, seed == 3 ? -9.0 : 3.0));
  }
  Ledger merged = a;
  for (const auto& [key, entry] : b.entries()) merged.add(entry);
  EXPECT_EQ(merged.text(), one.text());
  for (const auto& [key, entry] : b.entries()) merged.add(entry);
  EXPECT_EQ(merged.text(), one.text()) << "again";
  EXPECT_EQ(merged.repeated(), 1u);
  const TemporaryFolder folder;
  write_file(folder / "m", merged.text());
  EXPECT_EQ(Ledger::read(folder / "m").text(), merged.text());
}

TEST(Ledger, TakesRunsOfSeveralFilesOneByOne) {
  const TemporaryFolder folder;
  Ledger::append(folder / "l", {run("a", 1, 3), run("a", 2, 3)});
  Ledger::append(folder / "m", {run("a", 2, 3), run("a", 3, 3)});
  Ledger both;
  both.add_file(folder / "l");
  both.add_file(folder / "m");
  EXPECT_EQ(both.find({"a", 7})->seeds, (std::set<std::uint64_t>{1, 2, 3}));
  EXPECT_EQ(both.repeated(), 1u);
}

TEST(Ledger, KeepsTheLargerOfTwoThatShareRuns) {
  Ledger three;
  for (std::uint64_t seed : {1u, 2u, 3u}) three.add(run("a", seed, 3));
  Ledger two;
  for (std::uint64_t seed : {3u, 4u}) two.add(run("a", seed, 3));
  Ledger merged = two;
  merged.add(*three.find({"a", 7}));
  EXPECT_EQ(merged.text(), three.text());
  merged = three;
  merged.add(*two.find({"a", 7}));
  EXPECT_EQ(merged.text(), three.text());
}

// A writer that is killed leaves any beginning of what it wrote.
TEST(Ledger, SurvivesAKillAtAnyByte) {
  const TemporaryFolder folder;
  const std::vector<LedgerEntry> entries{run("a", 1, 3), run("b", 1, 3), run("c", 1, 3)};
  Ledger::append(folder / "whole", entries);
  const std::string bytes = read_file(folder / "whole");
  ASSERT_EQ(read_file(folder / "whole").substr(0, ledger_header.size()), ledger_header);
  for (std::size_t length = 0; length <= bytes.size(); ++length) {
    write_file(folder / "cut", bytes.substr(0, length));
    if (length > 0 && length < ledger_header.size()) {
      EXPECT_NE(what_reading_says(folder / "cut").find("cut inside"), std::string::npos) << length;
      EXPECT_THROW(Ledger::append(folder / "cut", {run("d", 2, 3)}), std::runtime_error) << length;
      EXPECT_EQ(read_file(folder / "cut"), bytes.substr(0, length)) << length;
      continue;
    }
    std::size_t whole = 0;
    for (std::size_t end = ledger_header.size(); whole < entries.size(); ++whole) {
      end += line_of(entries[whole]).size();
      if (end > length) break;
    }
    const Ledger before = Ledger::read(folder / "cut");
    EXPECT_EQ(before.entries().size(), whole) << length;
    EXPECT_EQ(before.torn(), length > 0 && bytes[length - 1] != '\n') << length;
    Ledger::append(folder / "cut", {run("d", 2, 3)});
    const Ledger after = Ledger::read(folder / "cut");
    EXPECT_EQ(after.entries().size(), whole + 1) << length;
    EXPECT_NE(after.find({"d", 7}), nullptr) << length;
    EXPECT_FALSE(after.torn()) << length;
  }
}

// ... and so may the next, while it closes that line.
TEST(Ledger, SurvivesAKillOfTheWriterThatClosesATornLine) {
  const TemporaryFolder folder;
  Ledger::append(folder / "l", {run("a", 1, 3)});
  const std::string bytes = read_file(folder / "l");
  const std::string mark = " torn\n";
  for (std::size_t length = 0; length < mark.size(); ++length) {
    write_file(folder / "l", bytes + "run b 00" + mark.substr(0, length));
    Ledger::append(folder / "l", {run("c", 1, 3)});
    EXPECT_EQ(Ledger::read(folder / "l").entries().size(), 2u) << length;
  }
}

TEST(Ledger, LosesNothingOfTwoWritersAtOnce) {
  const TemporaryFolder folder;
  constexpr std::uint64_t runs = 100;
  const auto write = [&](const std::string& claim) {
    for (std::uint64_t seed = 0; seed < runs; ++seed)
      Ledger::append(folder / "l", {run(claim, seed, 3), run("both." + claim, seed, 3)});
  };
  std::thread other(write, "a");
  write("b");
  other.join();
  const Ledger ledger = Ledger::read(folder / "l");
  EXPECT_EQ(ledger.entries().size(), 4u);
  for (const auto& [key, entry] : ledger.entries()) EXPECT_EQ(entry.seeds.size(), runs) << key.first;
}

TEST(Ledger, IsBegunOnceByTwoWritersAtOnce) {
  const TemporaryFolder folder;
  for (int round = 0; round < 100; ++round) {
    const std::string path = folder / std::to_string(round);
    std::latch start(2);
    const auto write = [&](const std::string& claim) {
      start.arrive_and_wait();
      Ledger::append(path, {run(claim, 1, 3)});
    };
    std::thread other(write, "a");
    write("b");
    other.join();
    EXPECT_EQ(what_reading_says(path), "");
  }
}

TEST(Ledger, RefusesWhatIsNoLedgerInOneSentence) {
  const TemporaryFolder folder;
  const auto says = [&](const std::string& bytes) {
    write_file(folder / "l", bytes);
    return what_reading_says(folder / "l");
  };
  const std::string header(ledger_header);
  const std::string line = line_of(run("a", 1, 3));
  std::string damaged = line;
  damaged[8] = damaged[8] == '1' ? '2' : '1';
  EXPECT_NE(says("claim,verdict\n").find("not a ledger"), std::string::npos);
  EXPECT_NE(says("fairlight ledger 2\n" + line).find("another version"), std::string::npos);
  EXPECT_NE(says("fairlight ledger 12\n").find("another version"), std::string::npos);
  EXPECT_NE(says("fairlight led").find("cut inside"), std::string::npos);
  EXPECT_NE(says(header + damaged + line).find("line 2"), std::string::npos);
  EXPECT_NE(says(header + line + damaged).find("line 3"), std::string::npos) << "a whole last line that is damaged";
  EXPECT_NE(says(header + line.substr(0, 20) + "\n" + line).find("line 2"), std::string::npos);
  EXPECT_NE(says(header + "\n").find("line 2"), std::string::npos);
  EXPECT_EQ(says(header), "");
  EXPECT_NE(what_reading_says(folder / "none").find("none"), std::string::npos);
  EXPECT_NE(what_reading_says(folder.path().string()).find("not a file"), std::string::npos);
  EXPECT_TRUE(Ledger::read_if_there(folder / "none").entries().empty());
  EXPECT_THROW(Ledger::append(folder / "missing/l", {run("a", 1, 3)}), std::runtime_error);
}

}  // namespace
}  // namespace fairlight
