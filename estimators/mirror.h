#pragma once

#include <fairlight/estimators/bsdf.h>

namespace fairlight {

/// The mirror direction: `out` turned by 180 degrees about the normal.
template <class Real>
Vec3<Real> mirrored(const Vec3<Real>& out) {
  return {-out.x(), -out.y(), out.z()};
}

/// A perfect mirror, with the same reflectance at all angles.
/// Formula  in = out mirrored; weight = albedo
/// Measure  none: a single direction; f and the density are 0
/// Domain   out.z > 0 (the weight is 0 elsewhere); albedo in [0,1] per channel
/// Random   none: u has no dimensions
/// Source   PBR 4ed, 9.3.1 (the law of reflection); the paper, 4.3
template <class Real>
class Mirror : public SingleDirections<Real> {
 public:
  static constexpr int dimensions = 0;

  /// Throws std::invalid_argument for an albedo outside [0,1].
  explicit Mirror(const Rgb<Real>& albedo) : albedo_(albedo) { require_albedo(albedo); }

  Rgb<Real> albedo(const Vec3<Real>& out) const { return albedo_ * select(out.z() > Real(0), Real(1), Real(0)); }

  Bounce<Real> sample(const Vec3<Real>& out, const Eigen::Matrix<Real, dimensions, 1>&) const {
    return {mirrored(out), albedo(out), Density<SolidAngle, Real>(Real(0))};
  }

 private:
  Rgb<Real> albedo_;
};

}  // namespace fairlight
