#include <numeric>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/estimators/latin_hypercube.h>
#include <fairlight/estimators/pixel_draws.h>
#include <fairlight/estimators/sobol.h>
#include <fairlight/estimators/stratified.h>

namespace fairlight {
namespace {

// A draw that identifies its pixel and its sample.
const auto place = [](std::size_t pixel, auto& source) {
  using Real = decltype(source.next());
  return Real(source.next() + rounded<Real>(static_cast<double>(pixel)));
};

template <class Real>
auto stream_draws(std::uint32_t first_unit) {
  return PixelDraws<Real, decltype(place)>(StreamKey(1, "test"), first_unit, place);
}

template <class Set>
auto set_draws(std::uint32_t first_replicate, std::uint32_t samples) {
  return PixelPointSets<Set, decltype(place)>(StreamKey(1, "test"), first_replicate, samples, place);
}

TEST(PixelDraws, AreTheStreamsOfPixelAndSample) {
  PhiloxStream<double> sixth(StreamKey(1, "test"), 13, 6);
  const auto draws = stream_draws<double>(10);
  EXPECT_EQ(draws(3, 5, 2)[1], 3 + sixth.next());
  EXPECT_EQ(draws(3, 5, 2), draws(3, 5, 2));
  EXPECT_NE(draws(3, 5, 1), draws(3, 6, 1));
}

TEST(PixelDraws, OfPacketsAreAFunctionOfPixelAndSampleAlone) {
  const auto draws = stream_draws<Packet>(10);
  const std::vector<double> all = draws(3, 0, 50);
  ASSERT_EQ(all.size(), 50u);
  const std::vector<double> part = draws(3, 7, 21);
  EXPECT_EQ(part, std::vector<double>(all.begin() + 7, all.begin() + 28));
}

TEST(PixelDraws, AreAsManyAsAreAskedFor) {
  EXPECT_TRUE(stream_draws<double>(0)(2, 3, 0).empty());
  EXPECT_TRUE(stream_draws<Packet>(0)(2, 3, 0).empty());
  EXPECT_TRUE(set_draws<OwenSobol<double>>(0, 10)(2, 3, 0).empty());
}

// A stage of n samples of a pixel has one in each n-th of the unit interval, for any n and any
// earlier stages.
template <class Set>
void expect_a_set_for_every_stage() {
  RC_ASSERT(rc::check([] {
    const auto pixel = *rc::gen::inRange<std::size_t>(0, 10);
    const auto first = *rc::gen::inRange<std::uint64_t>(0, 50);
    const auto n = std::uint64_t{1} << *rc::gen::inRange(0, 6);
    std::vector<int> hits(n, 0);
    for (double x : set_draws<Set>(5, 100)(pixel, first, n)) {
      ++hits.at(static_cast<std::size_t>((x - static_cast<double>(pixel)) * static_cast<double>(n)));
    }
    RC_ASSERT(hits == std::vector<int>(n, 1));
  }));
}

TEST(PixelPointSets, HaveASetForEveryStage) {
  expect_a_set_for_every_stage<OwenSobol<double>>();
  expect_a_set_for_every_stage<LatinHypercube<double>>();
}

TEST(PixelPointSets, HaveAReplicateForEveryPixelAndFirstSample) {
  const OwenSobol<double> set(StreamKey(1, "test"), 5 + 3 * 100 + 7, 4);
  auto source = set.source(2);
  EXPECT_EQ((set_draws<OwenSobol<double>>(5, 100)(3, 7, 4)[2]), 3 + source.next());
}

TEST(PixelPointSets, RefuseTheNumbersOfAnotherPixel) {
  const auto draws = set_draws<Stratified<double>>(0, 10);
  EXPECT_NO_THROW(draws(2, 6, 4));
  EXPECT_THROW(draws(2, 7, 4), std::length_error);
  EXPECT_THROW(draws(2, ~std::uint64_t{0}, 4), std::length_error) << "the sum of both is small again";
}

// Units and replicates have 32 bits; beyond, they would repeat the first ones.
TEST(PixelDraws, RefuseAPixelWithoutAUnitOfItsOwn) {
  const auto draws = stream_draws<double>(0xFFFFFFFEu);
  EXPECT_NO_THROW(draws(1, 0, 1));
  EXPECT_THROW(draws(2, 0, 1), std::length_error);
  EXPECT_THROW(stream_draws<double>(0)(std::size_t{1} << 32, 0, 1), std::length_error);
}

TEST(PixelPointSets, RefuseAPixelWithoutAReplicateOfItsOwn) {
  const auto draws = set_draws<Stratified<double>>(0, 1u << 31);
  EXPECT_NO_THROW(draws(1, (1u << 31) - 4, 4));
  EXPECT_THROW(draws(2, 0, 4), std::length_error) << "2 x 2^31";
  EXPECT_THROW(set_draws<Stratified<double>>(0xFFFFFFFFu, 1)(1, 0, 1), std::length_error);
  EXPECT_THROW(set_draws<Stratified<double>>(0, 1)(std::size_t{1} << 32, 0, 1), std::length_error);
}

}  // namespace
}  // namespace fairlight
