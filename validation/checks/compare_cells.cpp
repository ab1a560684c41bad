#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include <boost/math/distributions/normal.hpp>

#include <fairlight/validation/checks/balanced_mean.h>
#include <fairlight/validation/checks/compare_cells.h>

namespace fairlight {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::size_t channels = PictureCells::channels;

void scale_by(SideOfCells& side, double scale) {
  for (auto& means : side.means)
    for (double& mean : means) mean *= scale;
  for (EstimatedMean& estimate : side.estimates) {
    estimate.mean *= scale;
    estimate.squared_error *= scale * scale;
  }
  for (double& rounding : side.rounding) rounding *= scale;
}

// The brightness of a picture: the sum of its channels' balanced means.
double brightness(const BalancedMean& balanced, const std::vector<double>& means) {
  double sum = 0;
  for (std::size_t c = 0; c < channels; ++c) sum += balanced.of(means, c);
  return sum;
}

EstimatedMean over_pictures(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  EstimatedMean result{0, 0, n - 1, 0};
  for (double value : values) result.mean += value / n;
  for (double value : values) result.squared_error += std::pow(value - result.mean, 2) / (n * (n - 1));
  return result;
}

EstimatedMean brightness(const BalancedMean& balanced, const SideOfCells& side) {
  std::vector<double> values;
  for (const auto& means : side.means) values.push_back(brightness(balanced, means));
  return over_pictures(values);
}

// Takes from each picture's cells the part that a change of its brightness explains, to first
// order: the error of a fitted scale then counts in the differences. part[cell] is the cell's mean
// divided by the brightness.
void remove_brightness(const BalancedMean& balanced, const std::vector<double>& part, SideOfCells& side) {
  for (auto& means : side.means) {
    const double sum = brightness(balanced, means);
    for (std::size_t cell = 0; cell < part.size(); ++cell) means[cell] -= part[cell] * sum;
  }
  for (std::size_t cell = 0; cell < part.size(); ++cell) {
    std::vector<double> values;
    for (const auto& means : side.means) values.push_back(means[cell]);
    const double skewness = side.estimates[cell].skewness;
    side.estimates[cell] = over_pictures(values);
    side.estimates[cell].skewness = skewness;
  }
}

class Comparing {
 public:
  Comparing(const PictureCells& cells, SideOfCells a, SideOfCells b, const CompareOptions& options)
      : cells_(cells), a_(std::move(a)), b_(std::move(b)), options_(options), scale_(options.scale) {
    for (double x : {options.margin, options.tile_margin, options.alpha, options.beta}) {
      if (!(x > 0 && x < 0.5)) throw std::invalid_argument("margins and levels must be in (0, 0.5)");
    }
    if (!(options.scale > 0 && std::isfinite(options.scale)))
      throw std::invalid_argument("a scale must be positive");
    if (options.fit_scale) fit_scale();
    scale_by(b_, scale_);
    balanced_.emplace(cells_, a_, b_);
    reference_ = b_.estimates;
    for (std::size_t c = 0; c < channels; ++c) balanced_reference_[c] = balanced_->of(b_, c);
    if (options.fit_scale) remove_brightness();
  }

  Comparison run() {
    constexpr double part = 1. / 4;  // of alpha, for each kind of cell
    const double level = options_.alpha * part / channels;
    for (std::size_t c = 0; c < channels; ++c) {
      const EstimatedMean& whole = reference_[cells_.whole(c)];
      result_.whole[c] = compare_cell(cells_.whole(c), lower_bound(whole), options_.margin, level);
      const double rounding = balanced_->rounding(a_, c) + balanced_->rounding(b_, c);
      result_.balanced[c] = compare({balanced_->of(a_, c), balanced_->of(b_, c), rounding},
                                    lower_bound(balanced_reference_[c]), options_.margin, level);
      result_.border[c] = compare_cell(cells_.border(c), unit(cells_.border(c), c), options_.tile_margin, level);
    }
    compare_tiles(options_.alpha * part);
    conclude();
    return result_;
  }

 private:
  struct Pair {
    EstimatedMean a, b;
    double rounding;
  };

  void compare_tiles(double alpha) {
    const std::size_t tests = channels * cells_.tiles();
    const auto severity = [](const CellComparison& x) { return std::pair(-x.p_value, std::abs(x.difference)); };
    for (std::size_t i = 0; i < tests; ++i) {
      const std::size_t cell = cells_.tile(i / channels, i % channels);
      result_.tiles.push_back(
          compare_cell(cell, unit(cell, i % channels), options_.tile_margin, alpha / static_cast<double>(tests)));
      if (severity(result_.tiles[i]) > severity(result_.tiles[result_.worst])) result_.worst = i;
    }
  }

  void fit_scale() {
    if (a_.from_error_layer || b_.from_error_layer)
      throw std::invalid_argument(
          "a scale can be fitted only to the spread of several renders a side (give more, or --scale K)");
    const BalancedMean balanced(cells_, a_, b_);
    const EstimatedMean a = brightness(balanced, a_), b = brightness(balanced, b_);
    if (!(a.mean > 0 && b.mean > 0))
      throw std::invalid_argument("no scale can be fitted to a black picture (give --scale K)");
    scale_ = a.mean / b.mean;
    result_.scale_error =
        scale_ * std::sqrt(a.squared_error / (a.mean * a.mean) + b.squared_error / (b.mean * b.mean));
  }

  void remove_brightness() {
    const double sum = brightness(*balanced_, b_).mean;
    std::vector<double> part(cells_.size());
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) part[cell] = b_.estimates[cell].mean / sum;
    fairlight::remove_brightness(*balanced_, part, a_);
    fairlight::remove_brightness(*balanced_, part, b_);
  }

  double lower_bound(const EstimatedMean& mean) const {
    const EstimatedMean exact{0, 0, mean.degrees};
    const double quantile = welch_quantile(options_.beta, mean, exact);
    return std::abs(mean.mean) - quantile * std::sqrt(mean.squared_error);
  }

  // What differences of a border or tile are divided by: its mean, or the picture's if that is
  // larger; a lower bound, as it is estimated.
  double unit(std::size_t cell, std::size_t channel) {
    return std::max(lower_bound(balanced_reference_[channel]), lower_bound(reference_[cell]));
  }

  CellComparison compare_cell(std::size_t cell, double scale, double margin, double level) {
    return compare({a_.estimates[cell], b_.estimates[cell], a_.rounding[cell] + b_.rounding[cell]}, scale, margin,
                   level);
  }

  CellComparison compare(const Pair& pair, double scale, double margin, double level) {
    const auto& [a, b, rounding] = pair;
    CellComparison result;
    result.margin = margin;
    // With a fitted scale the means are what is left of them, of either sign.
    result.p_value = options_.fit_scale ? welch_p_value(a, b, rounding) : welch_log_p_value(a, b, rounding);
    const double error = std::sqrt(a.squared_error + b.squared_error), difference = a.mean - b.mean;
    const double quantile = welch_quantile(options_.beta, a, b);
    const double reach = quantile * error + rounding;
    if (difference == 0 && reach == 0) {
      result.verdict = Likeness::same;  // also where both are black
    } else if (!(scale > 0)) {
      result.interval = {-infinite, infinite};
      result.renders_for_margin = infinite;
    } else {
      result.difference = difference / scale;
      result.interval = {(difference - reach) / scale, (difference + reach) / scale};
      if (std::max(-result.interval.lo, result.interval.hi) < margin) result.verdict = Likeness::same;
      const double room = margin * scale - rounding;
      result.renders_for_margin =
          room > 0 ? std::pow((quantile + largest_by_chance()) * error / room, 2) : infinite;
    }
    if (result.p_value < level) result.verdict = Likeness::different;
    return result;
  }

  // How far, in standard errors, the largest difference of all cells is likely to be from 0.
  double largest_by_chance() const {
    const double tail = options_.beta / static_cast<double>(2 * cells_.size());
    return quantile(complement(boost::math::normal(), tail));
  }

  void conclude() {
    bool any_different = false, all_same = true;
    const auto look_at = [&](const CellComparison& cell) {
      any_different = any_different || cell.verdict == Likeness::different;
      all_same = all_same && cell.verdict == Likeness::same;
      result_.renders_for_margin = std::max(result_.renders_for_margin, cell.renders_for_margin);
      const double end = std::max(-cell.interval.lo, cell.interval.hi);
      result_.shown_margin = std::max(result_.shown_margin, end * options_.margin / cell.margin);
    };
    std::ranges::for_each(result_.whole, look_at);
    std::ranges::for_each(result_.balanced, look_at);
    std::ranges::for_each(result_.border, look_at);
    std::ranges::for_each(result_.tiles, look_at);
    result_.scale = scale_;
    result_.verdict = any_different ? Likeness::different : all_same ? Likeness::same : Likeness::undecided;
  }

  const PictureCells& cells_;
  SideOfCells a_, b_;
  const CompareOptions& options_;
  double scale_;
  std::optional<BalancedMean> balanced_;
  std::vector<EstimatedMean> reference_;  // of B, times the scale
  std::array<EstimatedMean, channels> balanced_reference_;
  Comparison result_;
};

}  // namespace

const char* name(Likeness likeness) {
  switch (likeness) {
    case Likeness::same:
      return "same";
    case Likeness::different:
      return "different";
    case Likeness::undecided:
      break;
  }
  return "undecided";
}

Comparison compare_cells(const PictureCells& cells, const SideOfCells& a, const SideOfCells& b,
                         const CompareOptions& options) {
  return Comparing(cells, a, b, options).run();
}

}  // namespace fairlight
