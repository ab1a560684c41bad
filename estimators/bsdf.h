#pragma once

#include <stdexcept>

#include <fairlight/estimators/concepts.h>

namespace fairlight {

/// Directions at a surface are unit vectors in its local frame, where the normal is +z and the side that is looked at is
/// z > 0: `out` towards the viewer, `in` towards where the light comes from. One that is not a unit vector is the caller's
/// mistake, and is never normalised. An `out` that a law is built about (the lobe of Glossy, the visible normals of
/// RoughConductor) is refused with std::invalid_argument by what draws from that law or gives its density; elsewhere, and
/// for any `in`, the formula is taken as it stands: a mirror's image of a vector twice as long is twice as long.

/// A direction that light may have come from, and what it is worth.
template <class Real>
struct Bounce {
  Vec3<Real> in;     ///< local, unit
  Rgb<Real> weight;  ///< f |cos(in)| / p; 0 where the light is absorbed, or the sample does not exist
  Density<SolidAngle, Real> density;  ///< p of `in` [1/sr]; 0 where it was a single direction, not a density's
};

/// What a surface does with light: `eval(out, in)`, the BSDF f without the cosine [1/sr]; `pdf(out, in)`, the density
/// that `sample` draws `in` with; `sample(out, u)`, a pure function of a point u of the unit cube of `dimensions` numbers. Where light
/// leaves in single directions (mirror, glass), f and the density have no value, and are 0. The surfaces of this kit also
/// say `albedo(out)`, the mean of a bounce's weight, which is the integral of f |cos(in)| over `in`: in closed form, or to
/// the accuracy that is stated there.
template <class T>
concept Bsdf = requires(const T bsdf, Vec3<typename T::Scalar> w,
                        Eigen::Matrix<typename T::Scalar, T::dimensions, 1> u) {
  { bsdf.eval(w, w) } -> std::convertible_to<Rgb<typename T::Scalar>>;
  { bsdf.pdf(w, w) } -> std::same_as<Density<SolidAngle, typename T::Scalar>>;
  { bsdf.sample(w, u) } -> std::same_as<Bounce<typename T::Scalar>>;
};

/// What a surface has in common with all others that send light in single directions only.
template <class Real>
struct SingleDirections {
  using Scalar = Real;

  Rgb<Real> eval(const Vec3<Real>&, const Vec3<Real>&) const { return Rgb<Real>::Zero(); }
  Density<SolidAngle, Real> pdf(const Vec3<Real>&, const Vec3<Real>&) const {
    return Density<SolidAngle, Real>(Real(0));
  }
};

/// Throws std::invalid_argument unless the albedo is in [0,1] in every channel and lane.
template <class Real>
void require_albedo(const Rgb<Real>& albedo) {
  for (const Real& channel : albedo) {
    if (!all_within(channel, 0, 1))
      throw std::invalid_argument(
          "an albedo must be in [0,1] per channel (a surface reflects no more than it gets)");
  }
}

}  // namespace fairlight
