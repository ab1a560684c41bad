#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include <fairlight/render/parallel.h>
#include <fairlight/validation/run/clock.h>
#include <fairlight/validation/run/forecast.h>
#include <fairlight/validation/run/registry.h>
#include <fairlight/validation/run/run_claims.h>

namespace fairlight {
namespace {

constexpr double first_turn = 0.002;  // seconds
constexpr double soon = 0.2;          // seconds: a claim that ends within these goes on
constexpr double between_words = 0.05;
constexpr double unlimited = std::numeric_limits<double>::infinity();

// Says in a note why a test was told to end; what else the note says stays.
void say_time_was_up(std::string& note) {
  const std::string reason = "the time was up before its verdict";
  const std::size_t at = note.find(told_to_end);
  if (at != std::string::npos) {
    note.replace(at, std::string(told_to_end).size(), reason);
  } else {
    note = note.empty() ? reason : note + "; " + reason;
  }
}

// The largest log wealth against a claim, of any channel.
double against(const MarginGrid& margin_grid) {
  double most = 0;
  for (const auto& channel : margin_grid.channels) {
    for (const Wealth& wealth : channel) most = std::max({most, wealth.above_reference, wealth.below_reference});
  }
  return most;
}

class Run {
 public:
  Run(const std::vector<const Claim*>& claims, const RunOptions& run_options, const Progress& progress)
      : claims_(claims),
        options_(run_options),
        manifest_(manifest_of(run_options)),
        progress_(progress),
        forecast_(claims.size()),
        ended_(claims.size(), 1) {
    for (const Claim* claim : claims) outcomes_.push_back({claim, not_begun(claim), 0});
  }

  std::vector<Outcome> outcomes() {
    std::vector<std::size_t> all(claims_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    take_turns(all, first_turn);
    take_turns(second_turns(), unlimited);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!ended_[i]) continue;
      outcomes_[i].out_of_time = true;
      if (outcomes_[i].seconds > 0) say_time_was_up(outcomes_[i].finding.note);
    }
    if (progress_) progress_(1);
    return outcomes_;
  }

 private:
  Finding not_begun(const Claim* claim) const {
    const Trial trial = manifest_.trial(claim->name);
    Finding finding{Verdict::undecided, Guarantee::exact, trial.margin};  // that nothing is known
    finding.interval = {-unlimited, unlimited};
    finding.note = "the time was up before its turn";
    return with_token(trial, finding);
  }

  bool time_is_up() const { return clock_.seconds() > options_.seconds || (options_.fail_fast && one_failed_); }

  void take_turns(const std::vector<std::size_t>& order, double most) {
    for_each_unit(order.size(), options_.threads, [&](std::size_t unit) {
      if (!time_is_up()) take_turn(order[unit], most);
    });
  }

  // Runs a claim from its start, for at most `most` seconds after its first draws. The time before
  // them, such as for the quadrature of a law, says nothing of the cost of draws. A turn lasts at
  // least as long as this time, since a second turn repeats that work. Where there is no time
  // limit, a claim that is about to finish goes on.
  void take_turn(std::size_t i, double most) {
    const Clock clock;
    Turn turn{outcomes_[i].seconds};
    Outcome outcome{claims_[i], {}, 0};
    Trial trial = manifest_.trial(claims_[i]->name);
    trial.watch = [&](double done) { return goes_on(i, turn, clock.seconds(), done, most); };
    outcome.evidence.courses = options_.evidence;
    if (options_.evidence || claims_[i]->adds_up) trial.evidence = &outcome.evidence;
    outcome.finding = check(*claims_[i], trial);
    outcome.seconds = clock.seconds();
    ended_[i] = turn.ended && outcome.finding.verdict == Verdict::undecided;
    foresee(i, turn.before + outcome.seconds, ended_[i] ? outcome.seconds + turn.left : 0);
    outcomes_[i] = std::move(outcome);
    if (!ended_[i] && outcomes_[i].finding.verdict != Verdict::certified) one_failed_ = true;
  }

