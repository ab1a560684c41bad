#pragma once

#include <stdexcept>

#include <fairlight/estimators/fresnel.h>
#include <fairlight/estimators/vec.h>

namespace fairlight {

namespace detail {

template <class Real>
const Rgb<Real>& checked_reflectance(const Rgb<Real>& colour) {
  for (int c = 0; c < 3; ++c) {
    if (!all_within(colour[c], 0, 1))
      throw std::invalid_argument("a reflectance must lie in [0,1] (no surface reflects more than it gets)");
  }
  return colour;
}

}  // namespace detail

/// What facets reflect of what they get, by the cosine at the facet: a function of it, to an Rgb in [0,1].

/// The same at any angle. Throws std::invalid_argument for a colour outside [0,1].
/// Source: elementary.
template <class Real>
class ConstantReflectance {
 public:
  explicit ConstantReflectance(const Rgb<Real>& colour) : colour_(detail::checked_reflectance(colour)) {}
  Rgb<Real> operator()(Real) const { return colour_; }

 private:
  Rgb<Real> colour_;
};

/// F = F0 + (1 - F0) (1 - cos)^5, with F0 that at normal incidence. Throws std::invalid_argument for F0 outside [0,1].
/// Source: Schlick 1994.
template <class Real>
class SchlickReflectance {
 public:
  explicit SchlickReflectance(const Rgb<Real>& at_normal) : at_normal_(detail::checked_reflectance(at_normal)) {}

  Rgb<Real> operator()(Real cosine) const {
    const Real x = Real(1) - cosine;
    const Real power = (x * x) * (x * x) * x;
    Rgb<Real> colour;
    for (int c = 0; c < 3; ++c) colour[c] = at_normal_[c] + (Real(1) - at_normal_[c]) * power;
    return colour;
  }

 private:
  Rgb<Real> at_normal_;
};

/// Fresnel's equations for a conductor of index eta + i k. Source: fresnel.h.
template <class Real>
class FresnelReflectance {
 public:
  /// Throws std::invalid_argument for an index outside the domain of fresnel_conductor.
  FresnelReflectance(const Rgb<Real>& eta, const Rgb<Real>& k) : eta_(eta), k_(k) { require_conductor(eta, k); }
  Rgb<Real> operator()(Real cosine) const { return fresnel_conductor(cosine, eta_, k_); }

 private:
  Rgb<Real> eta_, k_;
};

}  // namespace fairlight
