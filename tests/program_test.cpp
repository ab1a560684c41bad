#include <cstdio>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <support/program.h>

#include <fairlight/render/instruction_sets.h>

namespace fairlight {
namespace {

using testing::expect_bad_input;
using testing::fairlight;
using testing::read_file;
using testing::Result;
using testing::shell;
using testing::TemporaryFolder;
using testing::write_file;

const std::string small = "render cornell-simple --width 20 --height 10 --seed 9 ";

TEST(Program, RefusesBadInputInOneSentence) {
  expect_bad_input("", "render");
  expect_bad_input("rendr", "did you mean render?");
  expect_bad_input("audit", "calibration");
  expect_bad_input("audit nope", "see fairlight audit --help");
  expect_bad_input("audit calibratoin", "did you mean calibration?");
  expect_bad_input("render cornell-simple --spp 1 -o a.exr --bounc uniform", "did you mean --bounce?");
  expect_bad_input("render cornell-simple --spp 1 -o a.exr --bounce uniform", "--max-depth");
  expect_bad_input("render cornell-simple --spp 1 -o a.exr --seed ''", "seed");
  expect_bad_input("render cornell-simple --spp 1 -o ''", "-o");
  expect_bad_input("render cornell-simple --spp 5000000000 -o a.exr", "spp");
  expect_bad_input(small + "--spp 1 -o a.exr --png a.exr", "same file");
  expect_bad_input(small + "--spp 1 -o ./a.exr --json a.exr", "same file");
  expect_bad_input("verify --list > /dev/full", "standard output");
  expect_bad_input("render --help > /dev/full", "standard output");
  expect_bad_input("render cornel --spp 1 -o a.exr", "cornell-simple");
  expect_bad_input("render halway --spp 1 -o a.exr", "did you mean hallway? see fairlight scenes");
  expect_bad_input("render cornell-simple --spp 1", "-o");
  expect_bad_input("render cornell-simple --spp 1 -o a.exr --bounce sideways", "uniform");
  expect_bad_input("render cornell-simple --spp 1 -o a.exr --colour", "--colour");
  expect_bad_input(small + "--spp 0 -o a.exr", "spp");
  expect_bad_input(small + "--spp -3 -o a.exr", "spp");
  expect_bad_input("render cornell-simple --spp 1 --width 0 -o a.exr", "width");
  expect_bad_input("render cornell-simple --spp 1 --height -5 -o a.exr", "height");
  expect_bad_input(small + "--spp 1 --threads 0 -o a.exr", "threads");
  expect_bad_input(small + "--spp 1 --instructions mmx -o a.exr", "mmx");
  expect_bad_input(small + "--spp 1 --max-depth -1 -o a.exr", "max-depth");
  expect_bad_input(small + "--spp 1 --roulette off -o a.exr", "--max-depth");
  expect_bad_input(small + "--spp 1 --roulette-depth 0 -o a.exr", "roulette-depth");
  expect_bad_input(small + "--spp 1 --roulette off --max-depth 3 --roulette-depth 2 -o a.exr", "--roulette-depth");
  expect_bad_input(small + "--spp 1 --max-depth 3 --roulette-depth 4 -o a.exr", "--roulette-depth");
  expect_bad_input(small + "--spp 1 --fov 1e-40 -o a.exr", "--real double");
  expect_bad_input("render hallway --spp 1 --focus 1e-20 -o a.exr", "--real double");
  expect_bad_input(small + "--spp 16 --random halton -o a.exr", "stratified");
  expect_bad_input(small + "--spp 20 --random sobol -o a.exr", "16 or 32");
  expect_bad_input(small + "--spp 12 --random sobol --points 12 -o a.exr", "power of two");
  expect_bad_input(small + "--spp 16 --points 16 -o a.exr", "--random");
  expect_bad_input(small + "--spp 32 --random sobol --shard 1/3 -o a.exr", "sets");
  expect_bad_input(small + "--spp 1 --shard 3/2 -o a.exr", "3/2");
  expect_bad_input(small + "--spp 1 --shard 1/2 -o a.exr", "empty");
  expect_bad_input("render cornell-simple --spp 1 --seed xyz -o a.exr", "xyz");
  expect_bad_input(small + "--spp 1 -o missing/a.exr", "missing/a.exr");
  expect_bad_input(small + "--spp 1 -o a.exr --png missing/a.png", "missing/a.png");
  expect_bad_input(small + "--spp 1 -o a.exr --resume none.exr", "none.exr");
  expect_bad_input("merge none.exr -o a.exr", "none.exr");
  expect_bad_input("verify hemisphere.cosine.lw", "did you mean hemisphere.cosine.law");
  expect_bad_input("verify zzz", "see fairlight verify --list");
  expect_bad_input("verify pick --seed 12q", "12q");
  expect_bad_input("verify pick --seed 0123456789abcdef-0123456", "no token");
  expect_bad_input("verify pick --seed 0123456789abcdef-00000000", "other sources");
  expect_bad_input("verify pick --margin 0", "margin");
  expect_bad_input("verify pick --margin 2", "margin");
  expect_bad_input("verify pick --budget 1", "budget");
  expect_bad_input("verify pick --json missing/a.json", "missing/a.json");
  expect_bad_input("verify pick --ledger ''", "--ledger");
  expect_bad_input("verify pick --ledger missing/l", "missing/l");
  expect_bad_input("verify pick --ledger /dev/null", "/dev/null");
  expect_bad_input("verify pick --ledger a.json --json ./a.json", "same file");
  expect_bad_input("verify --since ''", "--since");
  expect_bad_input("verify --since no-such-revision --list", "no-such-revision");
  expect_bad_input("verify --since '--output=x' --list", "--output=x");
  expect_bad_input("ledger", "show");
  expect_bad_input("ledger show none", "none");
  expect_bad_input("ledger merge none -o a", "none");
  expect_bad_input("verify pick --seed 12345678901234567", "12345678901234567");
  expect_bad_input("verify importance --margin 1e-6", "cannot be tested on these terms");
  expect_bad_input("verify hemisphere.cosine.law --margin 1e-8", "cannot be tested on these terms");
  expect_bad_input("verify pick --seconds 0", "seconds");
  expect_bad_input("verify pick --seconds -1", "seconds");
  expect_bad_input("verify pick --seconds soon", "seconds");
  expect_bad_input("verify pick --artifacts missing/folder", "missing/folder");
  expect_bad_input("verify pick --artifacts /dev/null", "/dev/null");
  expect_bad_input("verify pick --artifacts /proc/folder", "/proc/folder");
  expect_bad_input("verify pick --report missing/a.md", "missing/a.md");
  expect_bad_input("verify pick --report a.md --json ./a.md", "same file");
  expect_bad_input("verify pick --report .", "cannot write");
  expect_bad_input("audit faults --seeds 0", "seeds");
  expect_bad_input("audit judges --seeds 0", "seeds");
  expect_bad_input("audit judges --margin 0", "margin");
  expect_bad_input("audit judges --verdict", "--verdict");
  expect_bad_input("audit mutate --sample 0", "sample");
  expect_bad_input("audit mutate estimators/nope.h", "estimators/nope.h");
  expect_bad_input("audit mutate estimators/cane.h", "estimators/cone.h");
  expect_bad_input("audit mutate --seed mutant", "mutant");
  expect_bad_input("audit mutate --results .", "cannot write");
  expect_bad_input("audit mutate --json .", "cannot write");
  expect_bad_input("audit mutate --operators typos", "typos");
  expect_bad_input("audit mutate --seconds 0", "seconds");
}

TEST(Program, RefusesOptionsThatAreNoNumbers) {
  for (const std::string value : {"nan", "-nan", "inf", "-inf", "1e999", "one", "''"}) {
    for (const std::string option : {"--aperture", "--focus", "--fov"})
      expect_bad_input(small + "--spp 1 -o a.exr " + option + " " + value, option);
    for (const std::string option : {"--margin", "--budget", "--seconds"})
      expect_bad_input("verify pick --json a.json " + option + " " + value, option);
    expect_bad_input("audit judges --json a.json --margin " + value, "--margin");
  }
}

TEST(Program, RefusesAClaimInAShortSentence) {
  const TemporaryFolder folder;
  for (const char* claim : {"hemisphere.cosine.lw", "e", "'*.nothing'", "zzz"}) {
    const Result run = fairlight("verify " + std::string(claim), folder);
    EXPECT_EQ(run.status, 2) << claim;
    EXPECT_LT(run.error.size(), 500u) << run.error;
  }
}

TEST(Program, GoesOnWithNoForeignResultsOfMutants) {
  const TemporaryFolder folder;
  for (const char* line :
       {"{\"mutant\": 1}\n", "none\n", R"({"mutant": "a", "fate": "eaten", "by": "", "seconds": 1})"}) {
    write_file(folder / "a.jsonl", line);
    const Result run = fairlight("audit mutate --results a.jsonl", folder);
    EXPECT_EQ(run.status, 2) << line;
    EXPECT_EQ(read_file(folder / "a.jsonl"), line);
  }
}

TEST(Program, GivesHelpForEveryCommand) {
  const TemporaryFolder folder;
  for (const char* command :
       {"", "verify", "audit", "audit calibration", "audit faults", "audit judges", "audit ledger", "audit mutate",
        "audit power", "ledger", "ledger show", "ledger merge", "render", "merge", "scenes"}) {
    const Result run = fairlight(std::string(command) + " --help", folder);
    EXPECT_EQ(run.status, 0) << command;
    EXPECT_NE(run.out.find("\n\nUsage: fairlight"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("\n\nExample"), std::string::npos) << run.out;
  }
}

TEST(Program, RendersTheSameBytesForAnyThreads) {
  const TemporaryFolder folder;
  for (const char* threads : {"1", "2", "7"}) {
    const Result run = fairlight(small + "--spp 4 -o " + threads + ".exr --threads " + threads, folder);
    EXPECT_EQ(run.status, 0) << run.error;
    EXPECT_EQ(run.error, "") << "no progress bar in a pipe";
  }
  const std::string one = read_file(folder / "1.exr");
  EXPECT_GT(one.size(), 1000u);
  EXPECT_EQ(one, read_file(folder / "2.exr"));
  EXPECT_EQ(one, read_file(folder / "7.exr"));
}

// By every instruction set of this machine, with more threads than cores and than tiles.
TEST(Program, RendersOnePixel) {
  const TemporaryFolder folder;
  for (const InstructionSet& set : instruction_sets()) {
    if (!set.runs_here) continue;
    const Result run = fairlight(
        "render cornell-simple --width 1 --height 1 --spp 2 --threads 500 -o a.exr --instructions " + set.name,
        folder);
    EXPECT_EQ(run.status, 0) << run.error;
  }
}

TEST(Program, ResumesAndMergesToTheBytesOfOneRender) {
  const TemporaryFolder folder;
  fairlight(small + "--spp 7 -o whole.exr", folder);
  fairlight(small + "--spp 3 -o start.exr", folder);
  EXPECT_EQ(
      fairlight("render cornell-simple --width 20 --height 10 --spp 4 --resume start.exr -o resumed.exr", folder)
          .status,
      0);
  for (const char* i : {"1", "2", "3"})
    fairlight(small + "--spp 7 --shard " + i + "/3 -o shard" + i + ".exr", folder);
  EXPECT_EQ(fairlight("merge shard2.exr shard1.exr shard3.exr -o merged.exr", folder).status, 0);
  const std::string whole = read_file(folder / "whole.exr");
  EXPECT_GT(whole.size(), 1000u);
  EXPECT_EQ(whole, read_file(folder / "resumed.exr"));
  EXPECT_EQ(whole, read_file(folder / "merged.exr"));
}

TEST(Program, ResumesAndMergesWholeSetsToTheBytesOfOneRender) {
  const TemporaryFolder folder;
  const std::string sets = small + "--random sobol --points 4 ";
  fairlight(sets + "--spp 28 -o whole.exr", folder);
  fairlight(sets + "--spp 12 -o start.exr", folder);
  EXPECT_EQ(fairlight(sets + "--spp 16 --resume start.exr -o resumed.exr", folder).status, 0);
  for (const char* i : {"1", "2", "3"})
    fairlight(sets + "--spp 28 --shard " + i + "/3 -o shard" + i + ".exr", folder);
  EXPECT_EQ(fairlight("merge shard2.exr shard1.exr shard3.exr -o merged.exr", folder).status, 0);
  const std::string whole = read_file(folder / "whole.exr");
  EXPECT_GT(whole.size(), 1000u);
  EXPECT_EQ(whole, read_file(folder / "resumed.exr"));
  EXPECT_EQ(whole, read_file(folder / "merged.exr"));
}

TEST(Program, KeepsAPictureThatCannotBeResumedOrMerged) {
  const TemporaryFolder folder;
  fairlight(small + "--spp 1 -o a.exr", folder);
  const std::string before = read_file(folder / "a.exr");
  write_file(folder / "cut.exr", before.substr(0, before.size() / 2));
  for (const char* arguments : {"render cornell-simple --spp 1 --width 20 --height 10 --resume cut.exr -o a.exr",
                                "render cornell-simple --spp 1 --resume a.exr -o a.exr",
                                "merge a.exr cut.exr -o a.exr", "merge a.exr a.exr -o a.exr"}) {
    const Result run = fairlight(arguments, folder);
    EXPECT_EQ(run.status, 2) << arguments;
    EXPECT_EQ(std::count(run.error.begin(), run.error.end(), '\n'), 1) << run.error;
    EXPECT_EQ(read_file(folder / "a.exr"), before) << arguments;
    EXPECT_EQ(folder.files(), 2) << arguments;
  }
}

// A limit on the size of files stands for a full disk: the write itself fails.
TEST(Program, LeavesNothingWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  const Result run = shell("trap '' XFSZ; ulimit -f 8; " + std::string(FAIRLIGHT_PROGRAM) +
                               " render cornell-simple --width 200 --height 100 --spp 1 -o a.exr",
                           folder);
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.error.find("a.exr"), std::string::npos) << run.error;
  EXPECT_EQ(std::count(run.error.begin(), run.error.end(), '\n'), 1) << run.error;
  EXPECT_EQ(folder.files(), 0);
}

TEST(Program, ReportsARenderAsJson) {
  const TemporaryFolder folder;
  ASSERT_EQ(fairlight(small + "--spp 2 -o a.exr --json a.json", folder).status, 0);
  const auto json = nlohmann::json::parse(read_file(folder / "a.json"));
  for (const char* key : {"scene", "settings", "seed", "paths", "rays", "seconds", "paths_per_second",
                          "rays_per_second", "peak_bytes"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_EQ(json["paths"], 400);
  EXPECT_EQ(json["seed"], "0000000000000009");
}

}  // namespace
}  // namespace fairlight
