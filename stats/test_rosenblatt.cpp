#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include <fairlight/stats/law_test.h>
#include <fairlight/stats/rosenblatt.h>

namespace fairlight {
namespace {

constexpr std::size_t order = 3;

// sqrt2 cos(j pi x), j = 1, 2, 3, by Chebyshev's polynomials.
std::array<double, order> waves(double x) {
  const double c = std::cos(std::numbers::pi * x), root = std::numbers::sqrt2;
  return {root * c, root * (2 * c * c - 1), root * c * (4 * c * c - 3)};
}

}  // namespace

std::vector<double> cosine_moments(const Eigen::Vector2d& place, bool line) {
  const auto across = waves(place.x());
  std::vector<double> moments(across.begin(), across.end());
  if (line) return moments;
  const auto along = waves(place.y());
  moments.insert(moments.end(), along.begin(), along.end());
  for (double a : across) {
    for (double b : along) moments.push_back(a * b);
  }
  return moments;
}

Finding test_rosenblatt(const Trial& trial, const SquareDensity& density,
                        const std::function<std::optional<Eigen::Vector2d>(std::uint64_t)>& draw,
                        std::uint32_t replicate, const Landmarks& landmarks) {
  if (replicate == 0) throw std::invalid_argument("a replicate must have a draw (give 1 for independent ones)");
  std::optional<Rosenblatt> transform;
  try {
    transform.emplace(density, landmarks);
  } catch (const CannotIntegrate& hard) {
    return detail::guarded(trial, [&]() -> Finding { throw hard; });
  } catch (const std::logic_error& bad) {  // the density is negative, or does not integrate to 1
    return detail::refuted_density(trial, bad.what());
  }
  // No moment exceeds 2 in size. The quadrature and the cubic may each bias the transform by 1e-6;
  // an error of that size moves the third cosine by 3 pi sqrt2 times as much.
  const Reference wave{.mean = 0, .lower = -2.00001, .upper = 2.00001, .scale = 1, .rounding = 1.4e-5};
  const std::vector<Reference> references(landmarks.line ? order : order * (order + 2), wave);
  std::optional<std::uint64_t> bad;  // a number of draws; the test counts replicates
  const auto add = [&](std::uint64_t i, std::vector<double>& sums) {
    const auto place = draw(i);
    if (!place) return;
    bad = i;
    check_place(i, *place);
    bad.reset();
    const auto moments = cosine_moments((*transform)(place->x(), place->y()), landmarks.line);
    for (std::size_t c = 0; c < sums.size(); ++c) sums[c] += moments[c];
  };
  Finding finding =
      test_means(trial, references, [&](std::uint64_t first, std::vector<std::vector<double>>& channels) {
        for (std::size_t i = 0; i < channels[0].size(); ++i) {
          std::vector<double> sums(channels.size());
          for (std::uint64_t k = 0; k < replicate; ++k) add((first + i) * replicate + k, sums);
          for (std::size_t c = 0; c < sums.size(); ++c) channels[c][i] = sums[c] / replicate;
        }
      });
  finding.draws = bad ? *bad + 1 : finding.draws * replicate;
  return finding;
}

}  // namespace fairlight
