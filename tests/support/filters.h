#pragma once

#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <support/unit_square.h>

#include <fairlight/estimators/vec.h>

namespace fairlight::testing {

/// Tests for any pixel filter, in any arithmetic; `make(type_identity<Real>)` makes the filter.

/// 0, 1/2 and the largest number below 1 (1 - 2^-53, in floats 1 - 2^-24), and their neighbours.
template <class Real>
std::array<double, 8> edge_numbers() {
  const double step = static_cast<double>(ulp<Real>) / 2;
  return {0, step, 2 * step, 0.5 - step, 0.5, 0.5 + step, 1 - 2 * step, 1 - step};
}

/// Draws at the edges of the square are in the support, which has half the width `radius`.
template <class Real, class Make>
void expect_in_support_at_the_edges(const Make& make, double radius) {
  const auto filter = make(std::type_identity<Real>{});
  for (double a : edge_numbers<Real>()) {
    for (double b : edge_numbers<Real>()) {
      const Vec2<Real> x = filter.sample({rounded<Real>(a), rounded<Real>(b)});
      std::array<double, lanes<Real>> across{}, density{};
      store_lanes(x.x(), across.data());
      store_lanes(filter.pdf(x).value(), density.data());
      EXPECT_LE(std::abs(across[0]), radius) << a << ' ' << b;
      EXPECT_GT(density[0], 0) << a << ' ' << b;
    }
  }
}

/// Lane by lane, packets agree with double: offsets to `offset_error` times the radius, densities
/// to `density_error`.
template <class Make>
void expect_packets_like_double(const Make& make, double radius, double offset_error, double density_error) {
  const auto filter = make(std::type_identity<double>{});
  const auto packets = make(std::type_identity<Packet>{});
  for (int i = 0; i < 64; ++i) {
    std::array<float, lanes<Packet>> u{};
    for (std::size_t k = 0; k < u.size(); ++k) {
      u[k] = static_cast<float>(i * static_cast<int>(u.size()) + static_cast<int>(k)) /
             static_cast<float>(64 * u.size());
    }
    const Packet all = Packet::load_unaligned(u.data());
    const Vec2<Packet> x = packets.sample({all, Packet(0.375f)});
    std::array<double, lanes<Packet>> across{}, along{}, density{};
    store_lanes(x.x(), across.data());
    store_lanes(x.y(), along.data());
    store_lanes(packets.pdf(x).value(), density.data());
    for (std::size_t k = 0; k < u.size(); ++k) {
      const Vec2<double> expected = filter.sample({static_cast<double>(u[k]), 0.375});
      EXPECT_LE((Vec2<double>(across[k], along[k]) - expected).norm(), offset_error * radius) << u[k];
      const double reference = filter.pdf({across[k], along[k]}).value();
      EXPECT_LE(std::abs(density[k] / reference - 1), density_error) << u[k];
    }
  }
}

/// A radius that is not positive and finite throws.
template <template <class> class Filter>
void expect_radius_refused() {
  for (double wrong : {0.0, -1.0, infinity<double>, std::nan("")}) {
    EXPECT_THROW(Filter<double>{wrong}, std::invalid_argument) << wrong;
    EXPECT_THROW(Filter<Packet>{rounded<Packet>(wrong)}, std::invalid_argument) << wrong;
  }
}

/// The derivative of the warp along each axis is one over that axis's density, so the warp inverts
/// the CDF.
template <class Filter>
bool has_the_jacobian_one_over_its_density(const Filter& filter, const Vec2<double>& u, double tolerance) {
  constexpr double h = 1e-6;
  const Vec2<double> wide =
      (filter.sample(u + Vec2<double>(h, h)) - filter.sample(u - Vec2<double>(h, h))) / (2 * h);
  return std::abs(wide.prod() * filter.pdf(filter.sample(u)).value() - 1) < tolerance;
}

}  // namespace fairlight::testing
