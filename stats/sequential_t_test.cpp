#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <fairlight/stats/arms.h>
#include <fairlight/stats/sequential_t_test.h>
#include <fairlight/stats/text.h>

namespace fairlight {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr int looks = 6;
constexpr std::uint64_t shortest_pilot = 4096, largest_block = 65536;
// After so many equal draws the pilot takes them for a constant, and after so many with a slow tail
// it takes the variance for infinite.
constexpr std::uint64_t constant_after = 1u << 24, heavy_after = 1u << 16, heavy_for_sure_after = 1u << 22;
constexpr double largest_variance_of_variance = 0.01;  // about a hundred of the draws that matter
const double most_skew = 3 * std::log(1.5);
constexpr double part_for_giving_up = 0.02;  // of alpha
constexpr double part_of_first_round = 0.9;  // of beta; the next has 0.9 of the rest, and so on

constexpr const char* heavy_tail =
    "tail: the largest draws fall too slowly for a finite variance (declare a range: fairlight::bounded)";

double normal_quantile(double tail) { return -boost::math::quantile(boost::math::normal(), tail); }

class GroupSequential {
 public:
  GroupSequential(const Trial& trial, const UnboundedMean& claim, std::size_t arms, const DrawBlock& draw_block)
      : trial_(trial), claim_(claim), draw_block_(draw_block), arms_(arms) {
    check_trial(trial);
    if (!(claim.scale > 0 && std::isfinite(claim.scale))) {
      throw std::invalid_argument(
          "the scale of a margin must be positive and finite (give one: fairlight::absolute)");
    }
    if (!std::isfinite(claim.mean)) throw std::invalid_argument("the reference must be a finite number");
    add_betting();
  }

  // A round is a pilot, discarded, and its looks. Where the looks meet what the pilot had not met,
  // or a mean that is off, all draws so far become the pilot of the next round.
  Finding run() try {
    std::uint64_t pilot = shortest_pilot;
    double beta = trial_.beta * part_of_first_round;
    for (bool searched = false;; beta *= 1 - part_of_first_round) {
      draw_pilot(pilot);
      if (hopeless()) return ended(heavy_tail);
      auto counts = plan(beta);
      // A mean that was off is looked for among as many draws as the pilot has.
      for (std::uint64_t& count : counts) count = std::max(count, searched ? arms_.count() : 0);
      total_ = counts.back();
      arms_ = Arms(arms_.size());
      const Finding finding = look_until_decided(counts, beta);
      if (finding.verdict != Verdict::undecided || end_ == End::final || (end_ == End::off && searched))
        return finding;
      searched = end_ == End::off;
      pilot = std::max<std::uint64_t>({heavy_after, 16 * arms_.count(), 2 * pilot});
    }
  } catch (const NoMoreDraws& spent) {
    return ended(std::string(spent.what()) + needed());
  } catch (const Told&) {
    return ended(told_to_end);
  } catch (const Refuted&) {
    return refuted();
  }

 private:
  struct Told {};     // Trial::watch ended the test
  struct Refuted {};  // by betting
  // Why looks end without a certificate: the mean is off, or the draws are wilder than the pilot's,
  // or neither would change.
  enum class End { off, wild, final };

  double margin() const { return trial_.margin * claim_.scale; }

  // Betting against the end of the range that is declared; it counts the pilot's draws too.
  void add_betting() {
    const bool above = std::isfinite(claim_.lower) && claim_.sides != Sides::not_below;
    const bool below = std::isfinite(claim_.upper) && claim_.sides != Sides::not_above;
    if (!above && !below) return;
    const double m = margin(), mean = claim_.mean;
    const Sides sides = above && below ? Sides::both : above ? Sides::not_above : Sides::not_below;
    betting_.emplace(MeanHypothesis{mean, m, std::min(claim_.lower, mean - 2 * m),
                                    std::max(claim_.upper, mean + 2 * m), 0, sides},
                     trial_.alpha * (1 - part_for_giving_up), trial_.beta);
  }

  void bet(std::span<const double> draws) {
    for (std::size_t i = 0; i < draws.size();) {
      const std::size_t size = std::min<std::size_t>(draws.size() - i, betting_->block_size());
      betting_->add(draws.subspan(i, size));
      i += size;
    }
    if (betting_->verdict() == Verdict::biased) throw Refuted();
  }

  void draw_to(std::uint64_t count, std::uint64_t total) {
    std::vector<std::vector<double>> channels(arms_.size());
    while (arms_.count() < count) {
      const std::uint64_t so_far = arms_.count();
      if (so_far > 0 && !goes_on(trial_, static_cast<double>(so_far) / static_cast<double>(total))) throw Told();
      const std::uint64_t block = std::min({count - so_far, largest_block, std::max<std::uint64_t>(so_far, 64)});
      for (auto& channel : channels) channel.resize(block);
      draw_block_(drawn_, channels);
      for (std::size_t a = 0; a < channels.size(); ++a) arms_.add(a, drawn_, channels[a]);
      if (betting_) bet(channels[0]);
      drawn_ += block;
    }
  }

  void draw_pilot(std::uint64_t least) {
    draw_to(least, 2 * least);
    while (!met_enough()) draw_to(2 * arms_.count(), 4 * arms_.count());
  }

  // Whether a plan can be made of these draws, or none ever.
  bool met_enough() const {
    if (arms_.constant(claim_.scale)) return arms_.count() >= constant_after;
    return arms_.variance_of_variance() <= largest_variance_of_variance ||
           (arms_.count() >= heavy_after && hopeless());
  }

  // A heavy tail in which a few draws hold the variance: more of them would not change that.
  bool hopeless() const {
    return arms_.heavy() && arms_.variance_of_variance() > 10 * largest_variance_of_variance;
  }

  // The numbers of draws per arm of the looks, in geometric progression. The last is enough for the
  // margin, and for the skewness at both levels, of a bias and of a miss. The first is a quarter
  // of what the margin takes, and enough for the skewness at the miss rate. The pilot's variance is
  // increased by 5.5 of its own standard errors, from its fourth moments.
  std::array<std::uint64_t, looks> plan(double all_beta) const {
    const double level = trial_.alpha * (1 - part_for_giving_up) / 4;
    const double least_beta = all_beta / looks;
    const double root = normal_quantile(trial_.alpha * part_for_giving_up / 2) + normal_quantile(least_beta);
    const auto n = static_cast<double>(arms_.count());
    const double widened = 1 + 5.5 * std::sqrt(arms_.variance_of_variance());
    const double precision = widened * root * root * arms_.squared_error() * n / (margin() * margin());
    const double skew = arms_.squared_error() > 0 ? arms_.skewness_of_mean() * std::sqrt(n) : 0;
    const auto guard = [&](double x) { return std::pow(widened, 3) * std::pow(skew * x * x * x / most_skew, 2); };
    const double last =
        std::ceil(std::max({precision, guard(normal_quantile(std::min(level, least_beta))), 1000.0}));
    if (!(last < 1e15))
      throw std::invalid_argument("the margin asks for more than 10^15 draws (give a larger one)");
    const double first = std::min(last / 4, std::max({precision / 4, guard(normal_quantile(least_beta)), 250.0}));
    std::array<std::uint64_t, looks> counts;
    for (int i = 0; i < looks; ++i)
      counts[static_cast<std::size_t>(i)] =
          static_cast<std::uint64_t>(std::ceil(last * std::pow(first / last, 1 - i / (looks - 1.0))));
    return counts;
  }

  // Each look has an equal part of beta. By the fraction f of the draws alpha f^3 is spent on a mean
  // that is off (Kim and DeMets 1987), which ends the round.
  Finding look_until_decided(const std::array<std::uint64_t, looks>& counts, double all_beta) {
    double spent = 0;
    Finding finding;
    for (const std::uint64_t count : counts) {
      if (count == arms_.count()) continue;
      draw_to(count, total_);
      const double alpha = trial_.alpha * (1 - part_for_giving_up) *
                           std::pow(static_cast<double>(count) / static_cast<double>(total_), 3);
      finding = look(alpha - spent, all_beta / looks);
      if (finding.verdict == Verdict::certified || end_ == End::off) break;
      spent = alpha;
    }
    return finding;
  }

  Finding look(double alpha, double beta) {
    Finding finding = so_far(beta);
    end_ = End::final;
    if (arms_.constant(claim_.scale)) {
      finding.note = formatted("no variance in %llu draws (declare a range, or compare every draw)",
                               static_cast<unsigned long long>(drawn_));
      return finding;
    }
    const double off = std::abs(excess(arms_.difference() - claim_.mean)) / std::sqrt(arms_.squared_error());
    const bool both = claim_.sides == Sides::both;
    if (arms_.heavy()) {
      if (!hopeless()) end_ = End::wild;
      finding.note = heavy_tail;
    } else if (!trusted(normal_quantile(beta))) {
      end_ = End::wild;
      finding.note = "tail: the draws are too skew for their number (declare a range: fairlight::bounded)";
    } else if (std::max(excess(finding.interval.lo), excess(finding.interval.hi)) < trial_.margin &&
               std::min(excess(finding.interval.lo), excess(finding.interval.hi)) > -trial_.margin) {
      finding.verdict = Verdict::certified;
    } else if (trusted(normal_quantile(alpha / 2)) &&
               cdf(complement(boost::math::students_t(arms_.degrees()), off)) < (both ? alpha / 2 : alpha)) {
      end_ = End::off;
      finding.note = note_on_bias(off);
    } else {
      finding.note = "the cap on draws came first (the bias is near the margin)";
    }
    return finding;
  }

