#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <fairlight/stats/sequential_t_test.h>
#include <fairlight/stats/tail.h>

namespace fairlight {
namespace {

constexpr std::array<double, 6> looks{1. / 4, 1. / 3, 1. / 2, 2. / 3, 5. / 6, 1};
constexpr std::uint64_t pilot_draws = 4096;
constexpr std::uint64_t largest_block = 65536;
constexpr double least_slope = 3;
constexpr double part_for_giving_up = 0.02;  // of alpha

double normal_quantile(double tail) { return -boost::math::quantile(boost::math::normal(), tail); }

// The samples of the arms: one arm, or two whose difference is tested.
struct Arms {
  std::vector<Moments> moments;
  std::vector<LargestScores> scores;

  explicit Arms(std::size_t n) : moments(n), scores(n) {}

  double difference() const { return moments[0].mean() - (moments.size() > 1 ? moments[1].mean() : 0); }

  double squared_error() const {
    double sum = 0;
    for (const Moments& m : moments) sum += m.variance() / static_cast<double>(m.count());
    return sum;
  }

  // Degrees of freedom after Welch and Satterthwaite; n - 1 for one arm.
  double degrees() const {
    double sum = 0;
    for (const Moments& m : moments) {
      const double part = m.variance() / static_cast<double>(m.count());
      sum += part * part / static_cast<double>(m.count() - 1);
    }
    return squared_error() * squared_error() / sum;
  }

  // The skewness of the standardised mean, as if the skewnesses of the arms never cancelled.
  double skewness_of_mean() const {
    double third = 0;
    for (const Moments& m : moments) {
      const auto n = static_cast<double>(m.count());
      third += std::abs(m.skewness()) * std::pow(m.variance(), 1.5) / (n * n);
    }
    return third / std::pow(squared_error(), 1.5);
  }

  double variance_of_variance() const {
    double largest = 0;
    for (const Moments& m : moments) largest = std::max(largest, m.variance_of_variance());
    return largest;
  }

  double slope() const {
    double least = std::numeric_limits<double>::infinity();
    for (const LargestScores& s : scores) least = std::min(least, s.slope());
    return least;
  }
};

class GroupSequential {
 public:
  GroupSequential(const Trial& trial, double mean, double scale, std::size_t arms, const DrawBlock& draw_block)
      : trial_(trial), mean_(mean), scale_(scale), draw_block_(draw_block), arms_(arms) {
    check_trial(trial);
    if (!(scale > 0 && std::isfinite(scale))) {
      throw std::invalid_argument("the scale of a margin must be positive and finite");
    }
  }

  Finding run() {
    draw_to(pilot_draws, pilot_draws);
    const std::uint64_t total = plan();
    arms_ = Arms(arms_.moments.size());
    double spent_alpha = 0;
    double spent_beta = 0;
    for (double fraction : looks) {
      if (!draw_to(static_cast<std::uint64_t>(std::ceil(fraction * static_cast<double>(total))), total))
        return ended();
      const double alpha = trial_.alpha * (1 - part_for_giving_up) * std::pow(fraction, 3);
      const double beta = trial_.beta * fraction;
      Finding finding = look(alpha - spent_alpha, beta - spent_beta);
      if (finding.verdict != Verdict::undecided || fraction == 1) return finding;
      spent_alpha = alpha;
      spent_beta = beta;
    }
    throw std::logic_error("the last look ends the test");
  }

 private:
  double margin() const { return trial_.margin * scale_; }

  Finding ended() const {
    Finding finding{Verdict::undecided, Guarantee::asymptotic, trial_.margin};
    finding.interval = {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    finding.draws = drawn_;
    finding.note = told_to_end;
    return finding;
  }

  // Draws until each arm has `count` draws. Returns false if `watch` ended the test first.
  bool draw_to(std::uint64_t count, std::uint64_t total) {
    std::vector<std::vector<double>> channels(arms_.moments.size());
    while (arms_.moments[0].count() < count) {
      const std::uint64_t so_far = arms_.moments[0].count();
      if (so_far > 0 && !goes_on(trial_, static_cast<double>(so_far) / static_cast<double>(total))) return false;
      const std::uint64_t block = std::min(count - so_far, largest_block);
      for (auto& channel : channels) channel.resize(block);
      draw_block_(drawn_, channels);
      drawn_ += block;
      for (std::size_t a = 0; a < channels.size(); ++a) add(a, channels[a]);
    }
    return true;
  }

  void add(std::size_t arm, const std::vector<double>& draws) {
    const Moments block = Moments::of(draws);
    if (!std::isfinite(block.minimum()) || !std::isfinite(block.maximum())) {
      const auto bad = std::find_if(draws.begin(), draws.end(), [](double x) { return !std::isfinite(x); });
      throw BadDraw(drawn_ - draws.size() + static_cast<std::uint64_t>(bad - draws.begin()), *bad,
                    "not a finite number");
    }
    arms_.moments[arm].merge(block);
    arms_.scores[arm].add(draws);
  }

  // The number of draws per arm at the last look: enough for the margin, and for the skewness at
  // that look's level. The pilot's variance is increased by 5.5 of its own standard errors, from
  // its fourth moments.
  std::uint64_t plan() const {
    const double last_step = 1 - std::pow(looks[looks.size() - 2], 3);
    const double x = normal_quantile(trial_.alpha * last_step / 2);
    const double reach = normal_quantile(trial_.alpha * part_for_giving_up / 2);
    const double root = reach + normal_quantile(trial_.beta / static_cast<double>(looks.size()));
    const auto n = static_cast<double>(pilot_draws);
    const double widened = 1 + 5.5 * std::sqrt(arms_.variance_of_variance());
    const double precision = widened * root * root * arms_.squared_error() * n / (margin() * margin());
    const double skew = arms_.squared_error() > 0 ? arms_.skewness_of_mean() * std::sqrt(n) : 0;
    const double guard = std::pow(widened, 3) * std::pow(skew * x * x * x / (3 * std::log(1.5)), 2);
    const double draws = std::ceil(std::max({precision, guard, 1000.0}));
    if (!(draws < 1e15))
      throw std::invalid_argument("the margin asks for more than 10^15 draws (give a larger one)");
    return static_cast<std::uint64_t>(draws);
  }

  Finding look(double alpha, double beta) const {
    const double bias = arms_.difference() - mean_;
    Finding finding{Verdict::undecided, Guarantee::asymptotic, trial_.margin, bias / scale_};
    finding.draws = drawn_;
    finding.note = "asymptotic: Student's law is the limit of many draws (no range of the draws was declared)";
    if (constant()) {
      finding.note = "no variance in " + std::to_string(drawn_) + " draws (declare a range, or compare every draw)";
      return finding;
    }
    const double error = std::sqrt(arms_.squared_error());
    const boost::math::students_t law(arms_.degrees());
    const double reach = error * quantile(complement(law, beta));
    finding.interval = {(bias - reach) / scale_, (bias + reach) / scale_};
    const std::string tail = distrust(alpha);
    if (!tail.empty()) {
      finding.note = tail;
    } else if (2 * cdf(complement(law, std::abs(bias) / error)) < alpha) {
      finding.verdict = Verdict::biased;
    } else if (std::abs(bias) + reach < margin()) {
      finding.verdict = Verdict::certified;
    }
    return finding;
  }

  // Whether all draws agree to rounding. Then Student's test cannot tell a constant from an
  // estimator whose mean lies in draws too rare to have been met.
  bool constant() const {
    return std::all_of(arms_.moments.begin(), arms_.moments.end(), [this](const Moments& m) {
      return m.maximum() - m.minimum() <= 16 * std::numeric_limits<double>::epsilon() * scale_;
    });
  }

  // Why Student's law cannot be trusted at this level; empty if it can. With x the normal quantile
  // and g the skewness, n >= (g x^3 / (3 ln 1.5))^2 keeps the tail within a factor of 1.5 (Hall
  // 1992).
  std::string distrust(double alpha) const {
    const double x = normal_quantile(alpha / 2);
    if (arms_.skewness_of_mean() * x * x * x > 3 * std::log(1.5))
      return "tail: the draws are too skew for their number";
    if (arms_.slope() < least_slope) return "tail: the largest draws fall too slowly for a finite variance";
    return {};
  }

  const Trial& trial_;
  double mean_, scale_;
  const DrawBlock& draw_block_;
  Arms arms_;
  std::uint64_t drawn_ = 0;
};

Finding run(const Trial& trial, double mean, double scale, std::size_t arms, const DrawBlock& draw_block) {
  try {
    return with_token(trial, GroupSequential(trial, mean, scale, arms, draw_block).run());
  } catch (const BadDraw& bad) {
    Finding finding{Verdict::biased, Guarantee::deterministic, trial.margin};
    finding.draws = bad.draw() + 1;
    finding.note = bad.what();
    return with_token(trial, finding);
  }
}

}  // namespace

Finding sequential_t_test(const Trial& trial, double mean, double scale, const DrawBlock& draw_block) {
  return run(trial, mean, scale, 1, draw_block);
}

Finding sequential_welch_test(const Trial& trial, double scale, const DrawBlock& draw_block) {
  return run(trial, 0, scale, 2, draw_block);
}

}  // namespace fairlight
