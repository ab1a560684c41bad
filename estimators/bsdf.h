#pragma once

#include <stdexcept>

#include <fairlight/estimators/concepts.h>

namespace fairlight {

/// Directions at a surface are unit vectors in its local frame: the normal is +z, and the side that
/// the viewer sees is z > 0. `out` points to the viewer, `in` to where the light comes from.
/// Vectors are never normalised. Glossy and RoughConductor build a law about `out`; they throw
/// std::invalid_argument for one that is not a unit vector, where they sample or evaluate that law.
/// Everywhere else the formula is evaluated as it stands: the mirror image of a vector of length 2
/// has length 2.

/// A sampled direction and its weight.
template <class Real>
struct Bounce {
  Vec3<Real> in;                      ///< local, unit
  Rgb<Real> weight;                   ///< f |cos(in)| / p; 0 if the light is absorbed or the sample does not exist
  Density<SolidAngle, Real> density;  ///< p of `in` [1/sr]; 0 for a single direction (delta)
};

/// `eval(out, in)` is the BSDF f without the cosine [1/sr]. `sample(out, u)` is a pure function of
/// a point u of the unit cube, which has `dimensions` dimensions. `pdf(out, in)` is the density of
/// its `in`. For single directions (mirror, glass) f and the density have no value, and are 0.
/// The surfaces of the kit also have `albedo(out)`, the mean of a bounce's weight, which is the
/// integral of f |cos(in)| over `in`. It is in closed form, or to the accuracy stated there.
template <class T>
concept Bsdf = requires(const T bsdf, Vec3<typename T::Scalar> w,
                        Eigen::Matrix<typename T::Scalar, T::dimensions, 1> u) {
  { bsdf.eval(w, w) } -> std::convertible_to<Rgb<typename T::Scalar>>;
  { bsdf.pdf(w, w) } -> std::same_as<Density<SolidAngle, typename T::Scalar>>;
  { bsdf.sample(w, u) } -> std::same_as<Bounce<typename T::Scalar>>;
};

/// Base of the surfaces that send light in single directions only: f and the density are 0.
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
