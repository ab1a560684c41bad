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
constexpr int order = 3;

// The nodes of the Gauss rule on the unit interval, and their weights in barycentric interpolation.
// Source: Berrut and Trefethen 2004, "Barycentric Lagrange interpolation".
struct Nodes {
  std::array<double, Rosenblatt::nodes> at{}, weight{};

  Nodes() {
    for (std::size_t j = 0; j < at.size() / 2; ++j) {
      const double half = Rule::abscissa()[j] / 2;
      at[2 * j] = 0.5 - half;
      at[2 * j + 1] = 0.5 + half;
    }
    for (std::size_t j = 0; j < at.size(); ++j) {
      weight[j] = 1;
      for (std::size_t i = 0; i < at.size(); ++i) weight[j] /= i == j ? 1 : at[j] - at[i];
    }
  }

  // The values at x of the Lagrange polynomials of the nodes.
  std::array<double, Rosenblatt::nodes> shares(double x) const {
    std::array<double, Rosenblatt::nodes> share{};
    double sum = 0;
    for (std::size_t j = 0; j < at.size(); ++j) {
      if (x == at[j]) {
        share.fill(0);
        share[j] = 1;
        return share;
      }
      sum += share[j] = weight[j] / (x - at[j]);
    }
    for (double& each : share) each /= sum;
    return share;
  }
};

// Whether the integrals agree to 1e-7 of the whole, a tenth of the allowed quadrature error.
bool agree(const std::array<double, Rosenblatt::pieces>& a, const std::array<double, Rosenblatt::pieces>& b) {
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (!(std::abs(a[k] - b[k]) <= 1e-7 * b.back())) return false;
  }
  return true;
}

const Nodes& slab_nodes() {
  static const Nodes nodes;
  return nodes;
}

constexpr std::size_t moment_count = order + order + order * order;

// All moments of one point: those of s, those of t, and their products.
std::array<double, moment_count> moments_of(const Eigen::Vector2d& place) {
  const auto waves = [](double x) {  // cos(2a), cos(3a) from cos(a) by Chebyshev's polynomials
    const double c = std::cos(std::numbers::pi * x), root = std::numbers::sqrt2;
    return std::array<double, order>{root * c, root * (2 * c * c - 1), root * c * (4 * c * c - 3)};
  };
  const auto across = waves(place.x()), along = waves(place.y());
  std::array<double, moment_count> moments;
  auto next = std::copy(along.begin(), along.end(), std::copy(across.begin(), across.end(), moments.begin()));
  for (double a : across) {
    for (double b : along) *next++ = a * b;
  }
  return moments;
}

}  // namespace

Rosenblatt::Rosenblatt(SquareDensity density) : density_(std::move(density)) {
  constexpr double inside = 1e-9 / knots;
  double sum = 0;
  for (int k = 0; k < knots; ++k) {
    const double low = double(k) / knots;
    const double high = double(k + 1) / knots;
    Slab slab{sum, pieces_at(low + inside).back() / knots, pieces_at(high - inside).back() / knots, 0, {}, false};
    for (std::size_t j = 0; j < nodes; ++j) {
      slab.at_nodes[j] = pieces_at((k + slab_nodes().at[j]) / knots);
      slab.mass += Rule::weights()[j / 2] / 2 * slab.at_nodes[j].back() / knots;
    }
    slab.smooth = k > 0 && k + 1 < knots && agree(interpolated(slab, 0.5), pieces_at((k + 0.5) / knots));
    slabs_.push_back(slab);
    sum += slab.mass;
  }
  if (!(std::abs(sum - 1) <= 1e-6)) {
    throw std::invalid_argument("the density integrates to " + std::to_string(sum) + " (a law to 1)");
  }
}

// The integral of the density at s over [low, high].
double Rosenblatt::integral(double s, double low, double high) const {
  return Rule::integrate([&](double t) { return checked_density(density_(s, t), s, t); }, low, high);
}

Rosenblatt::Pieces Rosenblatt::pieces_at(double s) const {
  Pieces sums{};
  double sum = 0;
  for (std::size_t k = 0; k < pieces; ++k) {
    sums[k] = sum += integral(s, double(k) / pieces, double(k + 1) / pieces);
  }
  return sums;
}

// The integrals interpolated between the nodes; x is the position in the slab, in [0,1].
Rosenblatt::Pieces Rosenblatt::interpolated(const Slab& slab, double x) {
  const auto shares = slab_nodes().shares(x);
  Pieces sums{};
  for (std::size_t j = 0; j < nodes; ++j) {
    for (std::size_t k = 0; k < pieces; ++k) sums[k] += shares[j] * slab.at_nodes[j][k];
  }
  return sums;
}

// Within a slab, u is the Hermite cubic that has its mass, and its marginal at both ends.
Eigen::Vector2d Rosenblatt::operator()(double s, double t) const {
  if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1))
    throw std::out_of_range("a place outside the unit square (check its coordinates first)");
  const int knot = std::min(static_cast<int>(s * knots), knots - 1);
  const Slab& slab = slabs_[static_cast<std::size_t>(knot)];
  const double x = s * knots - knot;
  const double u = slab.before + slab.mass * x * x * (3 - 2 * x) + slab.first * x * (1 - x) * (1 - x) -
                   slab.last * x * x * (1 - x);
  const Pieces sums = slab.smooth ? interpolated(slab, x) : pieces_at(s);
  const auto piece = std::min(static_cast<std::size_t>(t * pieces), pieces - 1);
  const double low = double(piece) / pieces;
  const double part = (piece > 0 ? sums[piece - 1] : 0) + (t > low ? integral(s, low, t) : 0);
  return {u, part / sums.back()};
}

Finding test_rosenblatt(const Trial& trial, const SquareDensity& density,
                        const std::function<Eigen::Vector2d(std::uint64_t)>& draw, std::uint32_t replicate) {
  if (replicate == 0) throw std::invalid_argument("a replicate must have a draw (give 1 for independent ones)");
  std::optional<Rosenblatt> transform;
  try {
    transform.emplace(density);
  } catch (const std::logic_error& bad) {  // the density is negative, or does not integrate to 1
    return detail::refuted_density(trial, bad.what());
  }
  // No moment exceeds 2 in size. The quadrature and the cubic may each bias the transform by 1e-6;
  // an error of that size moves the third cosine by 3 pi sqrt2 times as much.
  const Reference wave{.mean = 0, .lower = -2.00001, .upper = 2.00001, .scale = 1, .rounding = 1.4e-5};
  const std::vector<Reference> references(moment_count, wave);
  std::optional<std::uint64_t> bad;  // a number of draws; the test counts replicates
  const auto add = [&](std::uint64_t i, std::array<double, moment_count>& sums) {
    const Eigen::Vector2d place = draw(i);
    bad = i;
    check_place(i, place);
    bad.reset();
    const auto moments = moments_of((*transform)(place.x(), place.y()));
    for (std::size_t c = 0; c < moment_count; ++c) sums[c] += moments[c];
  };
  Finding finding =
      test_means(trial, references, [&](std::uint64_t first, std::vector<std::vector<double>>& channels) {
        for (std::size_t i = 0; i < channels[0].size(); ++i) {
          std::array<double, moment_count> sums{};
          for (std::uint64_t k = 0; k < replicate; ++k) add((first + i) * replicate + k, sums);
          for (std::size_t c = 0; c < moment_count; ++c) channels[c][i] = sums[c] / replicate;
        }
      });
  finding.draws = bad ? *bad + 1 : finding.draws * replicate;
  return finding;
}

}  // namespace fairlight
