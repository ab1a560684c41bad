#include <algorithm>
#include <functional>
#include <map>
#include <stdexcept>

#include <fairlight/render/parallel.h>
#include <fairlight/stats/evidence.h>
#include <fairlight/stats/moments.h>
#include <fairlight/validation/audit/judges.h>
#include <fairlight/validation/audit/judges_audit.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/run/registry.h>

namespace fairlight {
namespace {

// A claim about right code, and its versions with faults.
struct Row {
  const Claim* right;
  std::vector<const Claim*> wrong;
  std::vector<const Fault*> faults;  // the fault of each wrong one
};

std::vector<Row> rows_of_catalogue(const RunOptions& run_options) {
  std::vector<Row> rows;
  std::map<std::string, std::size_t> row_of;
  for (const Fault& fault : fault_catalogue()) {
    if (!fault.survives.empty()) continue;
    for (const Claim& claim : fault.claims) {
      if (claim.kind != "mean") continue;
      const auto [at, is_new] = row_of.try_emplace(claim.name, rows.size());
      if (is_new) rows.push_back({select_claims({claim.name}, run_options.instructions.front()).front(), {}, {}});
      rows[at->second].wrong.push_back(&claim);
      rows[at->second].faults.push_back(&fault);
    }
  }
  return rows;
}

// The first n draws of a test of means, shifted and scaled so that the reference mean is 1.
std::vector<std::vector<double>> first_draws(const std::vector<Reference>& references, const DrawBlock& draw_block,
                                             std::uint64_t n) {
  std::vector<std::vector<double>> channels(references.size(), std::vector<double>(n));
  draw_block(0, channels);
  for (std::size_t c = 0; c < channels.size(); ++c) {
    for (double& x : channels[c]) x = 1 + (x - references[c].mean) / references[c].scale;
  }
  return channels;
}

// The size and the variances of a row, found before any judgement.
struct Plan {
  std::uint64_t draws = 0;
  std::vector<double> variances;
};

// The default number of samples per pixel of the reference pictures of Mitsuba.
constexpr std::uint64_t reference_draws = 32'000;

Plan plan_of(const Row& row, Trial trial) {
  Plan plan;
  Evidence evidence;
  evidence.listener = [&](const std::vector<Reference>& references, const DrawBlock& draw_block, std::uint64_t n) {
    if (std::ranges::any_of(references, [](const Reference& r) { return r.sides != Sides::both; }))
      throw std::logic_error(row.right->name + " claims no mean (only a side of it, which others do not judge)");
    plan.draws = n;
    for (const auto& channel : first_draws(references, draw_block, reference_draws)) {
      plan.variances.push_back(Moments::of(channel).variance());
    }
  };
  trial.evidence = &evidence;
  row.right->check(trial);
  return plan;
}

// Whether each judge failed a run: fairlight first, then the others in their order.
struct Failures {
  std::vector<char> stopped, planned;
};

std::vector<char> failures_on(const std::vector<std::vector<double>>& channels, std::uint64_t n,
                              const std::vector<double>& variances) {
  JudgedDraws draws{{}, variances};
  for (const auto& channel : channels) draws.channels.push_back(std::span(channel).first(n));
  std::vector<char> failed{0};
  for (const Judge& judge : judges()) failed.push_back(judge.fails(draws) ? 1 : 0);
  return failed;
}

Failures failures_of(const Claim& claim, Trial trial, const Plan& plan) {
  Failures failures;
  Evidence evidence;
  evidence.listener = [&](const std::vector<Reference>& references, const DrawBlock& draw_block, std::uint64_t n) {
    const auto channels = first_draws(references, draw_block, std::max(n, plan.draws));
    failures.stopped = failures_on(channels, n, plan.variances);
    failures.planned = failures_on(channels, plan.draws, plan.variances);
  };
  trial.evidence = &evidence;
  const bool failed = claim.check(trial).verdict != Verdict::certified;
  failures.stopped.at(0) = failures.planned.at(0) = failed ? 1 : 0;
  return failures;
}

// The results of one seed of a row.
struct SeedResult {
  Failures right;
  std::vector<Failures> wrong;
};

void count(Share& share, bool failed) {
  share.count += failed ? 1 : 0;
  ++share.of;
}

// Gathers the results of one judge. Those of (row, seed) are in results[row * seeds + seed].
JudgeOutcome outcome_of(std::size_t judge, std::string name, const std::vector<Row>& rows,
                        const std::vector<SeedResult>& results, std::size_t seeds) {
  JudgeOutcome outcome{std::move(name)};
  std::vector<char> suite(seeds);
  std::map<const Fault*, bool> killed;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::vector<std::size_t> times(rows[r].wrong.size());
    for (std::size_t s = 0; s < seeds; ++s) {
      const SeedResult& result = results[r * seeds + s];
      count(outcome.alarms, result.right.stopped[judge] != 0);
      count(outcome.alarms_planned, result.right.planned[judge] != 0);
      suite[s] |= result.right.planned[judge];
      for (std::size_t w = 0; w < times.size(); ++w) {
        count(outcome.kills, result.wrong[w].stopped[judge] != 0);
        count(outcome.kills_planned, result.wrong[w].planned[judge] != 0);
        times[w] += result.wrong[w].planned[judge] != 0 ? 1 : 0;
      }
    }
    for (std::size_t w = 0; w < times.size(); ++w) {
      bool& always = killed[rows[r].faults[w]];
      always = always || times[w] == seeds;
    }
  }
  for (char failed : suite) count(outcome.suites, failed != 0);
  for (const auto& [fault, always] : killed) {
    count(outcome.faults, always);
    if (!always) outcome.missed.push_back(fault->name);
  }
  return outcome;
}

JudgesOutcome summary(const std::vector<Row>& rows, const std::vector<Plan>& plans,
                      const std::vector<SeedResult>& results, std::size_t seeds) {
  JudgesOutcome outcome{{}, static_cast<int>(rows.size()), 0, 0};
  for (const Row& row : rows) outcome.cells += static_cast<int>(row.wrong.size());
  for (const Plan& plan : plans) outcome.planned_draws += static_cast<double>(plan.draws);
  outcome.judges.push_back(outcome_of(0, "fairlight", rows, results, seeds));
  for (std::size_t j = 0; j < judges().size(); ++j) {
    outcome.judges.push_back(outcome_of(j + 1, judges()[j].name, rows, results, seeds));
  }
  return outcome;
}

}  // namespace