  // Adds the name of the claim to what its test refuses.
  static Finding check(const Claim& claim, const Trial& trial) try {
    return claim.check(trial);
  } catch (const std::invalid_argument& refused) {
    throw std::invalid_argument("\"" + claim.name + "\" cannot be tested on these terms (" + refused.what() + ")");
  }

  struct Turn {
    double before;     // seconds of the earlier turn
    double first = 0;  // seconds at its first progress report
    double first_done = 0;
    double told = 0;  // seconds at the last update of the forecast
    double left = 0;  // expected seconds until its verdict
    bool ended = false;
  };

  bool goes_on(std::size_t i, Turn& turn, double now, double done, double most) {
    if (turn.first == 0) {
      turn.first = now;
      turn.first_done = done;
    }
    turn.left =
        done > turn.first_done ? (now - turn.first) * (1 - done) / (done - turn.first_done) : now / done - now;
    const bool near = options_.seconds == unlimited && turn.left < soon;
    turn.ended = turn.ended || (now - turn.first > std::max(most, turn.first) && !near) || time_is_up();
    if (turn.ended || now - turn.told > between_words) {
      turn.told = now;
      foresee(i, turn.before + now, turn.left);
    }
    return !turn.ended;
  }

  void foresee(std::size_t i, double spent, double left) {
    const std::lock_guard lock(mutex_);
    forecast_.set(i, spent, left);
    if (progress_)
      progress_(std::clamp(std::max(forecast_.done(), clock_.seconds() / options_.seconds), 1e-9, 0.999));
  }

  std::vector<std::size_t> second_turns() const {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < claims_.size(); ++i) {
      if (ended_[i]) order.push_back(i);
    }
    const auto unsuspected = [this](std::size_t i) {
      const Interval& interval = outcomes_[i].finding.interval;
      const double wealth = against(outcomes_[i].evidence.margin_grid);
      return interval.lo <= 0 && interval.hi >= 0 && wealth < -std::log(options_.terms.beta);
    };
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
      if (options_.seconds == unlimited) return forecast_.left(a) > forecast_.left(b);
      if (unsuspected(a) != unsuspected(b)) return unsuspected(b);
      return forecast_.left(a) < forecast_.left(b);
    });
    return order;
  }

  const std::vector<const Claim*>& claims_;
  const RunOptions& options_;
  const Manifest manifest_;
  const Progress& progress_;
  const Clock clock_;
  std::mutex mutex_;
  Forecast forecast_;
  std::vector<Outcome> outcomes_;
  std::atomic<bool> one_failed_ = false;
  std::vector<char> ended_;  // whether it has no verdict: not yet begun, or stopped
};

}  // namespace

Manifest manifest_of(const RunOptions& run_options) {
  std::vector<Manifest::Row> rows;
  const std::vector<std::string>& sets = run_options.instructions;
  for (const Claim& c : registry(sets.front()))
    rows.push_back({c.name, c.weight, c.margin_factor, c.finest_margin});
  Manifest::Terms terms = run_options.terms;
  terms.budget /= static_cast<double>(sets.size());
  terms.joint_part = part_for_components;
  return Manifest(rows, terms);
}

std::vector<Outcome> run_claims(const std::vector<const Claim*>& claims, const RunOptions& run_options,
                                const Progress& progress) {
  if (!(run_options.seconds > 0))
    throw std::invalid_argument("the seconds of a run must be positive (it has to begin)");
  return Run(claims, run_options, progress).outcomes();
}

bool failed(const Outcome& outcome) {
  const Verdict verdict = outcome.finding.verdict;
  return verdict == Verdict::biased || (verdict == Verdict::undecided && !outcome.out_of_time);
}

Verdict overall(const std::vector<Outcome>& outcomes) {
  Verdict verdict = Verdict::certified;
  for (const Outcome& outcome : outcomes) verdict = worse(verdict, outcome.finding.verdict);
  return verdict;
}

}  // namespace fairlight
