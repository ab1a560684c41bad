#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/microfacets.h>

#include <fairlight/estimators/concepts.h>

namespace fairlight {
namespace {

using testing::direction_above;
using testing::roughness;
using testing::unit_point;

static_assert(Sampler<GgxVisibleNormals<double>>);
static_assert(Sampler<GgxVisibleNormals<Packet>>);

const Vec3<double> up(0, 0, 1);

TEST(Ggx, PilesItsFacetsUpAtTheNormal) {
  const Ggx<double> facets(0.5, 0.25);
  EXPECT_DOUBLE_EQ(facets.distribution(up), 8 / M_PI);
  EXPECT_DOUBLE_EQ(facets.distribution({1, 0, 0}), 8 / M_PI / std::pow(4, 2));
  EXPECT_DOUBLE_EQ(facets.distribution({0, 1, 0}), 8 / M_PI / std::pow(16, 2));
  EXPECT_EQ(facets.distribution({0, 0.6, -0.8}), 0);
}

TEST(Ggx, IsAHemisphereAtRoughnessOne) {
  const Ggx<double> facets(1, 1);
  EXPECT_DOUBLE_EQ(facets.distribution({0.6, 0, 0.8}), 1 / M_PI);
  EXPECT_DOUBLE_EQ(facets.projected_area({0.6, 0, 0.8}), 0.9);
  EXPECT_DOUBLE_EQ(facets.masking({0.6, 0, 0.8}), 0.8 / 0.9);
}

TEST(Ggx, MasksAsSmithDoes) {
  const Ggx<double> facets(0.5, 0.5);
  const Vec3<double> out(0.8, 0, 0.6), in(0, 0.6, 0.8);
  const double lambda_out = (std::sqrt(1 + 0.25 * 16 / 9) - 1) / 2;
  const double lambda_in = (std::sqrt(1 + 0.25 * 9 / 16) - 1) / 2;
  EXPECT_DOUBLE_EQ(facets.masking(out), 1 / (1 + lambda_out));
  EXPECT_DOUBLE_EQ(facets.visibility(out, in) * 4 * 0.6 * 0.8, 1 / (1 + lambda_out + lambda_in));
}

TEST(Ggx, RefusesARoughnessThatItCannotHave) {
  for (double alpha : {0.0, 0.9e-4, 1.1, -0.5, std::nan("")}) {
    EXPECT_THROW(Ggx<double>(alpha, 0.5), std::invalid_argument) << alpha;
    EXPECT_THROW(Ggx<double>(0.5, alpha), std::invalid_argument) << alpha;
    EXPECT_THROW(Ggx<Packet>(Packet(0.5f), Packet(static_cast<float>(alpha))), std::invalid_argument) << alpha;
  }
  EXPECT_NO_THROW(Ggx<double>(1e-4, 1));
  EXPECT_NO_THROW(Ggx<float>(1e-4f, 1));
}

TEST(GgxVisibleNormals, SeesAllFacetsByAreaFromAbove) {
  const GgxVisibleNormals<double> normals(Ggx<double>(0.5, 0.5), up);
  const Vec3<double> m(0.6, 0, 0.8);
  EXPECT_DOUBLE_EQ(normals.pdf(m).value(), 0.8 * Ggx<double>(0.5, 0.5).distribution(m));
}

TEST(GgxVisibleNormals, DoesNotSeeFacetsThatTurnAway) {
  const GgxVisibleNormals<double> normals(Ggx<double>(0.5, 0.5), {0.8, 0, 0.6});
  EXPECT_EQ(normals.pdf({-0.8, 0, 0.6}).value(), 0);
  EXPECT_EQ(normals.pdf({0.8, 0, -0.6}).value(), 0);
}

// u_x = 0 gives the half vector of `out` and the top of the cap. At alpha = 1 nothing is stretched.
TEST(GgxVisibleNormals, BeginsAtTheTopOfTheCap) {
  const GgxVisibleNormals<double> normals(Ggx<double>(1, 1), {0.6, 0, 0.8});
  const Vec3<double> halfway = Vec3<double>(0.6, 0, 1.8).normalized();
  EXPECT_TRUE(normals.sample({0, 0.3}).isApprox(halfway, 1e-15));
}

TEST(GgxVisibleNormals, RefusesToBeSeenFromBelow) {
  const Ggx<double> facets(0.5, 0.5);
  EXPECT_THROW(GgxVisibleNormals<double>(facets, {1, 0, 0}), std::invalid_argument);
  EXPECT_THROW(GgxVisibleNormals<double>(facets, {0.6, 0, -0.8}), std::invalid_argument);
}

template <class Real>
void expect_in_domain(const GgxVisibleNormals<Real>& normals, const Vec2<Real>& u) {
  const Vec3<Real> m = normals.sample(u);
  RC_ASSERT(std::abs(m.norm() - 1) <= 2 * ulp<Real>);
  RC_ASSERT(m.z() > 0);
  RC_ASSERT(std::isfinite(normals.pdf(m).value()) && normals.pdf(m).value() >= 0);
  RC_ASSERT(std::isfinite(normals.reflected_pdf(m).value()) && normals.reflected_pdf(m).value() > 0);
}

// For anisotropic roughness, any direction and any point of the square, including its edges.
RC_GTEST_PROP(GgxVisibleNormals, GivesUnitNormalsAboveTheSurface, ()) {
  const Ggx<double> facets(*roughness(), *roughness());
  const GgxVisibleNormals<double> normals(facets, *direction_above());
  expect_in_domain(normals, *unit_point());
  for (const Vec2<double>& u : testing::edge_points()) expect_in_domain(normals, u);
}

RC_GTEST_PROP(GgxVisibleNormals, GivesUnitNormalsAboveTheSurfaceInFloats, ()) {
  const Ggx<float> facets(static_cast<float>(*roughness()), static_cast<float>(*roughness()));
  const GgxVisibleNormals<float> normals(facets, (*direction_above()).cast<float>());
  expect_in_domain(normals, *testing::unit_point_float());
  for (const Vec2<float>& u : testing::edge_points_float()) expect_in_domain(normals, u);
}

// The point of the cap is nearly opposite to w, and their sum has the length 1e-4.
TEST(GgxVisibleNormals, KeepsItsDigitsInFloatsWhereTheSumCancels) {
  const Vec3<float> out(0.8f, 0, 0.6f);
  const GgxVisibleNormals<float> floats(Ggx<float>(0.5f, 0.25f), out);
  const GgxVisibleNormals<double> doubles(Ggx<double>(0.5, 0.25), out.cast<double>().normalized());
  const Vec2<float> u(1 - 0x1p-15f, 0.5f + 0x1p-15f);
  const Vec3<double> exact = doubles.sample(u.cast<double>());
  EXPECT_LE((floats.sample(u).cast<double>() - exact).norm(), 1e-6) << exact.transpose();
}

// Rounding changes m by about 1e-16. This changes the unstretched normal by 1e-16 over the
// roughness, and the turn by that over its distance from the top of the cap.
RC_GTEST_PROP(GgxVisibleNormals, InvertsItsSamples, ()) {
  const double alpha_x = *roughness(), alpha_y = *roughness();
  const GgxVisibleNormals<double> normals(Ggx<double>(alpha_x, alpha_y), *direction_above());
  const Vec2<double> u = Vec2<double>::Constant(0.01) + 0.98 * *unit_point();
  const Vec2<double> back = normals.invert(normals.sample(u));
  RC_ASSERT((back - u).norm() <= 1e-10);
}

// At the edges the turn is undefined if the normal is the top or the bottom of the cap, and turns 0
// and 1 are the same. So the test compares the points of the cap.
template <class Real>
void expect_inverse_at_the_edges(const Vec3<Real>& out, Real alpha, const Vec2<Real>& u) {
  const GgxVisibleNormals<Real> normals({alpha, alpha}, out);
  const Real tolerance = Real(16) * ulp<Real> / alpha;
  const Vec2<Real> back = normals.invert(normals.sample(u));
  RC_ASSERT(back.x() >= 0 && back.x() <= 1 + tolerance);
  RC_ASSERT(back.y() >= 0 && back.y() <= 1);
  RC_ASSERT(std::abs(back.x() - u.x()) <= tolerance);
  const Real radius = std::sqrt(u.x() * (1 - u.x()));
  RC_ASSERT(std::abs(std::sin(pi<Real> * (back.y() - u.y()))) * radius <= tolerance);
}

RC_GTEST_PROP(GgxVisibleNormals, InvertsItsSamplesAtTheEdges, ()) {
  const Vec3<double> out = *direction_above();
  const double alpha = *roughness();
  for (const Vec2<double>& u : testing::edge_points()) expect_inverse_at_the_edges<double>(out, alpha, u);
  for (const Vec2<float>& u : testing::edge_points_float()) {
    expect_inverse_at_the_edges<float>(out.cast<float>(), std::max(0.01f, static_cast<float>(alpha)), u);
  }
}

RC_GTEST_PROP(GgxVisibleNormals, HasNoNumbersForANormalThatTurnsAway, ()) {
  const Vec3<double> out = *direction_above();
  const GgxVisibleNormals<double> normals({*roughness(), *roughness()}, out);
  const Vec3<double> m = *direction_above();
  RC_PRE(std::abs(out.dot(m)) > 1e-6);
  RC_ASSERT((normals.invert(m).x() > 1) == (out.dot(m) < 0));
}

// The warp maps areas of the square to solid angles: |dm/du x dm/dv| = 1/p.
RC_GTEST_PROP(GgxVisibleNormals, HasTheJacobianOneOverItsDensity, ()) {
  const GgxVisibleNormals<double> normals(Ggx<double>(*roughness(), *roughness()), *direction_above());
  const Vec2<double> u = Vec2<double>::Constant(0.05) + 0.9 * *unit_point();
  constexpr double h = 1e-5;
  const auto slope = [&](const Vec2<double>& step) {
    return Vec3<double>((normals.sample(u + step) - normals.sample(u - step)) / (2 * h));
  };
  const double jacobian = slope({h, 0}).cross(slope({0, h})).norm() * normals.pdf(normals.sample(u)).value();
  RC_ASSERT(std::abs(jacobian - 1) < 1e-5);
}

TEST(GgxVisibleNormals, IsTheSameInPackets) {
  const Vec3<double> out(0.48, 0.64, 0.6);
  const GgxVisibleNormals<double> normals(Ggx<double>(0.5, 0.125), out);
  const GgxVisibleNormals<Packet> packets(Ggx<Packet>(Packet(0.5f), Packet(0.125f)), out.cast<Packet>());
  EXPECT_LE(std::abs(packets.invert(packets.sample({0, 0})).x().get(0)), 2e-7f);
  for (const Vec2<double>& u : {Vec2<double>(0.125, 0.25), Vec2<double>(0.25, 0.5), Vec2<double>(0.875, 0.0625)}) {
    const Vec3<double> m = normals.sample(u);
    const Vec3<Packet> n = packets.sample(u.cast<Packet>());
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(static_cast<double>(n[axis].get(0)), m[axis], 2e-7);
    EXPECT_NEAR(static_cast<double>(packets.pdf(n).value().get(0)) / normals.pdf(m).value(), 1, 2e-6);
    EXPECT_NEAR(static_cast<double>(packets.invert(n).x().get(0)), u.x(), 2e-6);
    EXPECT_NEAR(static_cast<double>(packets.invert(n).y().get(0)), u.y(), 2e-6);
  }
}

TEST(GgxVisibleNormals, RefusesADirectionThatIsNoUnitVector) {
  EXPECT_THROW(GgxVisibleNormals<double>({0.5, 0.5}, {0, 0, 2}), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight
