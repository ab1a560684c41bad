#pragma once

#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <fairlight/estimators/light_sample.h>

namespace fairlight::testing {

/// Radii and distances from 1e-3 to 1e5, log-uniform.
inline rc::Gen<double> length() {
  return rc::gen::map(rc::gen::inRange(-3000, 5001), [](int x) { return std::pow(10.0, x / 1000.0); });
}

inline Vec3<Packet> in_packets(const Vec3<double>& v) {
  return {rounded<Packet>(v.x()), rounded<Packet>(v.y()), rounded<Packet>(v.z())};
}

/// The first lane of a packet whose lanes are all equal.
inline double first_lane(const Packet& x) {
  std::array<double, lanes<Packet>> values{};
  store_lanes(x, values.data());
  for (double value : values) EXPECT_EQ(value, values[0]);
  return values[0];
}

/// Packets and double agree to 1e-5 in a sample, and in the density of a direction that floats can
/// represent. The tolerance is a few ulp of a float, divided by the cosine at the light.
template <class Light, class PacketLight>
void expect_same_sample(const Light& light, const PacketLight& packet_light, const Vec3<double>& from,
                        const Vec2<double>& u) {
  const LightSample<double> a = light.sample(from, u);
  const LightSample<Packet> b =
      packet_light.sample(in_packets(from), Vec2<Packet>(rounded<Packet>(u.x()), rounded<Packet>(u.y())));
  const double density = a.density.value();
  EXPECT_NEAR(first_lane(b.density.value()), density, 1e-5 * density);
  if (!(density > 0)) return;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(first_lane(b.direction[i]), a.direction[i], 1e-6);
  if (std::isfinite(a.distance)) {
    EXPECT_NEAR(first_lane(b.distance), a.distance, 1e-6 * a.distance);
  } else {
    EXPECT_EQ(first_lane(b.distance), a.distance);
  }
  const Vec3<double> held = a.direction.template cast<float>().template cast<double>();
  const double again = light.pdf(from, held).value();
  EXPECT_NEAR(first_lane(packet_light.pdf(in_packets(from), in_packets(held)).value()), again, 1e-5 * again);
}

/// If the length of a direction has a small relative error e, its density has a relative error of
/// at most 8 e, where the cosine at the light is at least 1/2. By area the density is the squared
/// distance over the cosine, and each has an error of a few e.
template <class Light>
void expect_density_off_by_as_much_as_the_direction(const Light& light, const Vec3<double>& from,
                                                    const Vec3<double>& direction) {
  constexpr double e = 1e-6;
  const double density = light.pdf(from, direction).value();
  EXPECT_GT(density, 0);
  for (double factor : {1 - e, 1 + e}) {
    EXPECT_LE(std::abs(light.pdf(from, factor * direction).value() / density - 1), 8 * e);
  }
}

/// At the edges of the square, including 1 - 2^-24, a sample is finite. If it exists, its direction
/// is a unit vector and its distance positive.
template <class PacketLight>
void expect_finite_at_edges(const PacketLight& light, const Vec3<Packet>& from) {
  for (float x : {0.0f, 0x1p-24f, 0.5f, 1 - 0x1p-24f}) {
    for (float y : {0.0f, 0x1p-24f, 0.5f, 1 - 0x1p-24f}) {
      const LightSample<Packet> sample = light.sample(from, Vec2<Packet>(Packet(x), Packet(y)));
      const double density = first_lane(sample.density.value());
      EXPECT_TRUE(density >= 0 && std::isfinite(density)) << x << " " << y;
      const Vec3<double> w(first_lane(sample.direction.x()), first_lane(sample.direction.y()),
                           first_lane(sample.direction.z()));
      EXPECT_TRUE(w.allFinite()) << x << " " << y;
      if (!(density > 0)) continue;
      EXPECT_LE(std::abs(w.norm() - 1), 6e-7) << x << " " << y;
      EXPECT_GE(first_lane(sample.distance), 0) << x << " " << y;
    }
  }
}

}  // namespace fairlight::testing
