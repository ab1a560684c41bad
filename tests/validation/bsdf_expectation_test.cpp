#include <functional>
#include <map>

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>
#include <support/foreign_bsdfs.h>

#include <fairlight/estimators/dielectric.h>
#include <fairlight/estimators/glossy.h>
#include <fairlight/estimators/mixture.h>
#include <fairlight/estimators/rough_conductor.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/testing/bsdf.h>

namespace fairlight {
namespace {

using namespace testing;  // NOLINT: the BSDFs of support/foreign_bsdfs.h

// The adapter of a surface of the kit.
template <class Surface>
struct OfTheKit {
  static constexpr std::size_t dimensions = Surface::dimensions;
  Surface surface;
  std::optional<BsdfSample> sample(const V& out, const std::array<double, dimensions>& u) const {
    const Bounce<double> bounce =
        surface.sample(out, Eigen::Map<const Eigen::Matrix<double, dimensions, 1>>(u.data()));
    if (bounce.density.value() == 0 && (bounce.weight == 0).all()) return {};
    return BsdfSample{bounce.in, bounce.weight, bounce.density.value()};
  }
  Rgb<double> eval(const V& out, const V& in) const { return surface.eval(out, in); }
  double pdf(const V& out, const V& in) const { return surface.pdf(out, in).value(); }
};

TEST(ExpectBsdf, IsMetByRightOnesFromBothSides) {
  EXPECT_BSDF(Diffuse());
  EXPECT_BSDF(Ggx3(), {.margin = 0.1});
  EXPECT_BSDF(Plastic(), {.margin = 0.1});
  EXPECT_BSDF(Silver());
  EXPECT_BSDF(FloatPhong(), {.margin = 0.1});
}

TEST(ExpectBsdf, IsMetByTheSurfacesOfTheKit) {
  const BsdfTerms above{.margin = 0.1, .both_sides = false};
  const Glossy<double> glossy(Rgb<double>(0.9, 0.5, 0.1), 20.5);
  EXPECT_BSDF(OfTheKit<Glossy<double>>{glossy}, above);
  using Metal = RoughConductor<double, SchlickReflectance<double>>;
  const Metal metal(Ggx<double>(0.1, 0.4), SchlickReflectance<double>(Rgb<double>(0.9, 0.5, 0.1)));
  EXPECT_BSDF(OfTheKit<Metal>{metal}, above);
  EXPECT_BSDF(OfTheKit<Dielectric<double>>{Dielectric<double>(1.5)}, {.reciprocal = false});
}

TEST(ExpectBsdf, ComparesTheMeanWeightWithAStatedAlbedo) {
  BsdfTerms terms{.margin = 0.1};
  terms.largest_weight = 1;
  terms.albedo = [](const V&) { return Rgb<double>(0.7, 0.7, 0.7); };
  EXPECT_BSDF(Diffuse(), terms);
  const Site site{"stated", 1, 1, ""};
  terms.albedo = [](const V&) { return Rgb<double>(0.7, 0.7, 0.6); };
  const Diffuse diffuse;
  const Expectation wrong = expect_bsdf(site, under_test(diffuse), terms);
  EXPECT_FALSE(wrong.met);
  EXPECT_NE(wrong.message.find("biased: albedo"), std::string::npos) << wrong.message;
}

template <class Wrong>
void expect_named(const char* check) {
  const Wrong wrong;
  const Expectation expectation = expect_bsdf({typeid(Wrong).name(), 1, 1, ""}, under_test(wrong), {});
  EXPECT_FALSE(expectation.met) << typeid(Wrong).name();
  EXPECT_NE(expectation.message.find(formatted("biased: %s", check)), std::string::npos)
      << typeid(Wrong).name() << "\n"
      << expectation.message;
}

// Each error is named by the check that knows it.
TEST(ExpectBsdf, NamesTheErrorsThatPeopleShip) {
  expect_named<SwappedArguments>("law");
  expect_named<PdfOfTheOtherLobe>("law");
  expect_named<LobeNotSampled>("unsampled light");
  expect_named<JacobianForgotten>("law");
  expect_named<CosineTwice>("weight");
  expect_named<OneSideSampled>("density");
  expect_named<FresnelOfTheWrongSide>("reciprocity");
  expect_named<NormalisedByTwoPercentTooMuch>("energy");
  expect_named<MirrorWithADensity>("single directions");
  expect_named<NanAtGrazing>("finite");
  expect_named<WeightWithoutPdf>("weight");
  expect_named<RoughnessSquaredTwice>("law");
}

TEST(ExpectBsdf, RefusesTermsThatItCannotTest) {
  const Site site{"terms", 1, 1, ""};
  const Diffuse diffuse;
  EXPECT_THROW(expect_bsdf(site, under_test(diffuse), {.margin = 0}), std::invalid_argument);
  EXPECT_THROW(expect_bsdf(site, under_test(diffuse), {.rounding = 0}), std::invalid_argument);
  BsdfTerms unbounded;
  unbounded.albedo = [](const V&) { return Rgb<double>(1, 1, 1); };
  EXPECT_THROW(expect_bsdf(site, under_test(diffuse), unbounded), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight
