#include <set>
#include <tuple>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/render/tile_jobs.h>

namespace fairlight {
namespace {

// A tile of 3 x 2 pixels of an image that is 10 wide, samples 5, 6 and 7 of each.
const Tile tile{4, 1, 7, 3};
constexpr std::uint32_t first_sample = 5, samples = 3;

// A ray that says where it is from: the middle of its pixel, and its sample.
template <class Real>
Ray<Real> telling_ray(const Vec2<Real>& middle, const Job<Real>& job) {
  Real sample;
  if constexpr (lanes<Real> == 1) {
    sample = job.sample;
  } else {
    sample = xsimd::to_float(xsimd::bitwise_cast<Index<Real>>(job.sample));
  }
  return {Vec3<Real>(middle.x(), middle.y(), sample), Vec3<Real>(Real(1), Real(2), Real(3)), Real(-1)};
}

template <class Real>
class Given {
 public:
  std::uint32_t to(std::uint32_t idle) {
    const std::uint32_t given = jobs_.give(idle, telling_ray<Real>, ray_, job_);
    const auto numbers = detail::stored<Real, std::uint32_t>(job_.number);
    const auto pixels = detail::stored<Real, std::uint32_t>(job_.pixel);
    const auto drawn = detail::stored<Real, std::uint32_t>(job_.sample);
    std::array<std::array<double, lanes<Real>>, 3> origin{};
    for (int i = 0; i < 3; ++i) store_lanes(ray_.origin[i], origin[static_cast<std::size_t>(i)].data());
    for (std::size_t lane = 0; lane < lanes<Real>; ++lane) {
      if ((given >> lane & 1) == 0) continue;
      EXPECT_EQ(numbers[lane], all_.size()) << "in order, the lowest lane first";
      const double x = origin[0][lane] - 0.5, y = origin[1][lane] - 0.5;
      EXPECT_EQ(pixels[lane], 10 * y + x);
      EXPECT_EQ(drawn[lane], origin[2][lane]);
      EXPECT_TRUE(x >= tile.left && x < tile.right && y >= tile.top && y < tile.bottom);
      EXPECT_TRUE(all_.emplace(pixels[lane], drawn[lane]).second) << "once";
      EXPECT_TRUE(drawn[lane] >= first_sample && drawn[lane] < first_sample + samples);
    }
    return given;
  }
  std::size_t count() const { return all_.size(); }

 private:
  TileJobs<Real> jobs_{tile, first_sample, samples, 10};
  Ray<Real> ray_{zero<Vec3<Real>>(), zero<Vec3<Real>>(), Real(-1)};
  Job<Real> job_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> all_;
};

// Whatever lanes ask, each sample of each pixel is given once, and then none.
template <class Real>
void expect_each_once() {
  constexpr auto everyone = static_cast<std::uint32_t>((std::uint64_t{1} << lanes<Real>)-1);
  Given<Real> given;
  for (int round = 0; round < 1000 && given.count() < 18; ++round) {
    const auto idle = *rc::gen::inRange<std::uint32_t>(1, everyone + 1);
    RC_ASSERT((given.to(idle) & ~idle) == 0u);
  }
  RC_ASSERT(given.count() == 18u);
  RC_ASSERT(given.to(everyone) == 0u);
}

RC_GTEST_PROP(TileJobs, AreEachGivenOnce, ()) {
  expect_each_once<double>();
  expect_each_once<Packet>();
}

TEST(TileJobs, RefuseMoreThanTheirNumbersHold) {
  EXPECT_NO_THROW((TileJobs<double>(tile, 0xFFFFFFFDu, 3, 10)));
  EXPECT_THROW((TileJobs<double>(tile, 0xFFFFFFFEu, 3, 10)), std::length_error) << "sample 2^32";
  EXPECT_THROW((TileJobs<double>(tile, 0, 1u << 31, 10)), std::length_error) << "6 x 2^31 jobs";
}

TEST(TileJobs, KeepWhatTheOtherLanesHave) {
  TileJobs<Packet> jobs(tile, first_sample, samples, 10);
  Ray<Packet> ray{Vec3<Packet>::Constant(Packet(-7)), Vec3<Packet>::Constant(Packet(-7)), Packet(-1)};
  Job<Packet> job;
  EXPECT_EQ(jobs.give(0b0100, telling_ray<Packet>, ray, job), 0b0100u);
  std::array<double, lanes<Packet>> x{}, z{};
  store_lanes(ray.origin.x(), x.data());
  store_lanes(ray.direction.z(), z.data());
  for (std::size_t lane = 0; lane < lanes<Packet>; ++lane) {
    EXPECT_EQ(x[lane], lane == 2 ? 4.5 : -7);
    EXPECT_EQ(z[lane], lane == 2 ? 3 : -7);
  }
}

}  // namespace
}  // namespace fairlight
