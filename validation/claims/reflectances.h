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

/// The parameters of the rows on insulators: an index for each channel, near 1, of glass and above.
inline std::vector<ParameterRange> insulator_ranges() {
  const auto index = [](double low, double high) {
    return ParameterRange{"fresnel_dielectric", "index", low, high, ParameterRange::Law::logarithmic};
  };
  return {index(1.0001, 1.1), index(1.1, 2), index(2, 10)};
}

/// The reflectance of insulators from outside, times (g^2 / (n^2 - 1))^2, g^2 = n^2 - 1 + c^2. It is
/// then (1 + q^2) / 2 (g / (g + c))^4 of fresnel_dielectric, in [0,1], and varies little for any
/// index, although F falls by many powers of ten.
inline auto insulator_outside(const CosineRange& range, const std::vector<double>& values) {
  std::array<double, 3> indices{};
  for (std::size_t c = 0; c < 3; ++c) indices[c] = in_floats_exactly(values.at(c));
  const auto reference = [&](int c) {
    const double n = indices[static_cast<std::size_t>(c)];
    const auto scaled = [n](double angle) {
      const double cosine = std::cos(angle);
      return fresnel_by_angles(angle, n) * std::pow(1 + cosine * cosine / ((n - 1) * (n + 1)), 2);
    };
    return Reference{detail::mean_over_cosines(range.low, range.high, scaled), 0, 1 + 1e-9};
  };
  const auto draw = [range, indices]<class Real>(std::type_identity<Real>, auto& source) {
    const Real cosine = detail::cosine_between<Real>(range.low, range.high, source);
    Rgb<Real> reflected;
    for (std::size_t c = 0; c < 3; ++c) {
      const Real square = Real(1) + cosine * cosine * rounded<Real>(1 / ((indices[c] - 1) * (indices[c] + 1)));
      reflected[static_cast<int>(c)] = fresnel_dielectric(cosine, rounded<Real>(indices[c])) * (square * square);
    }
    return reflected;
  };
  return estimand(
      std::string("fresnel.dielectric.outside.") + range.name, {"fresnel_dielectric"},
      "three insulators reflect from outside the integral of Fresnel's equations, over a range of cosines",
      "Born and Wolf, 1.5.2, in the angles; quadrature", for_channels(reference), draw, 2);
}

/// The reflectance of insulators from inside: 1 up to the critical cosine, the rest by quadrature.
/// Over cosines up to twice the critical one, so that total reflection is not rare for indices near
/// 1. With `refracted`, only from just below the critical cosine, where total reflection that begins
/// elsewhere shows.
inline auto insulator_inside(const std::string& name, bool refracted, const std::vector<double>& values) {
  std::array<double, 3> etas{};
  std::array<CosineRange, 3> ranges{};
  std::vector<Reference> references;
  for (std::size_t c = 0; c < 3; ++c) {
    const double eta = in_floats_exactly(1 / values.at(c)), critical = std::sqrt((1 - eta) * (1 + eta));
    const double low = refracted ? critical - std::min(0.05, critical / 2) : 0;
    const double high = std::min(1.0, 2 * critical);
    const auto reflectance = [eta](double angle) { return fresnel_by_angles(angle, eta); };
    const double beyond = detail::mean_over_cosines(critical, high, reflectance) * (high - critical);
    references.push_back({(critical - low + beyond) / (high - low), 0, 1 + 1e-12});
    etas[c] = eta;
    ranges[c] = {"inside", low, high};
  }
  const auto draw = [ranges, etas]<class Real>(std::type_identity<Real>, auto& source) {
    const Real u = source.next();
    Rgb<Real> reflected;
    for (std::size_t c = 0; c < 3; ++c) {
      const Real cosine = rounded<Real>(ranges[c].low) + rounded<Real>(ranges[c].high - ranges[c].low) * u;
      reflected[static_cast<int>(c)] = fresnel_dielectric(cosine, rounded<Real>(etas[c]));
    }
    return reflected;
  };
  return estimand(
      name, {"fresnel_dielectric"},
      "three insulators reflect from inside the integral of Fresnel's equations, and all beyond the critical angle",
      "Born and Wolf, 1.5.2, in the angles; quadrature", references, draw, refracted ? 4 : 2);
}

/// The parameters of the rows on metals, eta and k for each channel: like copper in red, nearly an
/// insulator, and any but those near eta = 1, k = 0, which reflect nothing.
inline std::vector<ParameterRange> metal_index_ranges() {
  constexpr auto logarithmic = ParameterRange::Law::logarithmic;
  const auto eta = [](double low, double high) {
    return ParameterRange{"fresnel_conductor", "eta", low, high, logarithmic};
  };
  return {eta(0.05, 1),   {"fresnel_conductor", "k", 1, 10, logarithmic},
          eta(1.2, 4),    {"fresnel_conductor", "k", 0, 1},
          eta(1e-2, 1e6), {"fresnel_conductor", "k", 0.5, 1e6, logarithmic}};
}

/// The reflectance of metals, whose index is complex.
inline auto metal_reflectance(const CosineRange& range, const std::vector<double>& values) {
  Rgb<double> eta, k;
  for (int c = 0; c < 3; ++c) {
    eta[c] = in_floats_exactly(values.at(2 * static_cast<std::size_t>(c)));
    k[c] = in_floats_exactly(values.at(2 * static_cast<std::size_t>(c) + 1));
  }
  const auto reference = [&](int c) {
    const auto reflectance = [&](double angle) { return fresnel_by_amplitudes(angle, {eta[c], k[c]}); };
    return Reference{detail::mean_over_cosines(range.low, range.high, reflectance), 0, 1 + 1e-9};
  };
  const auto draw = [range, eta, k]<class Real>(std::type_identity<Real>, auto& source) {
    const FresnelReflectance<Real> metal(rounded_colour<Real>(eta), rounded_colour<Real>(k));
    return metal(detail::cosine_between<Real>(range.low, range.high, source));
  };
  return estimand(std::string("fresnel.conductor.") + range.name, {"FresnelReflectance", "fresnel_conductor"},
                  "metals reflect the integral of Fresnel's equations, over a range of cosines",
                  "Born and Wolf, 14.2, in complex amplitudes; quadrature", for_channels(reference), draw, 2);
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