  // A bias that counts: of a one-sided claim, what is in the excluded direction.
  double excess(double bias) const {
    if (claim_.sides == Sides::not_above) return std::max(bias, 0.0);
    return claim_.sides == Sides::not_below ? std::min(bias, 0.0) : bias;
  }

  // Whether Student's law holds at the normal quantile x: with g the skewness, n >= (g x^3 / (3 ln
  // 1.5))^2 keeps the tail within a factor of 1.5 (Hall 1992).
  bool trusted(double x) const { return arms_.skewness_of_mean() * x * x * x <= most_skew; }

  // The estimate and its interval, whose ends are each wrong with probability `beta`, if Student's
  // law holds.
  Finding so_far(double beta) const {
    Finding finding{Verdict::undecided, Guarantee::asymptotic, trial_.margin};
    finding.interval = {-infinite, infinite};
    finding.draws = drawn_;
    finding.note = "asymptotic: Student's law is the limit of many draws (no range of the draws was declared)";
    if (arms_.count() < 2) return finding;
    const double bias = arms_.difference() - claim_.mean;
    finding.bias = bias / claim_.scale;
    if (arms_.constant(claim_.scale)) return finding;
    const double reach =
        std::sqrt(arms_.squared_error()) * quantile(complement(boost::math::students_t(arms_.degrees()), beta));
    const double lo = (bias - reach) / claim_.scale, hi = (bias + reach) / claim_.scale;
    finding.interval = {claim_.sides == Sides::not_above && lo <= 0 ? -infinite : lo,
                        claim_.sides == Sides::not_below && hi >= 0 ? infinite : hi};
    return finding;
  }

  std::string note_on_bias(double off) const {
    const bool low = arms_.difference() < claim_.mean;
    const char* mean = arms_.size() > 1 ? "the difference of the means" : "the mean";
    return formatted(
        "%s of %llu draws is %.0f standard errors too %s; no number of draws shows whether that is a bias, "
        "or whether the rest comes in draws too rare to be met (declare a range: %s)",
        mean, static_cast<unsigned long long>(arms_.count()), off, low ? "low" : "high",
        arms_.size() > 1 ? "fairlight::in_range(a, lower, upper), of both"
                         : "fairlight::bounded(mean, lower, upper)");
  }

  std::string needed() const {
    if (drawn_ < shortest_pilot)
      return formatted("; a pilot alone takes %d draws (allow more)", int(shortest_pilot));
    if (total_ == 0) return "; the draws that matter are too rare for a plan (declare a range: fairlight::bounded)";
    return formatted("; a verdict needs up to %.1e draws (allow more, or a larger margin)",
                     static_cast<double>(total_));
  }

  Finding ended(const std::string& note) const {
    Finding finding = so_far(trial_.beta);
    finding.note = note;
    return finding;
  }

  Finding refuted() const {
    Finding finding{Verdict::biased, Guarantee::exact, trial_.margin};
    const auto relative = [this](double x) { return (x - claim_.mean) / claim_.scale; };
    const Interval interval = betting_->interval();
    finding.bias = relative(betting_->moments().mean());
    finding.interval = {relative(interval.lo), relative(interval.hi)};
    finding.draws = betting_->moments().count();
    return finding;
  }

  const Trial& trial_;
  UnboundedMean claim_;
  const DrawBlock& draw_block_;
  Arms arms_;
  std::optional<BettingTest> betting_;
  std::uint64_t drawn_ = 0, total_ = 0;
  End end_ = End::final;
};

Finding run(const Trial& trial, const UnboundedMean& claim, std::size_t arms, const DrawBlock& draw_block) try {
  return with_token(trial, GroupSequential(trial, claim, arms, draw_block).run());
} catch (const BadDraw& bad) {
  Finding finding{Verdict::biased, Guarantee::deterministic, trial.margin};
  finding.draws = bad.draw() + 1;
  finding.note = bad.what();
  return with_token(trial, finding);
}

}  // namespace

Finding sequential_t_test(const Trial& trial, const UnboundedMean& claim, const DrawBlock& draw_block) {
  return run(trial, claim, 1, draw_block);
}

Finding sequential_welch_test(const Trial& trial, double scale, const DrawBlock& draw_block) {
  return run(trial, {0, scale}, 2, draw_block);
}

}  // namespace fairlight
