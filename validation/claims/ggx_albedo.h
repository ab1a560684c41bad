#pragma once

#include <cmath>
#include <numbers>

#include <Eigen/Core>

#include <fairlight/stats/quadrature.h>

namespace fairlight {

/// The albedo of a GGX surface of white facets, by the formulas of the textbooks (Walter et al.
/// 2007; Heitz 2014), not those of the code under test.
struct GgxAlbedo {
  // Facets of slopes (p, q) have normals m ~ (p, q, 1) and the law P(p, q) = 1 / (pi ax ay
  // (1 + p^2/ax^2 + q^2/ay^2)^2), with D(m) cos(m) dm = P dp dq. The albedo is the integral of D
  // G2 / (4 z_out z_in) z_in over `in`, where dm = d(in) / (4 out.m). So it is the integral of P
  // (out.(p, q, 1)) / z_out G2 over the slopes. With p = ax r cos(phi), q = ay r sin(phi) and
  // r = sinh(x), P dp dq = sinh(x) / cosh(x)^3 dx dphi / pi. Facets that reflect below the surface
  // add nothing. With out.(p, q, 1) = z + k r and p^2 + q^2 = g r^2, `in` is above the surface
  // where 2 (z + k r) > z (1 + g r^2), which holds up to a certain r.
  double alpha_x, alpha_y;

  /// Lambda = (sqrt(1 + alpha^2 tan^2) - 1) / 2 in the azimuth of the direction.
  /// G2 = 1 / (1 + Lambda_out + Lambda_in).
  double lambda(const Eigen::Vector3d& w) const {
    const double tangent_x = alpha_x * w.x() / w.z();
    const double tangent_y = alpha_y * w.y() / w.z();
    return (std::sqrt(1 + tangent_x * tangent_x + tangent_y * tangent_y) - 1) / 2;
  }

  /// The albedo in the direction `out`, to 1e-8.
  double operator()(const Eigen::Vector3d& out) const {
    return (*this)(out, [](double) { return 1.0; });
  }

  /// The same for facets of a reflectance, a function of the cosine at the facet.
  template <class Reflectance>
  double operator()(const Eigen::Vector3d& out, const Reflectance& reflectance) const {
    const auto strip = [&](double phi, double part) {
      const Eigen::Vector3d slope(alpha_x * std::cos(phi), alpha_y * std::sin(phi), 0);
      const double horizon = std::asinh(horizon_of(out, slope));
      const double x = part * horizon;
      const Eigen::Vector3d normal = std::sinh(x) * slope + Eigen::Vector3d::UnitZ();
      const Eigen::Vector3d in = 2 * out.dot(normal) / normal.squaredNorm() * normal - out;
      const double law = std::sinh(x) / std::pow(std::cosh(x), 3) / std::numbers::pi;
      const double seen = reflectance(out.dot(normal) / normal.norm()) / (1 + lambda(out) + lambda(in));
      return horizon * law * out.dot(normal) / out.z() * seen;
    };
    // Splits the integral where facets begin to face away from `out`, which is abrupt where `out`
    // is low.
    const double azimuth = std::atan2(alpha_y * out.y(), alpha_x * out.x());
    const auto half = [&](double from) {
      return integrate_rectangle(strip, from, from + std::numbers::pi, 0, 1).value;
    };
    return half(azimuth - std::numbers::pi / 2) + half(azimuth + std::numbers::pi / 2);
  }

 private:
  /// The r at which `in` lies in the surface.
  static double horizon_of(const Eigen::Vector3d& out, const Eigen::Vector3d& slope) {
    const double k = out.dot(slope);
    const double g = slope.squaredNorm();
    const double root = std::sqrt(k * k + out.z() * out.z() * g);
    return k > 0 ? (k + root) / (out.z() * g) : out.z() / (root - k);
  }
};

/// At alpha = 1, D is 1 / pi everywhere and f = 1 / (2 pi (z_out + z_in)), so the albedo has a
/// closed form: E(z), the integral of z' / (z + z') over [0, 1], is 1 - z log(1 + 1/z). Its mean
/// under the cosine, twice the integral of E z, is 4/3 (1 - log 2).
inline double rough_albedo(double z) { return 1 - z * std::log1p(1 / z); }
inline double rough_mean_albedo() { return 4.0 / 3 * (1 - std::numbers::ln2); }

}  // namespace fairlight
