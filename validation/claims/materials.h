#pragma once

#include <algorithm>

#include <fairlight/estimators/conductor.h>
#include <fairlight/estimators/dielectric.h>
#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/importance.h>
#include <fairlight/estimators/uniform_sphere_area.h>
#include <fairlight/stats/quadrature.h>
#include <fairlight/validation/checks/estimand.h>
#include <fairlight/validation/claims/fresnel.h>

namespace fairlight {

/// The mean weight of a bounce is the albedo in the direction `out`. For smooth surfaces it has a
/// closed form, by Fresnel's equations.

/// The albedo of smooth glass for radiance: F + (1 - F) / eta^2, with F = `reflected`. Refraction
/// into the denser medium multiplies radiance by n^2; light goes from `in` to `out`. `eta` is n if
/// `out` is outside and 1/n if it is inside.
inline double radiance_albedo(double reflected, double eta) { return reflected + (1 - reflected) / (eta * eta); }

/// The largest weight of a bounce.
inline double largest_radiance_weight(double eta) { return std::max(1.0, 1 / (eta * eta)); }

namespace detail {

constexpr double glass_index = 1.5;

/// The direction `out` at an angle [rad] to the normal, above the surface or below it.
template <class Real>
Vec3<Real> out_at(double angle, bool above) {
  return {rounded<Real>(0.6 * std::sin(angle)), rounded<Real>(0.8 * std::sin(angle)),
          rounded<Real>((above ? 1 : -1) * std::cos(angle))};
}

/// Samples a bounce with as many numbers as it takes.
template <class Surface, class Source>
Bounce<typename Surface::Scalar> bounce(const Surface& surface, const Vec3<typename Surface::Scalar>& out,
                                        Source& source) {
  Eigen::Matrix<typename Surface::Scalar, Surface::dimensions, 1> u;
  for (int i = 0; i < Surface::dimensions; ++i) u[i] = source.next();
  return surface.sample(out, u);
}

}  // namespace detail

/// The albedo at three angles [degrees] from one side, one for each channel, against Fresnel's
/// equations in the angles.
template <template <class> class Glass>
auto glass_albedo(const std::string& name, const Rgb<double>& degrees, bool above) {
  using detail::glass_index;
  const double eta = above ? glass_index : 1 / glass_index;
  const Rgb<double> angles = degrees * (std::numbers::pi / 180);
  const auto reference = [&](int c) {
    return Reference{radiance_albedo(fresnel_by_angles(angles[c], eta), eta), 0,
                     largest_radiance_weight(eta) * (1 + 1e-12)};
  };
  const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
    const Glass<Real> glass(rounded<Real>(glass_index));
    Rgb<Real> weight;
    for (int c = 0; c < 3; ++c) {
      const Vec3<Real> out = detail::out_at<Real>(angles[c], above);
      weight[c] = detail::bounce(glass, out, source).weight[0];
    }
    return weight;
  };
  return estimand(name, {"Dielectric"},
                  "radiance through glass: the mean weight of a bounce is F + (1 - F) / eta^2, at three angles",
                  "Born and Wolf, 1.5.2, in the angles; Veach 1997, 5.2", for_channels(reference), draw);
}

/// For cosine-distributed `out` the mean weight is R + (1 - R) / eta^2, with R the diffuse
/// reflectance of that side.
template <template <class> class Glass>
auto glass_diffuse(const std::string& name, bool above) {
  using detail::glass_index;
  const double eta = above ? glass_index : 1 / glass_index;
  const double reflectance =
      above ? diffuse_reflectance_outside(glass_index) : diffuse_reflectance_inside(glass_index);
  const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
    Vec3<Real> out = CosineHemisphere<Real>().sample(next_pair<Real>(source));
    if (!above) out = Vec3<Real>(-out);
    return Real(detail::bounce(Glass<Real>(rounded<Real>(glass_index)), out, source).weight[0]);
  };
  return estimand(name, {"Dielectric", "CosineHemisphere"},
                  "diffuse radiance through glass: the mean weight of a bounce is R + (1 - R) / eta^2",
                  "Walsh 1926; Duntley 1942",
                  {{radiance_albedo(reflectance, eta), 0, largest_radiance_weight(eta) * (1 + 1e-12)}}, draw);
}

