#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <fairlight/estimators/glossy.h>
#include <fairlight/estimators/lambertian.h>
#include <fairlight/estimators/mixture.h>
#include <fairlight/estimators/rough_conductor.h>
#include <fairlight/validation/claims/materials.h>

namespace fairlight {

/// Two identities that hold at every draw: the weight of a bounce is f cos / p in every channel, and
/// f(a, b) = f(b, a). So every draw has its own parameters and directions, over the whole domain,
/// and no fault is diluted.

namespace detail {

/// A number whose logarithm is uniform between those of two numbers.
template <class Real>
Real log_between(double low, double high, auto& source) {
  using std::exp;
  using std::max;
  using std::min;
  const Real x = rounded<Real>(low) * exp(Real(rounded<Real>(std::log(high / low)) * Real(source.next())));
  return min(max(x, rounded<Real>(low)), rounded<Real>(high));
}

/// A colour with channels in [0,1).
template <class Real>
Rgb<Real> any_colour(auto& source) {
  const Real r = source.next(), g = source.next();
  return {r, g, Real(source.next())};
}

/// A unit vector above the surface; the logarithm of its height is uniform from 1e-4 to 1.
template <class Real>
Vec3<Real> any_direction(auto& source) {
  using std::sqrt;
  const Real z = log_between<Real>(1e-4, 1, source);
  return direction_at(z, Real(sqrt((Real(1) - z) * (Real(1) + z))), Real(source.next()));
}

/// The largest of |x - y| over the larger magnitude, or over `least` where both are smaller.
template <class Real>
Real worst_gap(const Rgb<Real>& x, const Rgb<Real>& y, double least) {
  using std::abs;
  using std::max;
  Rgb<Real> gap;
  for (int c = 0; c < 3; ++c)
    gap[c] = abs(x[c] - y[c]) / max(Real(max(Real(abs(x[c])), Real(abs(y[c])))), rounded<Real>(least));
  return max_channel<Real>(gap);
}

}  // namespace detail

/// The surfaces, drawn by `make<Real>(source)`. A fault can replace the rough metal.
template <template <class, class> class Surface = RoughConductor>
struct AnyRoughMetal {
  static constexpr const char* name = "rough_conductor";
  static constexpr const char* subject = "RoughConductor";
  template <class Real>
  static auto make(auto& source) {
    const Real x = detail::log_between<Real>(1e-4, 1, source);
    const Real y = detail::log_between<Real>(1e-4, 1, source);
    using Reflectance = SchlickReflectance<Real>;
    return Surface<Real, Reflectance>(Ggx<Real>(x, y), Reflectance(detail::any_colour<Real>(source)));
  }
};
struct AnyGlossy {
  static constexpr const char* name = "glossy";
  static constexpr const char* subject = "Glossy";
  template <class Real>
  static auto make(auto& source) {
    const Rgb<Real> colour = detail::any_colour<Real>(source);
    return Glossy<Real>(colour, detail::log_between<Real>(1e-3, 1e8, source));
  }
};
struct AnyLambertian {
  static constexpr const char* name = "lambertian";
  static constexpr const char* subject = "Lambertian";
  template <class Real>
  static auto make(auto& source) {
    return Lambertian<Real>(detail::any_colour<Real>(source));
  }
};

/// Three lobes, of weights from 1e-6 to 1 and probabilities from 1e-6.
struct AnyMixture {
  static constexpr const char* name = "mixture";
  static constexpr const char* subject = "Mixture";
  template <class Real>
  static auto make(auto& source) {
    using Inner = Mixture<Lambertian<Real>, Glossy<Real>>;
    using Metal = decltype(AnyRoughMetal<>::make<Real>(source));
    const Real p = detail::log_between<Real>(1e-6, 0.5, source);
    const Real q = detail::log_between<Real>(1e-6, 0.5, source);
    const Real w = detail::log_between<Real>(1e-6, 1, source);
    const auto diffuse = AnyLambertian::make<Real>(source);
    const auto glossy = AnyGlossy::make<Real>(source);
    const Inner inner({diffuse, w, p}, {glossy, Real(1), Real(Real(1) - p)});
    return Mixture<Inner, Metal>({inner, w, q}, {AnyRoughMetal<>::make<Real>(source), Real(1), Real(Real(1) - q)});
  }
};

/// The rounding of a weight: at most 16 ulp are seen, of a weight that counts as 1e-3 where it is
/// less.
inline constexpr int identity_ulps = 64;

/// 1, plus the gap between the weight of a bounce and f cos / p; below the surface the weight is 0.
template <class Surface>
auto bounce_identity() {
  const auto draw = []<class Real>(std::type_identity<Real>, auto& source) {
    const auto surface = Surface::template make<Real>(source);
    const Vec3<Real> out = detail::any_direction<Real>(source);
    const Bounce<Real> bounce = detail::bounce(surface, out, source);
    const Real p = surface.pdf(out, bounce.in).value();
    const Rgb<Real> ratio = surface.eval(out, bounce.in) * Real(bounce.in.z() / select(p > Real(0), p, Real(1)));
    const Rgb<Real> expected = select(bounce.in.z() > Real(0), ratio, zero<Rgb<Real>>());
    return Real(Real(1) + detail::worst_gap<Real>(bounce.weight, expected, 1e-3));
  };
  return constant(std::string(Surface::name) + ".bounce", {Surface::subject},
                  "the weight of a bounce is f cos / p in every channel, of any surface and direction",
                  "elementary", 1, identity_ulps, draw);
}

/// 1, plus the gap between f(a, b) and f(b, a). Half of the directions are those of bounces, as a
/// sharp lobe is 0 or nearly so elsewhere.
template <class Surface>
auto reciprocity() {
  const auto draw = []<class Real>(std::type_identity<Real>, auto& source) {
    const auto surface = Surface::template make<Real>(source);
    const Vec3<Real> out = detail::any_direction<Real>(source);
    const Vec3<Real> other = detail::any_direction<Real>(source);
    const Bounce<Real> bounce = detail::bounce(surface, out, source);
    const Mask<Real> bounces = source.next() < Real(0.5) && bounce.in.z() > Real(0);
    const Vec3<Real> in = select(bounces, bounce.in, other);
    return Real(Real(1) + detail::worst_gap<Real>(surface.eval(out, in), surface.eval(in, out), 1e-20));
  };
  return constant(std::string(Surface::name) + ".reciprocity", {Surface::subject},
                  "f is the same with both directions exchanged, of any surface and directions", "Helmholtz", 1,
                  identity_ulps, draw);
}

}  // namespace fairlight
