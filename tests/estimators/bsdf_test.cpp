#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/bounces.h>

#include <fairlight/estimators/conductor.h>
#include <fairlight/estimators/dielectric.h>
#include <fairlight/estimators/energy_compensation.h>
#include <fairlight/estimators/glossy.h>
#include <fairlight/estimators/lambertian.h>
#include <fairlight/estimators/mixture.h>

// Tests for all surfaces, in double, float and packets: at edge numbers, and for z from 1 to 1e-6.
namespace fairlight {
namespace {

using testing::between;
using testing::check_edges_in_all;
using testing::direction_above;

template <class Real>
Rgb<Real> colour(double red, double green, double blue) {
  return {rounded<Real>(red), rounded<Real>(green), rounded<Real>(blue)};
}

// Includes 0 and exponents below 1.
rc::Gen<double> exponent() { return rc::gen::oneOf(between(0.01, 1e6), rc::gen::element(0.0, 0.5, 1.0)); }

RC_GTEST_PROP(Bsdf, LambertianIsInOrderAtTheEdges, ()) {
  const auto surface = []<class Real>(std::type_identity<Real>) {
    return Lambertian<Real>(colour<Real>(1, 0.5, 0));
  };
  check_edges_in_all(surface, *direction_above());
}

RC_GTEST_PROP(Bsdf, GlossyIsInOrderAtTheEdges, ()) {
  const double n = *exponent();
  const Vec3<double> out = *direction_above();
  const auto lobe = [&]<class Real>(std::type_identity<Real>) {
    return Glossy<Real>(colour<Real>(1, 0.5, 0), rounded<Real>(n));
  };
  const auto cosine = [&]<class Real>(std::type_identity<Real>) {
    return Glossy<Real, CosineHemisphere>(colour<Real>(1, 0.5, 0), rounded<Real>(n));
  };
  check_edges_in_all(lobe, out);
  check_edges_in_all(cosine, out);
}

RC_GTEST_PROP(Bsdf, RoughConductorIsInOrderAtTheEdges, ()) {
  const double alpha_x = *between(1e-4, 1), alpha_y = *between(1e-4, 1);
  const auto surface = [&]<class Real>(std::type_identity<Real>) {
    using Fresnel = FresnelReflectance<Real>;
    return RoughConductor<Real, Fresnel>({rounded<Real>(alpha_x), rounded<Real>(alpha_y)},
                                         Fresnel(colour<Real>(0.2, 0.9, 1.5), colour<Real>(3.9, 2.5, 0)));
  };
  check_edges_in_all(surface, *direction_above());
}

RC_GTEST_PROP(Bsdf, EnergyCompensatedConductorIsInOrderAtTheEdges, ()) {
  const double alpha = *between(1e-4, 1);
  const auto surface = [&]<class Real>(std::type_identity<Real>) {
    using Schlick = SchlickReflectance<Real>;
    return EnergyCompensatedConductor<Real, Schlick>(alpha, Schlick(colour<Real>(1, 0.5, 0)));
  };
  check_edges_in_all(surface, *direction_above());
}

RC_GTEST_PROP(Bsdf, MirrorAndConductorAreInOrder, ()) {
  const double index = *between(0.01, 20), extinction = *between(1e-3, 20);
  const Vec3<double> out = *direction_above();
  check_edges_in_all([]<class Real>(std::type_identity<Real>) { return Mirror<Real>(colour<Real>(1, 0.5, 0)); },
                     out);
  const auto metal = [&]<class Real>(std::type_identity<Real>) {
    return Conductor<Real>(colour<Real>(index, 1, 1), colour<Real>(extinction, extinction, 0));
  };
  check_edges_in_all(metal, out);
}

RC_GTEST_PROP(Bsdf, DielectricIsInOrderAtTheEdges, ()) {
  const double index = *testing::index_of_refraction();
  const Vec3<double> out = *direction_above();
  const auto glass = [&]<class Real>(std::type_identity<Real>) { return Dielectric<Real>(rounded<Real>(index)); };
  check_edges_in_all(glass, out, testing::Below::lit);
  check_edges_in_all(glass, -out, testing::Below::lit);
}

// Mixes a lobe that the surface cuts off, a lobe with all directions, and a single direction. The
// probability of either of the first two may be 2^-20.
RC_GTEST_PROP(Bsdf, MixtureIsInOrderAtTheEdges, ()) {
  const double n = *exponent(), alpha = *between(1e-4, 1);
  const double q = *rc::gen::element(0x1p-20, 0.25, 0.5, 1 - 0x1p-20);
  const Vec3<double> out = *direction_above();
  const auto two = [&]<class Real>(std::type_identity<Real>) {
    const Glossy<Real> glossy(colour<Real>(1, 0.5, 0), rounded<Real>(n));
    return Mixture(WeightedLobe{glossy, Real(0.5), rounded<Real>(q)},
                   WeightedLobe{Lambertian<Real>(colour<Real>(0, 0.5, 1)), Real(0.5), rounded<Real>(1 - q)});
  };
  const auto three = [&]<class Real>(std::type_identity<Real> real) {
    const Mirror<Real> mirror(colour<Real>(1, 1, 1));
    const RoughConductor<Real> rough({rounded<Real>(alpha), rounded<Real>(alpha)},
                                     ConstantReflectance<Real>(colour<Real>(1, 0.5, 0)));
    const Mixture coat(WeightedLobe{mirror, Real(0.5), Real(0.5)}, WeightedLobe{rough, Real(0.5), Real(0.5)});
    return Mixture(WeightedLobe{coat, Real(0.5), rounded<Real>(q)},
                   WeightedLobe{two(real), Real(0.5), rounded<Real>(1 - q)});
  };
  check_edges_in_all(two, out);
  check_edges_in_all(three, out);
}

const Vec3<double> unit(0.6, 0, 0.8);

// Glossy with exponent 0 reflects (1 + z) / 2.
TEST(Bsdf, SaysItsAlbedoInAMixtureToo) {
  const Mixture surface(WeightedLobe{Glossy<double>(colour<double>(1, 0.5, 0), 0), 0.5, 0.5},
                        WeightedLobe{Lambertian<double>(colour<double>(0, 1, 1)), 0.5, 0.5});
  EXPECT_TRUE(surface.albedo(unit).isApprox(colour<double>(0.45, 0.725, 0.5), 1e-11));
}

// A surface without a law about `out` does not normalise vectors: a vector of length 2 gives twice
// the result.
TEST(Bsdf, DoesNotNormaliseDirections) {
  EXPECT_EQ(Mirror<double>(colour<double>(1, 1, 1)).sample(2 * unit, {}).in, Vec3<double>(-1.2, 0, 1.6));
  const Lambertian<double> diffuse(colour<double>(1, 1, 1));
  EXPECT_DOUBLE_EQ(diffuse.pdf(unit, 2 * unit).value(), 1.6 / M_PI);
  EXPECT_TRUE((diffuse.eval(2 * unit, 2 * unit) == diffuse.eval(unit, unit)).all());
}

template <class Surface>
void expect_refusal(const Surface& surface) {
  for (double length : {0.5, 1 + 1e-6, 2.0}) {
    const Vec3<double> out = length * unit;
    const Eigen::Matrix<double, Surface::dimensions, 1> u =
        Eigen::Matrix<double, Surface::dimensions, 1>::Constant(0.5);
    EXPECT_THROW(static_cast<void>(surface.sample(out, u)), std::invalid_argument) << length;
    EXPECT_THROW(static_cast<void>(surface.pdf(out, unit)), std::invalid_argument) << length;
  }
}

TEST(Bsdf, RefusesAnOutThatIsNoUnitVectorWhereALawIsBuiltAboutIt) {
  const ConstantReflectance<double> white(colour<double>(1, 1, 1));
  expect_refusal(Glossy<double>(colour<double>(1, 1, 1), 5));
  expect_refusal(RoughConductor<double>({0.5, 0.25}, white));
  expect_refusal(EnergyCompensatedConductor<double>(0.5, white));
  EXPECT_THROW(static_cast<void>(Glossy<double>(colour<double>(1, 1, 1), 5).eval(2 * unit, unit)),
               std::invalid_argument);
}

// `pdf` and `eval` accept an `in` of any length: they evaluate the formula, and do not throw.
TEST(Bsdf, TakesAnyIn) {
  const ConstantReflectance<double> white(colour<double>(1, 1, 1));
  for (double length : {0.5, 2.0}) {
    const Vec3<double> in = length * unit;
    EXPECT_NO_THROW(static_cast<void>(Glossy<double>(colour<double>(1, 1, 1), 5).pdf(unit, in)));
    EXPECT_NO_THROW(static_cast<void>(RoughConductor<double>({0.5, 0.25}, white).pdf(unit, in)));
    EXPECT_NO_THROW(static_cast<void>(RoughConductor<double>({0.5, 0.25}, white).eval(2 * unit, in)));
  }
}

}  // namespace
}  // namespace fairlight
