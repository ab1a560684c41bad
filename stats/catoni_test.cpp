#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <boost/math/tools/roots.hpp>

#include <fairlight/stats/catoni_test.h>
#include <fairlight/stats/text.h>

namespace fairlight {
namespace {

constexpr double part_for_giving_up = 0.02;  // of alpha
// U0 and D0 bet these multiples of the best bet, with these parts of their wealth. The interval
// takes the whole mixture, and so shows whatever the first part shows.
constexpr std::array<double, 3> factors{1.0, 2.5, 8.0}, weights{0.8, 0.1, 0.1};
// The bets that the squared deviations exceed V, divided by 1 / V.
constexpr std::array<double, 3> square_bets{0.01, 0.1, 0.5};

double influence(double x) {
  const double size = std::abs(x);
  return std::copysign(std::log1p(size + size * size / 2), x);
}

double log_mixture(const std::array<double, 3>& logs) {
  const double top = *std::ranges::max_element(logs);
  double sum = 0;
  for (std::size_t i = 0; i < logs.size(); ++i) sum += weights[i] * std::exp(logs[i] - top);
  return top + std::log(sum);
}

class Catoni {
 public:
  Catoni(const Trial& trial, const FiniteVariance& claim, double scale)
      : trial_(trial), claim_(claim), scale_(scale), margin_(trial.margin * scale) {
    check_trial(trial);
    if (!(scale > 0 && std::isfinite(scale)))
      throw std::invalid_argument("the scale of a margin must be positive and finite");
    if (!std::isfinite(claim.mean)) throw std::invalid_argument("the reference must be a finite number");
    if (!(claim.variance > 0 && std::isfinite(claim.variance)))
      throw std::invalid_argument("the declared variance must be positive and finite");
    const double draws = claim.variance / (margin_ * margin_);
    if (!(draws < 1e12))
      throw std::invalid_argument("the margin asks for more than 10^13 draws (give a larger one)");
    block_ = static_cast<std::size_t>(std::max(1.0, draws / blocks_a_unit));
    bet_ = margin_ * static_cast<double>(block_) / claim.variance;
    cap_ = drift_to_wait_for(trial.alpha * part_for_giving_up, trial.beta) * std::max(draws, 1.0);
  }

  Finding run(const DrawBlock& draw_block) {
    std::string note =
        formatted("exact, given that the variance is at most %g, which is taken on trust", claim_.variance);
    Verdict verdict = Verdict::undecided;
    std::vector<std::vector<double>> channels(1, std::vector<double>(block_));
    try {
      for (; verdict == Verdict::undecided; verdict = decide()) {
        const auto n = static_cast<double>(moments_.count());
        if (n > cap_) return finding(verdict, "the cap on draws came first");
        if (n > 0 && !goes_on(trial_, n / (cap_ + n))) return finding(verdict, told_to_end);
        draw_block(moments_.count(), channels);
        add(channels[0]);
      }
    } catch (const NoMoreDraws& spent) {
      return finding(verdict, formatted("%s; a verdict needs about %.1e draws (allow more, or a larger margin)",
                                        spent.what(), cap_ / 4));
    }
    return finding(verdict, squares_refute() ? note_on_squares() : note);
  }

 private:
  static constexpr double blocks_a_unit = 32;  // of variance / margin^2 draws: the loss is of its inverse

  void add(const std::vector<double>& draws) {
    for (std::size_t i = 0; i < draws.size(); ++i) {
      if (!std::isfinite(draws[i])) throw BadDraw(moments_.count() + i, draws[i], "not a finite number");
      const double square = std::pow(draws[i] - claim_.mean, 2) / claim_.variance - 1;
      for (std::size_t k = 0; k < square_bets.size(); ++k) squares_[k] += std::log1p(square_bets[k] * square);
    }
    const Moments block = Moments::of(draws);
    moments_.merge(block);
    means_.push_back(block.mean());
    for (std::size_t k = 0; k < factors.size(); ++k) {
      above_reference_[k] += log_gain(true, block.mean(), claim_.mean, factors[k]);
      below_reference_[k] += log_gain(false, block.mean(), claim_.mean, factors[k]);
    }
    above_lower_ += log_gain(true, block.mean(), claim_.mean - margin_, 1);
    below_upper_ += log_gain(false, block.mean(), claim_.mean + margin_, 1);
  }

  // What a block adds to the log wealth of betting `factor` times the best bet that the mean is
  // above c, or below it.
  double log_gain(bool above, double mean, double c, double factor) const {
    const double bet = factor * bet_;
    const double variance = claim_.variance / static_cast<double>(block_);
    return (above ? 1 : -1) * influence(bet * (mean - c)) - std::log1p(bet * bet * variance / 2);
  }

  double log_mixed(bool above, double c) const {
    std::array<double, 3> logs{};
    for (std::size_t k = 0; k < logs.size(); ++k) {
      for (double mean : means_) logs[k] += log_gain(above, mean, c, factors[k]);
    }
    return log_mixture(logs);
  }

  // Three processes refute: above, below, and the squares.
  double refuting() const { return std::log(3 / (trial_.alpha * (1 - part_for_giving_up))); }
  bool squares_refute() const { return log_mixture(squares_) >= refuting(); }

  Verdict decide() const {
    if (log_mixture(above_reference_) >= refuting() || log_mixture(below_reference_) >= refuting() ||
        squares_refute())
      return Verdict::biased;
    const double certifying = std::log(1 / trial_.beta);
    return above_lower_ >= certifying && below_upper_ >= certifying ? Verdict::certified : Verdict::undecided;
  }

  // The candidate against which the mixture has not reached 0.8/beta: wrong with probability at most
  // 1.25 beta. The evidence falls as the candidate moves towards the draws.
  double end_of_interval(bool above) const {
    const double enough = std::log(weights[0] / trial_.beta), sign = above ? -1 : 1;
    const auto lacks = [&](double c) { return enough - log_mixed(above, c); };
    double reach = margin_;
    const double from = moments_.mean();
    if (lacks(from) < 0) return from;
    for (int doublings = 0; lacks(from + sign * reach) > 0; reach *= 2) {
      if (++doublings > 60) return sign * std::numeric_limits<double>::infinity();
    }
    const double far = from + sign * reach;
    const auto near_enough = [&](double a, double b) { return b - a < 1e-6 * margin_; };
    const auto bracket = boost::math::tools::bisect(lacks, std::min(from, far), std::max(from, far), near_enough);
    return above ? bracket.first : bracket.second;
  }

  std::string note_on_squares() const {
    return formatted(
        "the draws lie farther from the reference than a variance of %g allows: their mean squared distance "
        "is %g (the reference is wrong, or the declared variance)",
        claim_.variance,
        moments_.squared_deviations() / static_cast<double>(moments_.count()) +
            std::pow(moments_.mean() - claim_.mean, 2));
  }

  Finding finding(Verdict verdict, const std::string& note) const {
    const auto relative = [this](double x) { return (x - claim_.mean) / scale_; };
    Finding finding{verdict, Guarantee::exact_given_tail, trial_.margin};
    finding.bias = relative(moments_.mean());
    finding.interval = {relative(end_of_interval(true)), relative(end_of_interval(false))};
    finding.draws = moments_.count();
    finding.note = note;
    return finding;
  }

  const Trial& trial_;
  FiniteVariance claim_;
  double scale_, margin_;
  std::size_t block_ = 1;
  double bet_ = 0, cap_ = 0;
  Moments moments_;
  std::vector<double> means_;
  std::array<double, 3> above_reference_{}, below_reference_{}, squares_{};  // logs, one per part of the mixture
  double above_lower_ = 0, below_upper_ = 0;
};

}  // namespace

Finding catoni_test(const Trial& trial, const FiniteVariance& claim, double scale, const DrawBlock& draw_block) {
  try {
    return with_token(trial, Catoni(trial, claim, scale).run(draw_block));
  } catch (const BadDraw& bad) {
    Finding finding{Verdict::biased, Guarantee::deterministic, trial.margin};
    finding.draws = bad.draw() + 1;
    finding.note = bad.what();
    return with_token(trial, finding);
  }
}

}  // namespace fairlight
