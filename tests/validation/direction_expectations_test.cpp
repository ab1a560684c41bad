#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <fairlight/stats/text.h>
#include <fairlight/validation/testing/directions.h>

namespace fairlight {
namespace {

using V = Vec3<double>;
using U2 = std::array<double, 2>;
constexpr double pi_ = std::numbers::pi;

V polar(const V& axis, double z, double turn) {
  const double r = std::sqrt(std::max(0.0, 1 - z * z));
  return Frame<double>(axis).to_world(V(r * std::cos(2 * pi_ * turn), r * std::sin(2 * pi_ * turn), z));
}

/// Cosine-weighted directions. The wrong one forgets the square root.
struct Cosine {
  static constexpr std::size_t dimensions = 2;
  bool root = true;
  double pdf(const V& w) const { return std::max(0.0, w.z()) / pi_; }
  std::optional<DirectionSample> sample(const U2& u) const {
    const V w = polar(V(0, 0, 1), root ? std::sqrt(1 - u[0]) : 1 - u[0], u[1]);
    return DirectionSample{w, pdf(w)};
  }
};

/// Henyey and Greenstein's phase function; `out` and `in` point away from the particle. The wrong one
/// samples about `out`, as if directions pointed the way that light travels.
struct HenyeyGreenstein {
  static constexpr std::size_t dimensions = 2;
  double g = 0.6;
  double sign = -1;
  double pdf(const V& out, const V& in) const {
    const double cosine = -out.dot(in);
    return (1 - g * g) / (4 * pi_ * std::pow(1 + g * g - 2 * g * cosine, 1.5));
  }
  std::optional<DirectionSample> sample(const V& out, const U2& u) const {
    const double t = (1 - g * g) / (1 - g + 2 * g * u[0]);
    const V in = polar(sign * out, (1 + g * g - t * t) / (2 * g), u[1]);
    return DirectionSample{in, pdf(out, in)};
  }
};

/// A sphere light by the cone of its directions, at the origin, of radius 1. The wrong ones: the
/// distance to the centre; the density of a cone with a squared sine for 1 - cos.
struct SphereByACone {
  static constexpr std::size_t dimensions = 2;
  bool to_the_centre = false;
  bool small_angle = false;
  double drop(const V& from) const {
    const double sin2 = 1 / from.squaredNorm();
    return small_angle ? sin2 / 2 : 1 - std::sqrt(1 - sin2);
  }
  double hit(const V& from, const V& w) const {
    const double b = from.dot(w), root = b * b - from.squaredNorm() + 1;
    return root < 0 || b > 0 ? 0 : -b - std::sqrt(root);
  }
  double pdf(const V& from, const V& w) const { return hit(from, w) > 0 ? 1 / (2 * pi_ * drop(from)) : 0; }
  std::optional<LightSampleUnderTest> sample(const V& from, const U2& u) const {
    const double sin2 = 1 / from.squaredNorm(), whole = 1 - std::sqrt(1 - sin2);
    const V w = polar(-from.normalized(), 1 - u[0] * whole, u[1]);
    return LightSampleUnderTest{w, to_the_centre ? from.norm() : hit(from, w), pdf(from, w)};
  }
};

void expect_named(const Expectation& expectation, const char* check) {
  EXPECT_FALSE(expectation.met);
  EXPECT_NE(expectation.message.find(formatted("biased: %s", check)), std::string::npos) << expectation.message;
}

TEST(ExpectDirectionSampler, KnowsRightFromWrong) {
  EXPECT_DIRECTION_SAMPLER(Cosine());
  const Cosine wrong{false};
  expect_named(expect_directions({"cosine", 1, 1, ""}, directions_of(wrong)), "law");
}

TEST(ExpectPhaseFunction, KnowsRightFromWrong) {
  EXPECT_PHASE_FUNCTION(HenyeyGreenstein(), {.margin = 0.1});
  EXPECT_PHASE_FUNCTION((HenyeyGreenstein{-0.3}), {.margin = 0.1});
  const HenyeyGreenstein wrong{0.6, 1};
  expect_named(expect_phase_function({"phase", 1, 1, ""}, phase_function_of(wrong)), "law");
}

// From near, from afar and from very far, where the cone is 1e-3 wide.
TEST(ExpectLight, IsMetByARightOne) {
  for (const double distance : {1.1, 3.0, 1000.0})
    EXPECT_LIGHT(SphereByACone(), V(0.6 * distance, 0, 0.8 * distance), {.margin = 0.1});
}

TEST(ExpectLight, NamesWhatIsWrong) {
  const V from(0, 1.2, 0.9);
  const SphereByACone centre{true, false}, narrow{false, true};
  expect_named(expect_light({"centre", 1, 1, ""}, directions_to(centre, from), distances_to(centre, from)),
               "distance");
  expect_named(expect_light({"narrow", 1, 1, ""}, directions_to(narrow, from), distances_to(narrow, from)), "law");
}

TEST(ExpectDirectionSampler, WantsEveryDrawToHaveADirection) {
  struct Halved : Cosine {
    std::optional<DirectionSample> sample(const U2& u) const {
      if (u[1] < 0.5) return {};
      return Cosine::sample({u[0], 2 * u[1] - 1});
    }
  };
  const Halved lossy;
  expect_named(expect_directions({"lossy", 1, 1, ""}, directions_of(lossy)), "no sample lost");
  expect_named(expect_directions({"lossy", 1, 1, ""}, directions_of(lossy), {.whole = false}), "law");
}

}  // namespace
}  // namespace fairlight
