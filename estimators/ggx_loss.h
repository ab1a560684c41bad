#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include <fairlight/estimators/ggx_albedo.h>

namespace fairlight {

/// The fraction of light from the height z >= 1e-10 that white isotropic GGX facets do not return
/// by single reflection: 1 - E(z), to 1e-8 for any roughness in [1e-4, 1].
inline double ggx_loss(double alpha, double z) {
  const Vec3<double> out(std::sqrt((1 - z) * (1 + z)), 0, z);
  return 1 - ggx_albedo(Ggx<double>(alpha, alpha), out, [](double) { return 1.0; });
}

/// The loss of one roughness as a smooth function of the height, fitted to ggx_loss on
/// construction. Its error is below 1e-5, and it is never negative. It has no table to look up, so
/// it works for any Real.
class GgxLoss {
  // loss(z) = a^2 (1 + z^2) / (2 (z^2 + a^2)) R(x)^2 with x^2 = (1 + a) z / (z + a). The first
  // factor is the behaviour far from grazing angles. The substitution x resolves both ends. R is a
  // Chebyshev series.
 public:
  /// Roughness in [1e-4, 1]; throws std::invalid_argument otherwise. Takes a few ms.
  explicit GgxLoss(double alpha) : alpha_(alpha) {
    std::array<double, terms> values{};
    for (std::size_t i = 0; i < terms; ++i) {
      const double x = 0.5 + 0.5 * std::cos(angle(i));
      const double z = alpha * x * x / (1 + alpha - x * x);
      values[i] = std::sqrt(ggx_loss(alpha, z) / falloff(z));
    }
    for (std::size_t j = 0; j < terms; ++j) {
      for (std::size_t i = 0; i < terms; ++i) {
        series_[j] += values[i] * std::cos(static_cast<double>(j) * angle(i)) * (j == 0 ? 1.0 : 2.0) / terms;
      }
    }
  }

  /// z in [0,1].
  template <class Number>
  Number operator()(Number z) const {
    using std::sqrt;
    const Number a = rounded<Number>(alpha_);
    const Number x = sqrt((Number(1) + a) * z / (z + a));
    const Number twice = Number(4) * x - Number(2);
    Number next(0);
    Number sum = Number(0);
    for (std::size_t j = terms - 1; j > 0; --j) {  // Clenshaw
      const Number before = twice * sum - next + rounded<Number>(series_[j]);
      next = sum;
      sum = before;
    }
    const Number r = twice / Number(2) * sum - next + rounded<Number>(series_[0]);
    return falloff(z) * (r * r);
  }

  /// The cosine-weighted mean: twice the integral of loss(z) z. The substitution z = a sinh(y)
  /// resolves small a.
  double mean() const {
    const double reach = std::asinh(1 / alpha_);
    return reach * integrate_unit<double, 48>([&](double t) {
             const double z = alpha_ * std::sinh(reach * t);
             return 2 * (*this)(z)*z * alpha_ * std::cosh(reach * t);
           });
  }

 private:
  static constexpr std::size_t terms = 24;

  static double angle(std::size_t i) { return std::numbers::pi * (static_cast<double>(i) + 0.5) / terms; }

  template <class Number>
  Number falloff(Number z) const {
    const Number square = rounded<Number>(alpha_ * alpha_);
    return square * (Number(1) + z * z) / (Number(2) * (z * z + square));
  }

  double alpha_;
  std::array<double, terms> series_{};
};

}  // namespace fairlight
