#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>

#include <boost/math/quadrature/gauss.hpp>

#include <fairlight/stats/law_test.h>
#include <fairlight/stats/rosenblatt.h>

namespace fairlight {
namespace {

using Rule = boost::math::quadrature::gauss<double, 8>;
constexpr int knots = 256;
constexpr int pieces = 6;  // of the unit interval in t
constexpr int order = 3;

// All moments of one place, in the order of test_rosenblatt's channels.
void moments_of(const Eigen::Vector2d& place, std::size_t i, std::vector<std::vector<double>>& channels) {
  std::array<double, order> across{};
  std::array<double, order> along{};
  for (int j = 0; j < order; ++j) {
    across[static_cast<std::size_t>(j)] = std::numbers::sqrt2 * std::cos((j + 1) * std::numbers::pi * place.x());
    along[static_cast<std::size_t>(j)] = std::numbers::sqrt2 * std::cos((j + 1) * std::numbers::pi * place.y());
  }
  std::size_t channel = 0;
  for (double a : across) channels[channel++][i] = a;
  for (double b : along) channels[channel++][i] = b;
  for (double a : across) {
    for (double b : along) channels[channel++][i] = a * b;
  }
}

}  // namespace

Rosenblatt::Rosenblatt(SquareDensity density) : density_(std::move(density)) {
  constexpr double inside = 1e-9 / knots;
  double sum = 0;
  for (int k = 0; k < knots; ++k) {
    const double low = double(k) / knots;
    const double high = double(k + 1) / knots;
    const double mass = Rule::integrate([&](double s) { return marginal(s); }, low, high);
    slabs_.push_back({sum, marginal(low + inside) / knots, marginal(high - inside) / knots, mass});
    sum += mass;
  }
  if (!(std::abs(sum - 1) <= 1e-6)) {
    throw std::invalid_argument("the density integrates to " + std::to_string(sum) + " (a law to 1)");
  }
}

Rosenblatt::Strip Rosenblatt::strip(double s, double t) const {
  const auto f = [&](double y) { return checked_density(density_(s, y), s, y); };
  Strip strip{0, 0};
  for (int k = 0; k < pieces; ++k) {
    const double low = double(k) / pieces;
    const double high = double(k + 1) / pieces;
    const double piece = Rule::integrate(f, low, high);
    strip.whole += piece;
    strip.part += t >= high ? piece : t > low ? Rule::integrate(f, low, t) : 0;
  }
  return strip;
}

double Rosenblatt::marginal(double s) const { return strip(s, 0).whole; }

// In a slab, the cubic that has its mass and, at its ends, its marginal (Hermite).
Eigen::Vector2d Rosenblatt::operator()(double s, double t) const {
  const int knot = std::min(static_cast<int>(s * knots), knots - 1);
  const Slab& slab = slabs_[static_cast<std::size_t>(knot)];
  const double x = s * knots - knot;
  const double u = slab.before + slab.mass * x * x * (3 - 2 * x) + slab.first * x * (1 - x) * (1 - x) -
                   slab.last * x * x * (1 - x);
  const Strip across = strip(s, t);
  return {u, across.part / across.whole};
}

Finding test_rosenblatt(const Trial& trial, const SquareDensity& density,
                        const std::function<Eigen::Vector2d(std::uint64_t)>& draw) {
  constexpr std::size_t waves = order + order + order * order;
  std::optional<Rosenblatt> transform;
  try {
    transform.emplace(density);
  } catch (const std::logic_error& bad) {  // negative, or not integrating to one
    return detail::refuted_density(trial, bad.what());
  }
  // The largest of the waves is 2. The quadrature's 1e-6, and the cubic's, may bias them: a transform that is off by that moves
  // the third wave by 3 pi sqrt2 times as much.
  const Reference wave{.mean = 0, .lower = -2.00001, .upper = 2.00001, .scale = 1, .rounding = 1.4e-5};
  const std::vector<Reference> references(waves, wave);
  return test_means(trial, references, [&](std::uint64_t first, std::vector<std::vector<double>>& channels) {
    for (std::size_t i = 0; i < channels[0].size(); ++i) {
      const Eigen::Vector2d place = draw(first + i);
      check_place(first + i, place);
      moments_of((*transform)(place.x(), place.y()), i, channels);
    }
  });
}

}  // namespace fairlight
