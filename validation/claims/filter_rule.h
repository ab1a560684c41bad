#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

#include <fairlight/estimators/vec.h>
#include <fairlight/render/strategy_table.h>
#include <fairlight/stats/gauss_legendre.h>

namespace fairlight {

/// A pixel filter as closed forms of pictures need it: means of functions over it, by quadrature of
/// its formula. The filters of the kit only sample.
class FilterRule {
 public:
  explicit FilterRule(PixelFilter filter) : filter_(filter), reach_(reach_of(filter)) {
    const double zeroth = integral([](double) { return 1.0; }, -reach_, reach_),
                 second = integral([](double x) { return x * x; }, -reach_, reach_),
                 fourth = integral([](double x) { return x * x * x * x; }, -reach_, reach_);
    mass_ = zeroth;
    node_ = std::sqrt(fourth / second);
    weight_ = second * second / (2 * fourth * zeroth);
  }

  /// The largest offset along an axis [pixel].
  double reach() const { return reach_; }

  /// The mean of a smooth f(x, y) over the filter about a point, by three nodes along each axis.
  /// They have the second and the fourth moment of the filter, so polynomials up to degree 5 are
  /// exact.
  template <class F>
  Rgb<double> mean(double x, double y, const F& f) const {
    const auto of = [this](int i) { return i == 0 ? 1 - 2 * weight_ : weight_; };
    Rgb<double> sum(0, 0, 0);
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) sum += of(i) * of(j) * f(x + i * node_, y + j * node_);
    }
    return sum;
  }

  /// The mean of f along an axis, whose derivatives may jump: by 64 parts.
  template <class F>
  double mean_along(const F& f) const {
    constexpr int parts = 64;
    double sum = 0;
    for (int i = 0; i < parts; ++i)
      sum += integral(f, reach_ * (2.0 * i / parts - 1), reach_ * (2.0 * (i + 1) / parts - 1));
    return sum / mass_;
  }

  /// The share of the filter with an offset below x along an axis.
  double share_below(double x) const {
    const auto one = [](double) { return 1.0; };
    if (x <= 0) return x <= -reach_ ? 0 : integral(one, -reach_, x) / mass_;
    return 1 - share_below(-x);
  }

 private:
  static double reach_of(PixelFilter filter) {
    switch (filter) {
      case PixelFilter::box:
        return 0.5;
      case PixelFilter::tent:
        return 1;
      case PixelFilter::gaussian:
        return 1.5;
      case PixelFilter::blackman_harris:
        break;
    }
    return 2;
  }

  /// The filter at an offset within its reach, up to a factor.
  double shape(double x) const {
    switch (filter_) {
      case PixelFilter::box:
        return 1;
      case PixelFilter::tent:
        return 1 - std::abs(x);
      case PixelFilter::gaussian:
        return std::exp(-2 * x * x);  // a deviation of half a pixel
      case PixelFilter::blackman_harris:
        break;
    }
    const double turn = std::numbers::pi * x / 2;  // Harris 1978
    return 0.35875 + 0.48829 * std::cos(turn) + 0.14128 * std::cos(2 * turn) + 0.01168 * std::cos(3 * turn);
  }

  /// The integral of f times the filter's shape, in two parts that meet at 0, where the tent bends.
  template <class F>
  double integral(const F& f, double from, double to) const {
    if (from < 0 && to > 0) return integral(f, from, 0) + integral(f, 0, to);
    const auto& rule = gauss_legendre<16>();
    double sum = 0;
    for (std::size_t i = 0; i < rule.reach.size(); ++i) {
      for (const double place : {0.5 - rule.reach[i], 0.5 + rule.reach[i]}) {
        const double x = from + (to - from) * place;
        sum += rule.weight[i] * (to - from) * shape(x) * f(x);
      }
    }
    return sum;
  }

  PixelFilter filter_;
  double reach_, mass_, node_, weight_;
};

}  // namespace fairlight
