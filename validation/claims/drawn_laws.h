#pragma once

#include <fairlight/estimators/blackman_harris_filter.h>
#include <fairlight/estimators/cone.h>
#include <fairlight/estimators/environment.h>
#include <fairlight/estimators/filter.h>
#include <fairlight/estimators/gaussian_filter.h>
#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/lens.h>
#include <fairlight/estimators/lobe.h>
#include <fairlight/estimators/sphere_directions.h>
#include <fairlight/validation/claims/drawn_integrands.h>
#include <fairlight/validation/claims/filters.h>

namespace fairlight {

/// The samplers that drawn_integrands.h tests, over their whole domains. A range that would dilute a
/// fault is cut, each part with a row of its own.

inline constexpr double full_turn = 2 * std::numbers::pi;

/// The angle of the integrand's axes, for a component without parameters.
inline std::vector<ParameterRange> any_azimuth(const std::string& component) {
  return {{component, "azimuth", 0, full_turn}};
}

/// A sampler without parameters, of density cos^n / (normaliser) up to `widest`.
template <template <class> class Directions>
auto fixed_directions(const std::string& name, const std::string& subject, double exponent, double widest,
                      double azimuth) {
  return axial_integrands(name, subject, AxialLaw{.exponent = exponent, .widest = widest, .turn = azimuth},
                          []<class Real>(std::type_identity<Real>) { return Directions<Real>{}; });
}

/// The directions of a light at infinity.
template <class Real>
struct EnvironmentDirections {
  Vec3<Real> from{Real(1), Real(-2), Real(0.5)};
  Vec3<Real> sample(const Vec2<Real>& u) const { return ConstantEnvironment<Real>().sample(from, u).direction; }
  Density<SolidAngle, Real> pdf(const Vec3<Real>& w) const { return ConstantEnvironment<Real>().pdf(from, w); }
};

/// Cones, from 1 - cos or from sin^2 of the half angle.
enum class ConeBy { height, sine_squared };

template <template <class> class Cone>
auto cone_integrands(const std::string& name, ConeBy by, double value, double azimuth) {
  const double x = in_floats_exactly(value);
  const double height = by == ConeBy::height ? x : x / (1 + std::sqrt(1 - x));
  return axial_integrands(
      name, "UniformCone", AxialLaw{.widest = height, .turn = azimuth}, [=]<class Real>(std::type_identity<Real>) {
        using Right = UniformCone<Real>;
        const auto parameter = rounded<Real>(x);
        return Cone<Real>(by == ConeBy::height ? Right(parameter) : Right::of_sine_squared(parameter));
      });
}

/// A lobe of an exponent about any axis.
template <template <class> class Lobe>
auto lobe_integrands(const std::string& name, const std::vector<double>& values) {
  const double exponent = in_floats_exactly(values[0]);
  const double z = values[1], sine = std::sqrt((1 - z) * (1 + z));
  const Eigen::Vector3d axis(sine * std::cos(values[2]), sine * std::sin(values[2]), z);
  return axial_integrands(name, "PowerCosineLobe", AxialLaw{.axis = axis, .exponent = exponent, .turn = values[3]},
                          [=]<class Real>(std::type_identity<Real>) {
                            return Lobe<Real>(rounded_vector<Real>(axis), rounded<Real>(exponent));
                          });
}

inline std::vector<ParameterRange> lobe_ranges(double low, double high) {
  const auto law = low > 0 ? ParameterRange::Law::logarithmic : ParameterRange::Law::uniform;
  return {{"PowerCosineLobe", "exponent", low, high, law},
          {"PowerCosineLobe", "height of the axis", -1, 1},
          {"PowerCosineLobe", "azimuth of the axis", 0, full_turn},
          {"PowerCosineLobe", "azimuth", 0, full_turn}};
}

/// Filters. The targets are their densities at offsets divided by the reach, times its square.
template <template <class> class Filter>
auto box_integrands(const std::vector<double>& values) {
  const double reach = in_floats_exactly(values[0]);
  return offset_integrands(
      "filter.box.integrands", "BoxFilter", OffsetLaw{.reach = reach, .spread = 1.0 / 3, .turn = values[1]},
      [=]<class Real>(std::type_identity<Real>) { return Filter<Real>(rounded<Real>(reach)); },
      []<class Real>(Real, Real) { return Real(0.25); });
}

template <template <class> class Filter>
auto tent_integrands(const std::vector<double>& values) {
  return offset_integrands(
      "filter.tent.integrands", "TentFilter", OffsetLaw{.reach = 1, .spread = 1.0 / 6, .turn = values[0]},
      []<class Real>(std::type_identity<Real>) { return Filter<Real>(); },
      []<class Real>(Real x, Real y) {
        using std::abs;
        return Real((Real(1) - abs(x)) * (Real(1) - abs(y)));
      });
}

/// `values`: the reach, the reach in deviations, the azimuth.
template <template <class> class Filter>
auto gaussian_integrands(const std::string& name, const std::vector<double>& values) {
  const double deviation = in_floats_exactly(values[0] / values[1]);
  const double reach = in_floats_exactly(std::min(values[0], 5 * deviation));
  const double a = reach / deviation;
  const double height = std::pow(a / (std::sqrt(2 * std::numbers::pi) * std::erf(a / std::numbers::sqrt2)), 2);
  const double spread =
      a < 0.1 ? 1.0 / 3 - 2 * a * a / 45 : cut_gaussian_moment(deviation, reach) / (reach * reach);
  return offset_integrands(
      name, "GaussianFilter", OffsetLaw{.reach = reach, .spread = spread, .turn = values[2]},
      [=]<class Real>(std::type_identity<Real>) {
        return Filter<Real>(rounded<Real>(deviation), rounded<Real>(reach));
      },
      [=]<class Real>(Real x, Real y) {
        using std::exp;
        return Real(rounded<Real>(height) * exp(Real(rounded<Real>(-a * a / 2) * (x * x + y * y))));
      });
}

template <template <class> class Filter>
auto blackman_harris_integrands(const std::vector<double>& values) {
  const double reach = in_floats_exactly(values[0]);
  return offset_integrands(
      "filter.blackman_harris.integrands", "BlackmanHarrisFilter",
      OffsetLaw{.reach = reach, .spread = blackman_harris_moment(1), .turn = values[1]},
      [=]<class Real>(std::type_identity<Real>) { return Filter<Real>(rounded<Real>(reach)); },
      []<class Real>(Real x, Real y) {
        const auto window =
            [](Real t) {  // as a polynomial in c = cos(pi t): cos(2v) = 2c^2 - 1, cos(3v) = 4c^3 - 3c
              using std::cos;
              const Real c = cos(Real(pi<Real> * t));
              const auto a = [](double k) { return rounded<Real>(k / 0.35875 / 2); };
              return Real(a(0.35875 - 0.14128) +
                          c * (a(0.48829 - 3 * 0.01168) + c * (a(2 * 0.14128) + c * a(4 * 0.01168))));
            };
        return Real(window(x) * window(y));
      });
}

template <template <class> class Aperture>
auto circle_integrands(const std::vector<double>& values) {
  const double radius = in_floats_exactly(values[0]);
  return offset_integrands(
      "aperture.circle.integrands", "CircularAperture",
      OffsetLaw{.reach = radius, .spread = 0.25, .round = true, .turn = values[1]},
      [=]<class Real>(std::type_identity<Real>) { return Aperture<Real>(rounded<Real>(radius)); },
      []<class Real>(Real, Real) { return Real(rounded<Real>(1 / std::numbers::pi)); });
}

/// `values`: the number of blades, rounded down; the radius; the rotation; the azimuth.
template <template <class> class Aperture>
auto polygon_integrands(const std::string& name, const std::vector<double>& values) {
  const int blades = static_cast<int>(values[0]);
  const double radius = in_floats_exactly(values[1]);
  const double sector = full_turn / blades;
  return offset_integrands(
      name, "PolygonalAperture",
      OffsetLaw{.reach = radius, .spread = (2 + std::cos(sector)) / 12, .round = true, .turn = values[3]},
      [=]<class Real>(std::type_identity<Real>) {
        return Aperture<Real>(rounded<Real>(radius), blades, rounded<Real>(values[2]));
      },
      [=]<class Real>(Real, Real) { return Real(rounded<Real>(2 / (blades * std::sin(sector)))); });
}

}  // namespace fairlight
