#include <algorithm>
#include <stdexcept>

#include <fairlight/stats/manifest.h>
#include <fairlight/stats/seed.h>

namespace fairlight {
namespace {

std::vector<double> weights_of(const std::vector<Manifest::Row>& rows) {
  std::vector<double> weights;
  for (const auto& row : rows) weights.push_back(row.weight);
  return weights;
}

// The part of the budget for each claim alone.
double budget_alone(const Manifest::Terms& terms) {
  if (!(terms.joint_part >= 0 && terms.joint_part < 1)) {
    throw std::invalid_argument("the joint part of the budget must be in [0,1) (the rest is for each claim alone)");
  }
  if (!(terms.budget > 0 && terms.budget < 1)) {
    throw std::invalid_argument("the budget must be in (0,1) (it is a probability)");
  }
  return terms.budget * (1 - terms.joint_part);
}

}  // namespace

Manifest::Manifest(std::vector<Row> rows, const Terms& terms)
    : rows_(std::move(rows)), terms_(terms), budget_(budget_alone(terms), weights_of(rows_)) {
  if (!(terms.beta > 0 && terms.beta < 1)) {
    throw std::invalid_argument("the miss rate must be in (0,1) (it is a probability)");
  }
  if (!(terms.margin > 0 && terms.margin < 1)) {
    throw std::invalid_argument("the margin must be in (0,1) (it is relative to the reference)");
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (!index_.emplace(rows_[i].name, i).second) {
      throw std::invalid_argument("two claims are named \"" + rows_[i].name +
                                  "\" (a name owns its random numbers)");
    }
    if (!(rows_[i].finest_margin >= 0 && rows_[i].finest_margin < 1)) {
      throw std::invalid_argument("the finest margin of \"" + rows_[i].name + "\" must be in [0,1)");
    }
  }
}

void check_trial(const Trial& trial) {
  for (double probability : {trial.alpha, trial.beta, trial.margin}) {
    if (!(probability > 0 && probability < 1)) {
      throw std::invalid_argument("the level, miss rate and margin of \"" + trial.claim +
                                  "\" must all be in (0,1)");
    }
  }
}

Finding with_token(const Trial& trial, Finding finding) {
  finding.token = seed_text(trial.seed);
  return finding;
}

Trial Manifest::trial(const std::string& claim) const {
  const auto found = index_.find(claim);
  if (found == index_.end()) {
    throw std::invalid_argument("\"" + claim + "\" is not in the manifest (and so has no share of the budget)");
  }
  const Row& row = rows_[found->second];
  const double margin = std::max(terms_.margin * row.margin_factor, row.finest_margin);
  if (!(margin > 0 && margin < 1)) {
    throw std::invalid_argument("the margin of \"" + claim +
                                "\" must be in (0,1) (it is the run's times its own factor, " +
                                std::to_string(row.margin_factor) + ")");
  }
  return {claim, terms_.seed, budget_.share(found->second), terms_.beta, margin};
}

}  // namespace fairlight
