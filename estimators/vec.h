#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <fairlight/estimators/packet.h>

namespace fairlight {

template <class Real>
using Vec2 = Eigen::Matrix<Real, 2, 1>;
template <class Real>
using Vec3 = Eigen::Matrix<Real, 3, 1>;
/// Red, green and blue: a radiance in W/(sr m^2), or a reflectance in [0,1].
template <class Real>
using Rgb = Eigen::Array<Real, 3, 1>;

/// A vector or a colour, rounded to Real.
template <class Real>
Vec3<Real> rounded_vector(const Vec3<double>& v) {
  return {rounded<Real>(v.x()), rounded<Real>(v.y()), rounded<Real>(v.z())};
}
template <class Real>
Rgb<Real> rounded_colour(const Rgb<double>& colour) {
  return {rounded<Real>(colour[0]), rounded<Real>(colour[1]), rounded<Real>(colour[2])};
}

/// The largest channel.
template <class Real>
Real max_channel(const Rgb<Real>& colour) {
  using std::max;
  return max(max(colour[0], colour[1]), colour[2]);
}

/// The mean of the channels.
template <class Real>
Real mean_channel(const Rgb<Real>& colour) {
  return (colour[0] + colour[1] + colour[2]) / Real(3);
}

/// Zero of a number, vector or colour type.
template <class Value>
Value zero() {
  if constexpr (requires { Value::Zero(); }) {
    return Value::Zero();
  } else {
    return Value(0);
  }
}

/// Whether no component of any lane is infinite or NaN.
template <class Real>
bool all_finite(const Vec3<Real>& v) {
  return all_finite(v.x()) && all_finite(v.y()) && all_finite(v.z());
}

/// Throws std::invalid_argument unless `v`, called `what`, is a unit vector to rounding.
template <class Real>
void require_unit(const Vec3<Real>& v, const char* what) {
  using std::abs;
  const Real off = v.squaredNorm() - Real(1);
  if (all_finite(off) && all(Real(abs(off)) <= Real(256 * ulp<Real>))) return;
  throw std::invalid_argument(std::string(what) + " must be a unit vector (divide it by its length)");
}

/// An orthonormal, right-handed frame about a unit normal, which is neither checked nor normalised:
/// a relative error e in its length gives an error of about e in the frame. A zero component may
/// have either sign, depending on the instruction set.
/// Source   Duff et al. 2017, "Building an orthonormal basis, revisited"
template <class Real>
class Frame {
 public:
  explicit Frame(const Vec3<Real>& normal) : normal_(normal) {
    const Real sign = select(normal.z() < Real(0), Real(-1), Real(1));
    const Real a = Real(-1) / (sign + normal.z());
    const Real b = normal.x() * normal.y() * a;
    tangent_ = {Real(1) + sign * normal.x() * normal.x() * a, sign * b, -sign * normal.x()};
    bitangent_ = {b, sign + normal.y() * normal.y() * a, -normal.y()};
  }

  /// From the frame, in which the normal is +z, to the world.
  Vec3<Real> to_world(const Vec3<Real>& local) const {
    return tangent_ * local.x() + bitangent_ * local.y() + normal_ * local.z();
  }

  /// From the world to the frame.
  Vec3<Real> to_local(const Vec3<Real>& world) const {
    return {tangent_.dot(world), bitangent_.dot(world), normal_.dot(world)};
  }

 private:
  Vec3<Real> tangent_, bitangent_, normal_;
};

}  // namespace fairlight
