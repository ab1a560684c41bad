#include <algorithm>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include <fairlight/validation/provenance/replay_token.h>
#include <fairlight/validation/registry.h>
#include <fairlight/validation/report/report.h>

namespace fairlight {
namespace {

const Conformance conformance{{.seed = 0xAB}};

Outcome outcome(Verdict verdict) {
  Outcome made{&registry()[0], {}, 1.5};
  made.finding = {verdict, Guarantee::exact, 1e-3, 2e-4, {-5e-4, 9e-4}, 1000};
  return made;
}

TEST(Report, SaysHowToReplayAClaim) {
  const std::string token = replay_token(0xAB);
  EXPECT_EQ(replay("a.b", conformance), "fairlight verify a.b --seed " + token);
  EXPECT_EQ(replay("", conformance), "fairlight verify --seed " + token);
  Conformance unusual = conformance;
  unusual.terms.margin = 0.125;
  EXPECT_EQ(replay("a.b", unusual), "fairlight verify a.b --seed " + token + " --margin 0.125");
}

std::string printed(const std::vector<Outcome>& outcomes, Rows rows) {
  std::FILE* file = std::tmpfile();
  print_outcomes(file, outcomes, conformance, rows);
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
  EXPECT_NE(text.find("    again: " + replay(claim, conformance) + "\n"), std::string::npos);
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
  EXPECT_NE(text.find("claims: the time was up"), std::string::npos) << text;
}

TEST(Report, HasNullForAnEndThatIsNotKnown) {
  Outcome open = outcome(Verdict::undecided);
  open.finding.interval = {-1e-3, std::numeric_limits<double>::infinity()};
  EXPECT_EQ(nlohmann::json::parse(outcome_json(open, conformance).dump())["interval"].dump(), "[-0.001,null]");
}

TEST(Report, HasTheFieldsOfTheContractAsJson) {
  const auto json = outcomes_json({outcome(Verdict::biased)}, conformance, 2);
  for (const char* key : {"version", "seed", "budget", "seconds", "verdict", "claims"})
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