/// The diffuse reflectance of glass from outside: the mean of 2 F cos over cosines that are uniform
/// in [0,1).
/// Bound    with h^2 = n^2 - 1 <= g^2, F is at most the reflectance for polarisation across,
///          h^4 / (c + g)^4 <= h^4 / (c + h)^4, and c times this is largest at c = h / 3
inline auto fresnel_diffuse(const std::string& name) {
  const double upper = 27.0 / 128 * std::sqrt(detail::glass_index * detail::glass_index - 1);
  const auto draw = []<class Real>(std::type_identity<Real>, auto& source) {
    const Importance estimator(UniformHemisphere<Real>{}, [](const Vec3<Real>& w) {
      return Real(fresnel_dielectric(w.z(), rounded<Real>(detail::glass_index)) * w.z() / pi<Real>);
    });
    return Real(estimator.estimate(source));
  };
  return estimand(name, {"fresnel_dielectric", "Importance"},
                  "glass reflects of diffuse light what Walsh and Duntley say", "Walsh 1926; Duntley 1942",
                  {{diffuse_reflectance_outside(detail::glass_index), 0, upper}}, draw);
}

/// The weight of a bounce off glass without the factor 1 / eta^2 of radiance: w eta^2 if it is
/// refracted to the other side. One `out` of 2^24 lies in the surface, on neither side; it is
/// reflected with all of its energy.
template <class Glass>
typename Glass::Scalar energy_weight(const Glass& glass, const Vec3<typename Glass::Scalar>& out,
                                     const Bounce<typename Glass::Scalar>& bounce) {
  using Real = typename Glass::Scalar;
  const Real eta = select(bounce.in.z() * out.z() < Real(0), glass.eta(out), Real(1));
  return bounce.weight[0] * eta * eta;
}

/// Conservation of energy: this weight is 1 for every direction.
template <template <class> class Glass>
auto glass_energy() {
  const auto draw = []<class Real>(std::type_identity<Real>, auto& source) {
    const Glass<Real> glass(rounded<Real>(detail::glass_index));
    const Vec3<Real> out = UniformSphereArea<Real>(Real(1)).sample(next_pair<Real>(source));
    return energy_weight(glass, out, detail::bounce(glass, out, source));
  };
  return constant("dielectric.energy", {"Dielectric"},
                  "what glass does not reflect it refracts: weight eta^2 is 1 for every bounce",
                  "conservation of energy", 1, 4, draw);
}

/// A metal like copper, in red, green and blue: absorbing in all channels, and most unlike an
/// insulator in red.
struct Copper {
  Rgb<double> eta{0.22, 1.04, 1.21}, k{3.7, 2.58, 2.2};

  template <class Real>
  Conductor<Real> surface() const {
    return Conductor<Real>(rounded_colour<Real>(eta), rounded_colour<Real>(k));
  }
  double reflectance(int channel, double angle) const {
    return fresnel_by_amplitudes(angle, {eta[channel], k[channel]});
  }
};

/// The reflectance of a smooth conductor for diffuse light: F sin(2 i) over the angle, by
/// quadrature.
inline auto conductor_diffuse(const std::string& name) {
  const auto reference = [](int c) {
    const auto reflected = [c](double i, double) { return Copper().reflectance(c, i) * std::sin(2 * i); };
    return Reference{integrate_rectangle(reflected, 0, std::numbers::pi / 2, 0, 1).value, 0, 1 + 1e-12};
  };
  const auto draw = []<class Real>(std::type_identity<Real>, auto& source) {
    const Vec3<Real> out = CosineHemisphere<Real>().sample(next_pair<Real>(source));
    return detail::bounce(Copper().surface<Real>(), out, source).weight;
  };
  return estimand(name, {"Conductor", "fresnel_conductor", "CosineHemisphere"},
                  "copper reflects of diffuse light the integral of Fresnel's equations, per channel",
                  "Born and Wolf, 14.2, in complex amplitudes; quadrature", for_channels(reference), draw);
}

/// A surface where every bounce from `angle` has the same weight, its albedo `mean`.
/// `make(type_identity<Real>)` gives the surface.
template <class Make>
auto constant_weight(const std::string& name, std::vector<std::string> subjects, const std::string& source,
                     double angle, double mean, const Make& make, int ulps = 8) {
  const auto draw = [=]<class Real>(std::type_identity<Real> real, auto& numbers) {
    return Real(detail::bounce(make(real), detail::out_at<Real>(angle, true), numbers).weight[0]);
  };
  return constant(name, std::move(subjects), "the weight of every bounce is the albedo", source, mean, ulps, draw);
}

}  // namespace fairlight
