#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fairlight/stats/channel_findings.h>
#include <fairlight/stats/evidence.h>
#include <fairlight/stats/mean_test.h>
#include <fairlight/stats/text.h>

namespace fairlight {
namespace {

bool open(const BettingTest& test) { return test.verdict() == Verdict::undecided; }

// The size of the next block: the least that an open test asks for. 0 if no test is open, or if one
// is `biased`.
std::uint64_t next_block(const std::vector<BettingTest>& tests) {
  if (std::ranges::any_of(tests, [](const BettingTest& t) { return t.verdict() == Verdict::biased; })) return 0;
  std::uint64_t block = 0;
  for (const BettingTest& test : tests) {
    if (!open(test)) continue;
    const std::uint64_t next = test.block_size();
    block = block == 0 ? next : std::min(block, next);
  }
  return block;
}

void add(std::vector<BettingTest>& tests, const std::vector<std::vector<double>>& channels) {
  std::size_t c = 0;
  try {
    for (; c < tests.size(); ++c) tests[c].add(channels[c]);
  } catch (const BadDraw& bad) {
    if (tests.size() == 1) throw;
    throw BadDraw(bad, c);
  }
}

// The number of draws at which the open tests give up, and that at which they should have verdicts.
struct Plan {
  double patience = 0;
  double expected = 0;

