#pragma once

#include <array>
#include <type_traits>

#include <gtest/gtest.h>
#include <support/materials.h>

#include <fairlight/estimators/bsdf.h>

namespace fairlight::testing {

/// The edge numbers of a source, in the lanes of Real: 0, the smallest above 0, 1/2 and the largest
/// below 1.
template <class Real>
std::array<Lane<Real>, 4> edge_numbers() {
  constexpr Lane<Real> tiny = ulp<Real> / 2;
  return {0, tiny, Lane<Real>(0.5), 1 - tiny};
}

/// Whether the direction of a bounce is a unit vector, and its density and weight are finite and
/// nonnegative.
template <class Real>
bool is_in_order(const Bounce<Real>& bounce) {
  using std::abs;
  const Real infinite(infinity<Real>);
  const Real p = bounce.density.value();
  bool good = all(p >= Real(0)) && all(p < infinite) && all_finite(bounce.in);
  good = good && all(abs(bounce.in.norm() - Real(1)) <= Real(16) * ulp<Real>);
  for (int c = 0; c < 3; ++c) good = good && all(bounce.weight[c] >= Real(0)) && all(bounce.weight[c] < infinite);
  return good;
}

enum class Below { black, lit };

/// For every combination of edge numbers: the bounce passes is_in_order, and so do f and the
/// density of its direction. Below an opaque surface a bounce weighs 0.
template <Bsdf Surface>
void check_edges(const Surface& surface, const Vec3<double>& towards, Below below) {
  using Real = typename Surface::Scalar;
  constexpr int numbers = Surface::dimensions;
  const Vec3<Real> out = rounded_vector<Real>(towards);
  for (int corner = 0; corner < (1 << (2 * numbers)); ++corner) {
    Eigen::Matrix<Real, numbers, 1> u;
    for (int d = 0; d < numbers; ++d)
      u[d] = Real(edge_numbers<Real>()[static_cast<std::size_t>(corner >> (2 * d)) % 4]);
    const Bounce<Real> bounce = surface.sample(out, u);
    RC_ASSERT(is_in_order(bounce));
    RC_ASSERT(below == Below::lit || all(bounce.in.z() > Real(0) || max_channel(bounce.weight) == Real(0)));
    RC_ASSERT(is_in_order(Bounce<Real>{bounce.in, surface.eval(out, bounce.in), surface.pdf(out, bounce.in)}));
  }
}

/// The same for the surfaces that `make(type_identity<Real>)` makes in double, float and packets.
template <class Make>
void check_edges_in_all(const Make& make, const Vec3<double>& out, Below below = Below::black) {
  check_edges(make(std::type_identity<double>{}), out, below);
  check_edges(make(std::type_identity<float>{}), out, below);
  check_edges(make(std::type_identity<Packet>{}), out, below);
}

}  // namespace fairlight::testing
