#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include <gtest/gtest.h>
#include <support/unit_square.h>

#include <fairlight/estimators/concepts.h>

namespace fairlight::testing {

/// Tests for any law of directions, or of points given by unit normals.

/// At the edges of the square, in the law's own arithmetic: samples are unit vectors, and their
/// density is positive and finite.
template <Sampler Law>
void expect_unit_vectors_in_the_support(const Law& law) {
  using Real = typename Law::Scalar;
  using std::abs;
  for (const Vec2<Real>& u : edge_points<Real>()) {
    const Vec3<Real> w = law.sample(u);
    EXPECT_TRUE(all(abs(w.norm() - Real(1)) <= Real(4) * ulp<Real>)) << law.pdf(w).value();
    EXPECT_TRUE(all(law.pdf(w).value() > Real(0) && law.pdf(w).value() < Real(infinity<Real>)));
  }
}

/// At the edges of the square, the inverse lies in the square, to rounding.
template <Sampler Law>
void expect_inverses_in_the_square(const Law& law) {
  using Real = typename Law::Scalar;
  for (const Vec2<Real>& u : edge_points<Real>()) {
    const Vec2<Real> back = law.invert(law.sample(u));
    EXPECT_TRUE(all(back.x() >= Real(0) && back.x() <= Real(1) + Real(16) * ulp<Real>)) << u.x();
    EXPECT_TRUE(all(back.y() >= Real(0) && back.y() < Real(1))) << u.y();
  }
}

/// A point of the square, far enough from its edges for finite differences.
inline Vec2<double> inner_point() { return Vec2<double>::Constant(0.01) + 0.98 * *unit_point(); }

/// The warp maps areas of the square to solid angles: the component of dw/du x dw/dv along w is
/// 1/p.
template <Sampler Law>
void check_jacobian(const Law& law) {
  const Vec2<double> u = inner_point();
  constexpr double h = 1e-6;
  const Vec3<double> du = (law.sample(u + Vec2<double>(h, 0)) - law.sample(u - Vec2<double>(h, 0))) / (2 * h);
  const Vec3<double> dv = (law.sample(u + Vec2<double>(0, h)) - law.sample(u - Vec2<double>(0, h))) / (2 * h);
  const Vec3<double> w = law.sample(u);
  RC_ASSERT(std::abs(std::abs(du.cross(dv).dot(w)) * law.pdf(w).value() - 1) < 1e-6);
}

/// The inverse returns the random numbers; the turn is compared modulo 1.
template <Sampler Law>
void check_round_trip(const Law& law, double tolerance) {
  const Vec2<double> u = inner_point();
  const Vec2<double> off = (law.invert(law.sample(u)) - u).cwiseAbs();
  RC_ASSERT(off.x() <= tolerance);
  RC_ASSERT(std::min(off.y(), 1 - off.y()) <= tolerance);
}

/// Packets and double agree at a few points of the square, one per lane: in directions, densities
/// and inverses. `make(type_identity<Real>)` makes the law; `tolerance` is relative for densities
/// and absolute for the rest.
template <class Make>
void expect_packets_agree(const Make& make, double tolerance) {
  const auto law = make(std::type_identity<double>{});
  const auto packets = make(std::type_identity<Packet>{});
  const auto lane = [](const Packet& x, std::size_t i) {
    std::array<double, lanes<Packet>> values{};
    store_lanes(x, values.data());
    return values[i];
  };
  std::array<std::array<float, lanes<Packet>>, 2> numbers{};
  for (std::size_t i = 0; i < lanes<Packet>; ++i) {
    const float place = (static_cast<float>(i) + 0.5f) / static_cast<float>(lanes<Packet>);
    numbers[0][i] = place;
    numbers[1][i] = 1 - place * place;
  }
  const Vec3<Packet> w =
      packets.sample({Packet::load_unaligned(numbers[0].data()), Packet::load_unaligned(numbers[1].data())});
  const Packet density = packets.pdf(w).value();
  const Vec2<Packet> back = packets.invert(w);
  for (std::size_t i = 0; i < lanes<Packet>; ++i) {
    const Vec2<double> u(numbers[0][i], numbers[1][i]);
    const Vec3<double> expected = law.sample(u);
    for (int k = 0; k < 3; ++k) EXPECT_LE(std::abs(lane(w[k], i) - expected[k]), tolerance);
    for (int k = 0; k < 2; ++k) EXPECT_LE(std::abs(lane(back[k], i) - u[k]), tolerance);
    EXPECT_LE(std::abs(lane(density, i) / law.pdf(expected).value() - 1), tolerance);
  }
}

}  // namespace fairlight::testing
