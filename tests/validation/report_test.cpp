#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include <fairlight/validation/report/report.h>
#include <fairlight/validation/run/registry.h>
#include <fairlight/validation/run/replay_token.h>

namespace fairlight {
namespace {

const RunOptions run_options{{.seed = 0xAB}};

Outcome outcome(Verdict verdict) {
  Outcome made{&registry()[0], {}, 1.5};
  made.finding = {verdict, Guarantee::exact, 1e-3, 2e-4, {-5e-4, 9e-4}, 1000};
  return made;
}

Claim in_avx2(const std::string& name) {
  Claim claim = registry()[0];
  claim.name = name;
  claim.instructions = "avx2";
  return claim;
}

TEST(Report, SaysHowToReplayAClaim) {
  const std::string token = replay_token(0xAB);
  const Claim claim = in_avx2("a.b");
  EXPECT_EQ(replay(claim, run_options), "fairlight verify a.b --seed " + token + " --instructions avx2");
  EXPECT_EQ(replay_run("", run_options), "fairlight verify --seed " + token);
  RunOptions unusual = run_options;
  unusual.terms.margin = 0.125;
  EXPECT_EQ(replay_run("a.b", unusual), "fairlight verify a.b --seed " + token + " --margin 0.125");
}

// A claim of a run by several instruction sets has its part of the budget, alone as well.
TEST(Report, SaysHowToReplayAClaimOfOneInstructionSetAmongSeveral) {
  const Claim claim = in_avx2("a.b");
  RunOptions all = run_options;
  all.terms.budget = 1e-3;
  all.instructions = {"sse2", "avx2"};
  const std::string begin = "fairlight verify a.b --seed " + replay_token(0xAB);
  EXPECT_EQ(replay(claim, all), begin + " --budget 0.0005 --instructions avx2");
  EXPECT_EQ(replay_run("a.b", all), begin + " --budget 0.001 --instructions all");
  EXPECT_EQ(label({&claim, {}, 0}, all), "a.b [avx2]");
  EXPECT_EQ(label({&claim, {}, 0}, run_options), "a.b");
}

std::string printed(const std::vector<Outcome>& outcomes, Rows rows) {
  std::FILE* file = std::tmpfile();
  print_outcomes(file, outcomes, run_options, rows);
  std::string text(static_cast<std::size_t>(std::ftell(file)), ' ');
  std::rewind(file);
  EXPECT_EQ(std::fread(text.data(), 1, text.size(), file), text.size());
  std::fclose(file);
  return text;
}

std::ptrdiff_t lines(const std::string& text) { return std::ranges::count(text, '\n'); }

// Of every claim, one failure among them.
std::vector<Outcome> a_whole_run() {
  std::vector<Outcome> outcomes;
  for (const Claim& claim : registry()) {
    outcomes.push_back(outcome(Verdict::certified));
    outcomes.back().claim = &claim;
  }
  outcomes[300].finding.verdict = Verdict::biased;
  outcomes[300].finding.note = "why so";
  return outcomes;
}

TEST(Table, ShowsAFailureFirstWithWhyAndHowToReplayIt) {
  const auto outcomes = a_whole_run();
  const std::string text = printed(outcomes, Rows::grouped);
  const std::string claim = outcomes[300].claim->name;
  EXPECT_EQ(text.find(claim), text.find('\n') + 1) << text;
  EXPECT_NE(text.find("    why so\n"), std::string::npos);
  EXPECT_NE(text.find("    again: " + replay(*outcomes[300].claim, run_options) + "\n"), std::string::npos);
}

TEST(Table, HasARowForEveryFirstNameOfMany) {
  const auto outcomes = a_whole_run();
  std::set<std::string> names;
  for (const Outcome& o : outcomes) names.insert(o.claim->name.substr(0, o.claim->name.find('.')));
  const std::string text = printed(outcomes, Rows::grouped);
  EXPECT_EQ(lines(text), 1 + 4 + static_cast<std::ptrdiff_t>(names.size())) << text;
  EXPECT_EQ(lines(printed(outcomes, Rows::all)), 1 + 3 + static_cast<std::ptrdiff_t>(outcomes.size()));
  EXPECT_LT(lines(printed({outcome(Verdict::certified), outcome(Verdict::certified)}, Rows::grouped)), 4);
}

TEST(Table, SaysOfAGroupItsWidestMarginAndIntervalAndItsSums) {
  auto outcomes = a_whole_run();
  const std::string name = outcomes[0].claim->name.substr(0, outcomes[0].claim->name.find('.'));
  std::size_t members = 0;
  for (const Outcome& o : outcomes) members += o.claim->name.starts_with(name + ".") ? 1 : 0;
  ASSERT_GT(members, 1u);
  outcomes[1].finding.margin = 0.03;
  outcomes[1].finding.interval.hi = 0.02;
  const std::string text = printed(outcomes, Rows::grouped);
  const std::size_t at = text.find(name + " (" + std::to_string(members) + ")");
  ASSERT_NE(at, std::string::npos) << text;
  const std::string line = text.substr(at, text.find('\n', at) - at);
  for (const std::string& part :
       {std::string("3.0e-02"), std::string("-5.00e-04  +2.00e-02"), std::to_string(1000 * members)}) {
    EXPECT_NE(line.find(part), std::string::npos) << part << " in " << line;
  }
}

TEST(Table, GroupsWhatHadNoTime) {
  auto outcomes = a_whole_run();
  for (Outcome& o : outcomes) {
    if (o.finding.verdict == Verdict::biased) continue;
    o.finding.verdict = Verdict::undecided;
    o.finding.note = "the time was up";
    o.out_of_time = true;
  }
  const std::string text = printed(outcomes, Rows::grouped);
  EXPECT_LT(lines(text), 100) << text;
  EXPECT_EQ(text.find(": the time was up"), text.rfind(": the time was up")) << "once for all\n" << text;
}

// The places of claims that share their first name with five others or more.
std::vector<std::size_t> a_large_group(const std::vector<Outcome>& outcomes) {
  std::map<std::string, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (outcomes[i].finding.verdict != Verdict::certified) continue;
    const std::string& claim = outcomes[i].claim->name;
    auto& group = groups[claim.substr(0, claim.find('.'))];
    group.push_back(i);
    if (group.size() == 6) return group;
  }
  return {};
}

TEST(Table, NamesTheClaimsOfItsNotes) {
  auto outcomes = a_whole_run();
  const std::vector<std::size_t> group = a_large_group(outcomes);
  ASSERT_EQ(group.size(), 6u);
  for (std::size_t i = 0; i < 5; ++i) outcomes[group[i]].finding.note = "seen of five";
  outcomes[group[5]].finding.note = "seen of one";
  const std::string text = printed(outcomes, Rows::grouped);
  const auto name = [&](std::size_t i) { return outcomes[group[i]].claim->name; };
  EXPECT_NE(text.find("\n" + name(0) + ", " + name(1) + ", " + name(2) + " and 2 more: seen of five\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("\n" + name(5) + ": seen of one\n"), std::string::npos) << text;
}

constexpr double infinite = std::numeric_limits<double>::infinity();

// Of two claims without a group.
TEST(Table, ShowsAnEndThatIsOpen) {
  auto outcomes = a_whole_run();
  outcomes.resize(2);
  outcomes[0].finding.interval.lo = -infinite;
  outcomes[1].finding.interval.hi = infinite;
  const std::string text = printed(outcomes, Rows::grouped);
  EXPECT_NE(text.find("       open  +9.00e-04"), std::string::npos) << text;
  EXPECT_NE(text.find("  -5.00e-04       open"), std::string::npos) << text;
  EXPECT_EQ(text.find("inf"), std::string::npos) << text;
}

// The row of the first name, of which all claims have this interval but the first, which has
// another.
std::string row_of_group(Verdict verdict, Interval first, Interval others) {
  auto outcomes = a_whole_run();
  const std::string& claim = outcomes[0].claim->name;
  const std::string name = claim.substr(0, claim.find('.'));
  for (Outcome& o : outcomes) {
    o.finding.verdict = verdict;
    o.out_of_time = verdict == Verdict::undecided;
    o.finding.interval = others;
  }
  outcomes[0].finding.interval = first;
  const std::string text = printed(outcomes, Rows::grouped);
  const std::size_t at = text.find(name + " (");
  EXPECT_NE(at, std::string::npos) << text;
  return text.substr(at, text.find('\n', at) - at);
}

TEST(Table, ShowsOfAGroupTheEndsThatClaimsExclude) {
  const auto holds = [](const std::string& row, const std::string& part) {
    EXPECT_NE(row.find(part), std::string::npos) << row;
  };
  holds(row_of_group(Verdict::certified, {-infinite, 0.02}, {-5e-4, 9e-4}), "-5.00e-04  +2.00e-02");
  holds(row_of_group(Verdict::certified, {-0.02, infinite}, {-5e-4, 9e-4}), "-2.00e-02  +9.00e-04");
  holds(row_of_group(Verdict::certified, {-infinite, 0.02}, {-infinite, 9e-4}), "     open  +2.00e-02");
  // Of an undecided claim, an open end is not known.
  holds(row_of_group(Verdict::undecided, {-infinite, infinite}, {-5e-4, 9e-4}), "     open       open");
}

const ComponentOutcome cosine{"CosineHemisphere", "avx2", 41, Verdict::certified, false, 2e-4};
const ComponentOutcome bright{"Mirror", "avx2", 3, Verdict::biased, true, infinite};

TEST(Components, HaveARowEachTheWorstFirst) {
  std::FILE* file = std::tmpfile();
  print_components(file, {cosine, bright}, run_options);
  print_components(file, {}, run_options);
  std::string text(static_cast<std::size_t>(std::ftell(file)), ' ');
  std::rewind(file);
  EXPECT_EQ(std::fread(text.data(), 1, text.size(), file), text.size());
  std::fclose(file);
  EXPECT_EQ(lines(text), 3) << text;
  EXPECT_LT(text.find("Mirror"), text.find("CosineHemisphere")) << text;
  EXPECT_NE(text.find("41  certified  below 2.0e-04\n"), std::string::npos) << text;
  EXPECT_NE(text.find("3  biased     found: the means are too high\n"), std::string::npos) << text;
}

TEST(Components, AreInTheJsonAndInItsVerdict) {
  const auto json = outcomes_json({outcome(Verdict::certified)}, {cosine, bright}, run_options, 2);
  EXPECT_EQ(json["verdict"], "biased") << "a component is";
  EXPECT_EQ(json["components"][0]["name"], "CosineHemisphere");
  EXPECT_EQ(json["components"][0]["claims"], 41);
  EXPECT_EQ(json["components"][0]["margin"], 2e-4);
  EXPECT_EQ(nlohmann::json::parse(json.dump())["components"][1]["margin"].dump(), "null");
}

TEST(ListOf, NamesTheFirstAndCountsTheOthers) {
  EXPECT_EQ(list_of({}, 3), "");
  EXPECT_EQ(list_of({"a"}, 3), "a");
  EXPECT_EQ(list_of({"a", "b"}, 3), "a and b");
  EXPECT_EQ(list_of({"a", "b", "c"}, 3), "a, b and c");
  EXPECT_EQ(list_of({"a", "b", "c", "d"}, 3), "a, b, c and 1 more");
}

TEST(Report, HasNullForAnEndThatIsOpen) {
  Outcome open = outcome(Verdict::undecided);
  open.finding.interval = {-1e-3, infinite};
  EXPECT_EQ(nlohmann::json::parse(outcome_json(open, run_options).dump())["interval"].dump(), "[-0.001,null]");
  open.finding.interval = {-infinite, 1e-3};
  EXPECT_EQ(nlohmann::json::parse(outcome_json(open, run_options).dump())["interval"].dump(), "[null,0.001]");
}

TEST(Report, HasTheFieldsOfTheContractAsJson) {
  const auto json = outcomes_json({outcome(Verdict::biased)}, {}, run_options, 2);
  for (const char* key : {"version", "seed", "budget", "seconds", "verdict", "claims", "components"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["verdict"], "biased");
  const auto& claim = json["claims"][0];
  EXPECT_EQ(claim["name"], registry()[0].name);
  EXPECT_EQ(claim["verdict"], "biased");
  EXPECT_EQ(claim["guarantee"], "exact");
  EXPECT_EQ(claim["margin"], 1e-3);
  EXPECT_EQ(claim["bias"], 2e-4);
  EXPECT_EQ(claim["interval"].dump(), "[-0.0005,0.0009]");
  EXPECT_EQ(claim["samples"], 1000);
  EXPECT_EQ(claim["real"], "double");
  EXPECT_TRUE(claim.contains("kind") && claim.contains("seconds") && claim.contains("replay"));
}

}  // namespace
}  // namespace fairlight
