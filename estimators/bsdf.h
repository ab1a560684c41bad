#pragma once

#include <fairlight/estimators/concepts.h>

namespace fairlight {

/// Directions at a surface are unit vectors in its local frame, where the normal is +z and the side that is looked at is
/// z > 0: `out` towards the viewer, `in` towards where the light comes from.

/// A direction that light may have come from, and what it is worth.
template <class Real>
struct Bounce {
  Vec3<Real> in;     ///< local, unit
  Rgb<Real> weight;  ///< f |cos(in)| / p; 0 where the light is absorbed, or the sample does not exist
  Density<SolidAngle, Real> density;  ///< p of `in` [1/sr]; 0 where it was a single direction, not a density's
};

/// What a surface does with light: `eval(out, in)`, the BSDF f without the cosine [1/sr]; `pdf(out, in)`, the density
/// that `sample` draws `in` with; `sample(out, u)`, a pure function of a point u of the unit square or cube. Where light
/// leaves in single directions (mirror, glass), f and the density have no value, and are 0.
template <class T>
concept Bsdf = requires(const T bsdf, Vec3<typename T::Scalar> w,
                        Eigen::Matrix<typename T::Scalar, T::dimensions, 1> u) {
  { bsdf.eval(w, w) } -> std::convertible_to<Rgb<typename T::Scalar>>;
  { bsdf.pdf(w, w) } -> std::same_as<Density<SolidAngle, typename T::Scalar>>;
  { bsdf.sample(w, u) } -> std::same_as<Bounce<typename T::Scalar>>;
};

}  // namespace fairlight
