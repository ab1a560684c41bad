#pragma once

#include <fairlight/estimators/fresnel.h>
#include <fairlight/estimators/mirror.h>

namespace fairlight {

/// The quantity that a path carries from `in` to `out`.
enum class Transport {
  radiance,    ///< [W/(sr m^2)], on camera paths; refraction into a medium of index eta scales it by eta^2
  importance,  ///< power, and importance emitted by the camera, on light paths; not scaled
};

/// Smooth glass: reflects with Fresnel's probability F, and refracts otherwise. The normal points
/// out of the glass: z > 0 is outside and z < 0 inside, for `out` and for `in`.
/// Formula  with probability F(|out.z|, eta): in = out mirrored, weight 1; else in by Snell's law,
///          weight 1/eta^2 for radiance, 1 for importance; eta = index if out.z > 0, else 1/index
/// Measure  none: single directions; f and the density are 0
/// Domain   all unit vectors; index in [0.1, 10], the inside's over the outside's
/// Random   one number u in [0,1)
/// Source   PBR 4ed, 9.5; Veach 1997, 5.2 (refraction keeps radiance over eta^2)
template <class Real, Transport transport = Transport::radiance>
class Dielectric : public SingleDirections<Real> {
 public:
  static constexpr int dimensions = 1;

  /// Throws std::invalid_argument for an index outside its domain. Beyond it, a direction refracted
  /// in floats is not a unit vector.
  explicit Dielectric(Real index) : index_(index) {
    if (!all_within(index, 0.1, 10)) {
      throw std::invalid_argument(
          "an index of refraction must be positive and finite, from 0.1 to 10 (give that of the "
          "inside over that of the outside)");
    }
  }

  /// The index of refraction on the far side, divided by that on the side of `out`.
  Real eta(const Vec3<Real>& out) const { return select(out.z() > Real(0), index_, Real(Real(1) / index_)); }

  /// The probability of reflection.
  Real reflectance(const Vec3<Real>& out) const {
    using std::abs;
    return fresnel_dielectric(Real(abs(out.z())), eta(out));
  }

  /// 1 for importance, as energy is conserved. Radiance is eta^2 times as dense in the medium of
  /// larger index.
  Rgb<Real> albedo(const Vec3<Real>& out) const {
    const Real reflected = reflectance(out);
    return Rgb<Real>::Constant(reflected + (Real(1) - reflected) * refracted_weight(out));
  }

  Bounce<Real> sample(const Vec3<Real>& out, const Eigen::Matrix<Real, dimensions, 1>& u) const {
    const Mask<Real> reflects = u[0] < reflectance(out);
    const Real weight = select(reflects, Real(1), refracted_weight(out));
    return {select(reflects, mirrored(out), refracted(out)), Rgb<Real>::Constant(weight),
            Density<SolidAngle, Real>(Real(0))};
  }

 private:
  Real refracted_weight(const Vec3<Real>& out) const {
    if constexpr (transport == Transport::radiance) {
      return Real(1) / (eta(out) * eta(out));
    } else {
      return Real(1);
    }
  }

  /// By Snell's law. Lies in the surface at total internal reflection, where it is not used.
  Vec3<Real> refracted(const Vec3<Real>& out) const {
    using std::abs;
    using std::sqrt;
    const Real relative = eta(out);
    const Real square = detail::refracted_square(Real(abs(out.z())), relative);
    const Real height = sqrt(select(square > Real(0), square, Real(0)));
    return {-out.x() / relative, -out.y() / relative, select(out.z() > Real(0), Real(-height), height) / relative};
  }

  Real index_;
};

}  // namespace fairlight