  explicit Plan(const std::vector<BettingTest>& tests) {
    for (const BettingTest& test : tests) {
      if (!open(test)) continue;
      patience = std::max(patience, test.patience());
      expected = std::max(expected, test.moments().count() > 1 ? test.expected_draws() : test.patience());
    }
  }
};

// Updates the courses of these tests, the last ones in the evidence.
void leave_evidence(Evidence& evidence, const std::vector<BettingTest>& tests) {
  const std::size_t first = evidence.means.size() - tests.size();
  for (std::size_t c = 0; c < tests.size(); ++c) evidence.means[first + c].add(tests[c]);
}

// Such a range has bets so small that each draw is a block; they would fill the memory.
constexpr std::size_t most_blocks = 1u << 25;
constexpr const char* too_many_blocks =
    "the range is too long for the margin: more than 3e7 bets (declare a shorter one)";

// What a verdict takes, for tests that end without one.
std::string needed(const std::vector<BettingTest>& tests) {
  const double expected = Plan(tests).expected;
  if (!(expected > static_cast<double>(tests[0].moments().count()))) return {};
  return formatted("; a verdict needs about %.1e draws (allow more, or a larger margin)", expected);
}

// Runs the tests until all have verdicts, one is biased, the cap is reached, there are no more
// draws, or `watch` ends the test. Returns a note if there is no verdict.
std::string run(const Trial& trial, std::vector<BettingTest>& tests, const DrawBlock& draw_block) try {
  std::vector<std::vector<double>> channels(tests.size());
  const bool courses = trial.evidence != nullptr && trial.evidence->courses;
  if (courses) {
    for (const BettingTest& test : tests) trial.evidence->means.emplace_back(test);
  }
  std::uint64_t looks = 0;  // next number of draws at which to plan: every 1/64 of the draws
  for (std::uint64_t drawn = 0;;) {
    const std::uint64_t block = next_block(tests);
    if (block == 0) return {};
    if (drawn >= looks) {
      const Plan plan(tests);
      const auto n = static_cast<double>(drawn);
      if (n > plan.patience) return "the cap on draws came first";
      if (tests[0].blocks() > most_blocks) return std::string(too_many_blocks) + needed(tests);
      if (drawn > 0 && !goes_on(trial, n / std::max(plan.expected, 1.01 * n))) return told_to_end;
      looks = drawn + std::max<std::uint64_t>(drawn / 64, 1);
    }
    for (auto& channel : channels) channel.resize(block);
    draw_block(drawn, channels);
    add(tests, channels);
    if (courses) leave_evidence(*trial.evidence, tests);
    drawn += block;
  }
} catch (const NoMoreDraws& spent) {
  return spent.what() + needed(tests);
}

void tell_listener(const Trial& trial, const std::vector<Reference>& references, const DrawBlock& draw_block,
                   std::uint64_t draws) {
  if (trial.evidence == nullptr || !trial.evidence->listener) return;
  trial.evidence->listener(references, draw_block, draws);
}

// Appends channels to the claim's margin grid; a claim may run several tests.
void leave_grid(const Trial& trial, const MarginGrid& margin_grid) {
  if (trial.evidence == nullptr) return;
  MarginGrid& all = trial.evidence->margin_grid;
  all.first = margin_grid.first;
  all.channels.insert(all.channels.end(), margin_grid.channels.begin(), margin_grid.channels.end());
}

MarginGrid grid_of(const Trial& trial, const std::vector<BettingTest>& tests,
                   const std::vector<Reference>& references) {
  MarginGrid margin_grid{first_level(trial.margin), {}};
  for (std::size_t c = 0; c < tests.size(); ++c) {
    margin_grid.channels.push_back(wealth_at_levels(tests[c], trial.margin, references[c].scale));
  }
  return margin_grid;
}

// The largest bias of a channel over up to 4096 draws. For the report only; the verdict comes from
// a draw outside its range.
double rough_bias(const std::vector<Reference>& references, const DrawBlock& draw_block) {
  std::vector<std::vector<double>> channels(references.size(), std::vector<double>(4096));
  try {
    draw_block(0, channels);
  } catch (const BadDraw& bad) {
    if (bad.draw() == 0) return std::numeric_limits<double>::quiet_NaN();
    // The draws before the bad one; where draws are not numbered from 0 again, these.
    for (std::vector<double>& channel : channels) channel.resize(std::min<std::size_t>(bad.draw(), channel.size()));
  } catch (const NoMoreDraws&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  double worst = 0;
  for (std::size_t c = 0; c < references.size(); ++c) {
    const double bias = (Moments::of(channels[c]).mean() - references[c].mean) / references[c].scale;
    if (!(std::abs(bias) <= std::abs(worst))) worst = bias;
  }
  return worst;
}

// Widens the range, which stays valid, where the reference and its margin would not lie inside it.
MeanHypothesis hypothesis_of(const Reference& r, double relative_margin) {
  const double margin = relative_margin * r.scale;
  return {r.mean,
          margin,
          std::min(r.lower, r.mean - 2 * margin),
          std::max(r.upper, r.mean + 2 * margin),
          r.tail_slack,
          r.sides,
          r.rounding * r.scale};
}

std::vector<BettingTest> tests_of(const Trial& trial, const std::vector<Reference>& references) {
  check_trial(trial);
  if (references.empty()) throw std::invalid_argument("a test of means needs at least one reference");
  std::vector<BettingTest> tests;
  const double alpha = trial.alpha / static_cast<double>(references.size());
  for (const Reference& r : references) tests.emplace_back(hypothesis_of(r, trial.margin), alpha, trial.beta);
  return tests;
}

// For a one-sided claim, opens the interval's end on the allowed side, unless the interval lies
// wholly on the excluded side.
Interval with_open_side(Interval bias, Sides sides) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (sides == Sides::not_above && bias.lo <= 0) bias.lo = -infinite;
  if (sides == Sides::not_below && bias.hi >= 0) bias.hi = infinite;
  return bias;
}

Guarantee guarantee_of(const Reference& reference) {
  return reference.tail_slack > 0 ? Guarantee::exact_given_tail : Guarantee::exact;
}

std::string note_on_tail(const Reference& reference) {
  if (reference.tail_slack == 0) return {};
  return formatted("exact, given its tail: that at most %.1e of the mean lies above %g is taken on trust",
                   reference.tail_slack / reference.scale, reference.upper);
}

Finding finding_of(const BettingTest& test, const Reference& reference, double margin) {
  const Interval interval = test.interval();
  const auto relative = [&](double x) { return (x - reference.mean) / reference.scale; };
  return {test.verdict(),
          guarantee_of(reference),
          margin,
          relative(test.moments().mean()),
          with_open_side({relative(interval.lo), relative(interval.hi)}, reference.sides),
          test.moments().count(),
          reference.rounding};
}

// Names the channel of a finding that is not certified, since it alone is shown.
std::string note_of(const std::string& note, const Finding& finding, std::size_t channel, std::size_t channels) {
  if (channels == 1 || finding.verdict == Verdict::certified || note == told_to_end) return note;
  return note + (note.empty() ? "" : "; ") + "channel " + std::to_string(channel) + ", of 0 to " +
         std::to_string(channels - 1);
}

}  // namespace

double finest_margin(const std::vector<Reference>& references) {
  double finest = 0;
  for (const Reference& r : references) finest = std::max(finest, 4 * r.rounding);
  return finest;
}

Finding worst_of(const std::vector<Finding>& channels) {
  Finding worst = channels.at(0);
  for (const Finding& finding : channels) {
    const std::uint64_t draws = std::max(worst.draws, finding.draws);
    if (detail::is_worse(finding, worst)) worst = finding;
    worst.draws = draws;
  }
  return worst;
}

double expected_draws(const Trial& trial, const std::vector<Reference>& references,
                      const std::vector<std::vector<double>>& channels) {
  std::vector<BettingTest> tests = tests_of(trial, references);
  double expected = 0;
  for (std::size_t c = 0; c < tests.size(); ++c) {
    tests[c].add(channels[c]);
    expected = std::max(expected, tests[c].expected_draws());
  }
  return expected;
}

std::vector<Finding> test_each_mean(const Trial& trial, const std::vector<Reference>& references,
                                    const DrawBlock& draw_block) {
  std::vector<BettingTest> tests = tests_of(trial, references);
  try {
    const std::string note = run(trial, tests, draw_block);
    std::vector<Finding> findings;
    for (std::size_t c = 0; c < tests.size(); ++c) {
      findings.push_back(with_token(trial, finding_of(tests[c], references[c], trial.margin)));
      const std::string why = note.empty() ? note_on_tail(references[c]) : note;
      findings.back().note = note_of(why, findings.back(), c, tests.size());
    }
    if (trial.evidence != nullptr) leave_grid(trial, grid_of(trial, tests, references));
    tell_listener(trial, references, draw_block, worst_of(findings).draws);
    return findings;
  } catch (const BadDraw& bad) {
    Finding finding{Verdict::biased, Guarantee::exact, trial.margin};
    finding.bias = rough_bias(references, draw_block);
    finding.draws = bad.draw() + 1;
    finding.note = bad.what();
    leave_grid(trial, refuted_grid(trial.margin, references.size()));
    tell_listener(trial, references, draw_block, finding.draws);
    return std::vector(references.size(), with_token(trial, finding));
  }
}

Finding test_means(const Trial& trial, const std::vector<Reference>& references, const DrawBlock& draw_block) {
  return worst_of(test_each_mean(trial, references, draw_block));
}

}  // namespace fairlight
