#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include <boost/math/quadrature/gauss.hpp>

#include <fairlight/estimators/ggx.h>

namespace fairlight {

/// Of the light that white isotropic GGX facets get from the height z > 0, the part that their first reflection does
/// not send back: 1 - E(z), E the integral of f z_in over `in`, to 1e-7 for any roughness in [1e-4, 1].
///
/// Over the facets' slopes, alpha r (cos(phi), sin(phi)) with r = sinh(x), where D(m) cos(m) dm = 2 sinh / cosh^3 dx
/// dphi / (2 pi). In an azimuth phi, with k = cos(phi) sin(out), `in` is above the surface up to one slope, t = (k +
/// sqrt(k^2 + z^2)) / z, so that the integrand is smooth; it changes fast about phi = 90 degrees when z is small, so
/// phi is that far from there times a cube. Gauss-Legendre, 48 x 16 for each half of the turn.
inline double ggx_loss(double alpha, double z) {
  using Slopes = boost::math::quadrature::gauss<double, 48>;
  using Azimuths = boost::math::quadrature::gauss<double, 16>;
  const Ggx<double> facets(alpha, alpha);
  const double sine = std::sqrt((1 - z) * (1 + z));
  const auto strip = [&](double k) {
    const double root = std::sqrt(k * k + z * z);
    const double horizon = k > 0 ? (k + root) / z : z / (root - k);
    const auto seen = [&](double x) {
      const double r = std::sinh(x);
      const double cosh = std::cosh(x);
      const double facing = z + alpha * r * k;  // out.m, over m's height
      const double slope = alpha * r;
      const double in_z = 2 * facing / (1 + slope * slope) - z;
      const Vec3<double> in(std::sqrt((1 - in_z) * (1 + in_z)), 0, in_z);
      return 8 * r / (cosh * cosh * cosh) * facing * in_z * facets.visibility({sine, 0, z}, in);
    };
    return Slopes::integrate(seen, 0, std::asinh(horizon / alpha));
  };
  const auto azimuth = [&](double y) {
    const double k = sine * std::sin(std::numbers::pi / 2 * y * y * y);
    return 3 * y * y * (strip(k) + strip(-k));
  };
  return 1 - Azimuths::integrate(azimuth, 0, 1) / 2;
}

/// The loss of a roughness as a smooth function of the height, fitted to ggx_loss when it is made: off by less than 1e-5,
/// never negative, and of any Real, as it has no table to look up.
///
/// loss(z) = a^2 (1 + z^2) / (2 (z^2 + a^2)) R(x)^2 with x^2 = (1 + a) z / (z + a): the first factor is how it falls far
/// from grazing angles, x spreads out both ends, and R is a Chebyshev series.
class GgxLoss {
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

  /// Its mean under the cosine, twice the integral of loss(z) z. With z = a sinh(y), for a's sake.
  double mean() const {
    const auto part = [this](double y) {
      const double z = alpha_ * std::sinh(y);
      return 2 * (*this)(z)*z * alpha_ * std::cosh(y);
    };
    return boost::math::quadrature::gauss<double, 48>::integrate(part, 0, std::asinh(1 / alpha_));
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
