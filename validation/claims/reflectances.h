#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fairlight/estimators/reflectance.h>
#include <fairlight/stats/quadrature.h>
#include <fairlight/validation/checks/parameters.h>
#include <fairlight/validation/claims/materials.h>

namespace fairlight {

/// The mean of a reflectance over cosines that are uniform in a range. It depends on the
/// reflectance alone, without directions or lobes. There are several ranges, as an error at grazing
/// angles would be lost in the reflectance at the others.

struct CosineRange {
  const char* name;
  double low, high;
};
inline constexpr std::array<CosineRange, 3> cosine_ranges{
    {{"grazing", 0, 0.1}, {"oblique", 0.1, 0.5}, {"steep", 0.5, 1}}};

namespace detail {

/// The mean of F over uniform cosines, by quadrature of F sin over the angles. F is a function of
/// the angle to the normal [rad].
inline double mean_over_cosines(double low, double high, const auto& reflectance) {
  const auto integrand = [&](double angle, double) { return reflectance(angle) * std::sin(angle); };
  return integrate_rectangle(integrand, std::acos(high), std::acos(low), 0, 1).value / (high - low);
}

/// A cosine that is uniform in [low, high).
template <class Real>
Real cosine_between(double low, double high, auto& source) {
  return rounded<Real>(low) + rounded<Real>(high - low) * source.next();
}

}  // namespace detail

/// Refractive indices around that of glass, one for each channel.
inline constexpr std::array<double, 3> insulator_indices{1.33, 1.5, 2.4};

/// The reflectance of an insulator from outside.
/// Bound    F falls with the cosine, so its value at the most grazing angle
inline auto insulator_outside(const CosineRange& range) {
  std::vector<Reference> references;
  for (const double n : insulator_indices) {
    const auto reflectance = [n](double angle) { return fresnel_by_angles(angle, n); };
    references.push_back({detail::mean_over_cosines(range.low, range.high, reflectance), 0,
                          reflectance(std::acos(range.low)) * (1 + 1e-12)});
  }
  const auto draw = [range]<class Real>(std::type_identity<Real>, auto& source) {
    const Real cosine = detail::cosine_between<Real>(range.low, range.high, source);
    Rgb<Real> reflected;
    for (std::size_t c = 0; c < 3; ++c)
      reflected[static_cast<int>(c)] = fresnel_dielectric(cosine, rounded<Real>(insulator_indices[c]));
    return reflected;
  };
  return estimand(
      std::string("fresnel.dielectric.outside.") + range.name, {"fresnel_dielectric"},
      "three insulators reflect from outside the integral of Fresnel's equations, over a range of cosines",
      "Born and Wolf, 1.5.2, in the angles; quadrature", references, draw);
}

/// The reflectance of an insulator from inside. Over all cosines: 1 up to the critical cosine, the
/// rest by quadrature. With `refracted`, only over the cosines from just below the critical one,
/// where total reflection that begins elsewhere shows.
inline auto insulator_inside(const std::string& name, bool refracted) {
  std::vector<Reference> references;
  std::array<double, 3> lows{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double eta = 1 / insulator_indices[c], critical = std::sqrt(1 - eta * eta);
    const auto reflectance = [eta](double angle) { return fresnel_by_angles(angle, eta); };
    lows[c] = refracted ? critical - 0.05 : 0;
    const double beyond = detail::mean_over_cosines(critical, 1, reflectance) * (1 - critical);
    references.push_back({(critical - lows[c] + beyond) / (1 - lows[c]), 0, 1 + 1e-12});
  }
  const auto draw = [lows]<class Real>(std::type_identity<Real>, auto& source) {
    const Real u = source.next();
    Rgb<Real> reflected;
    for (std::size_t c = 0; c < 3; ++c) {
      const Real cosine = rounded<Real>(lows[c]) + rounded<Real>(1 - lows[c]) * u;
      reflected[static_cast<int>(c)] = fresnel_dielectric(cosine, rounded<Real>(1 / insulator_indices[c]));
    }
    return reflected;
  };
  return estimand(
      name, {"fresnel_dielectric"},
      "three insulators reflect from inside the integral of Fresnel's equations, and all beyond the critical angle",
      "Born and Wolf, 1.5.2, in the angles; quadrature", references, draw);
}

/// The reflectance of copper, whose index is complex.
inline auto copper_reflectance(const CosineRange& range) {
  const auto reference = [&](int c) {
    const auto reflectance = [c](double angle) { return Copper().reflectance(c, angle); };
    return Reference{detail::mean_over_cosines(range.low, range.high, reflectance), 0, 1 + 1e-12};
  };
  const auto draw = [range]<class Real>(std::type_identity<Real>, auto& source) {
    const FresnelReflectance<Real> copper(rounded_colour<Real>(Copper().eta), rounded_colour<Real>(Copper().k));
    return copper(detail::cosine_between<Real>(range.low, range.high, source));
  };
  return estimand(std::string("fresnel.conductor.") + range.name, {"FresnelReflectance", "fresnel_conductor"},
                  "copper reflects the integral of Fresnel's equations, over a range of cosines",
                  "Born and Wolf, 14.2, in complex amplitudes; quadrature", for_channels(reference), draw);
}

/// The parameters of the rows on Schlick's reflectance: one at normal incidence for each channel.
inline std::vector<ParameterRange> schlick_ranges() {
  const auto at_normal = [](double low, double high) {
    return ParameterRange{"SchlickReflectance", "reflectance", low, high};
  };
  return {at_normal(0, 0.1), at_normal(0.1, 0.9), at_normal(0.9, 1)};
}

/// The mean of (1 - c)^5 over c in [a, b] is ((1 - a)^6 - (1 - b)^6) / (6 (b - a)).
inline auto schlick_reflectance(const CosineRange& range, const std::vector<double>& values) {
  const Rgb<double> at_normal(values[0], values[1], values[2]);
  const auto& [name, a, b] = range;
  const double power = (std::pow(1 - a, 6) - std::pow(1 - b, 6)) / (6 * (b - a));
  const auto reference = [&](int c) {
    const double f = at_normal[c];
    return Reference{f + (1 - f) * power, 0, (f + (1 - f) * std::pow(1 - a, 5)) * (1 + 1e-12)};
  };
  const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
    const SchlickReflectance<Real> schlick(rounded_colour<Real>(at_normal));
    return schlick(detail::cosine_between<Real>(range.low, range.high, source));
  };
  return estimand(std::string("schlick.") + name, {"SchlickReflectance"},
                  "Schlick's reflectance has the integral of a fifth power, over a range of cosines",
                  "elementary; Schlick 1994", for_channels(reference), draw);
}

}  // namespace fairlight