JudgesOutcome audit_judges(const RunOptions& run_options, int seeds, const Progress& progress) {
  const std::vector<Row> rows = rows_of_catalogue(run_options);
  const Manifest manifest = manifest_of(run_options);
  const auto per_row = static_cast<std::size_t>(seeds);
  std::vector<Plan> plans(rows.size());
  std::vector<SeedResult> results(rows.size() * per_row);
  const auto part = [&](double from, double share) -> Progress {
    return [=, &progress](double done) {
      if (progress) progress(from + share * done);
    };
  };
  const double planning = 1.0 / (1 + seeds);
  const auto plan = [&](std::size_t r) { plans[r] = plan_of(rows[r], manifest.trial(rows[r].right->name)); };
  for_each_unit(rows.size(), run_options.threads, plan, part(0, planning));
  const auto judge = [&](std::size_t i) {
    const Row& row = rows[i / per_row];
    const Plan& planned = plans[i / per_row];
    Trial trial = manifest.trial(row.right->name);
    trial.seed += 1 + i % per_row;
    results[i].right = failures_of(*row.right, trial, planned);
    for (const Claim* wrong : row.wrong) results[i].wrong.push_back(failures_of(*wrong, trial, planned));
  };
  for_each_unit(results.size(), run_options.threads, judge, part(planning, 1 - planning));
  return summary(rows, plans, results, per_row);
}

}  // namespace fairlight
