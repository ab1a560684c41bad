#pragma once

#include <fairlight/estimators/fresnel.h>
#include <fairlight/estimators/mirror.h>

namespace fairlight {

/// Smooth metal. Its complex index eta + i k, per channel, is relative to the medium above it.
/// Formula  in = out mirrored; weight = F(out.z, eta, k), by Fresnel's equations
/// Measure  none: a single direction; f and the density are 0
/// Domain   out.z > 0 (the weight is 0 elsewhere); eta in (0, 1e6], k in [0, 1e6]
/// Random   none: u has no dimensions
/// Source   Born and Wolf, 14.2; PBR 4ed, 9.4
template <class Real>
class Conductor : public SingleDirections<Real> {
 public:
  static constexpr int dimensions = 0;

  /// Throws std::invalid_argument for an index outside its domain.
  Conductor(const Rgb<Real>& eta, const Rgb<Real>& k) : eta_(eta), k_(k) { require_conductor(eta, k); }

  Rgb<Real> albedo(const Vec3<Real>& out) const {
    const Mask<Real> above = out.z() > Real(0);
    return select(above, fresnel_conductor(Real(select(above, out.z(), Real(1))), eta_, k_), zero<Rgb<Real>>());
  }

  Bounce<Real> sample(const Vec3<Real>& out, const Eigen::Matrix<Real, dimensions, 1>&) const {
    return {mirrored(out), albedo(out), Density<SolidAngle, Real>(Real(0))};
  }

 private:
  Rgb<Real> eta_, k_;
};

}  // namespace fairlight
