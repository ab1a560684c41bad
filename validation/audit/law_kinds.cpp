#include <cmath>
#include <numbers>

#include <boost/math/distributions/normal.hpp>

#include <fairlight/stats/chi_square.h>
#include <fairlight/stats/follows.h>
#include <fairlight/stats/kolmogorov_smirnov.h>
#include <fairlight/stats/same_law.h>
#include <fairlight/validation/audit/audit_numbers.h>
#include <fairlight/validation/audit/law_kinds.h>

namespace fairlight {
namespace {

Finding counts(const Trial& trial, double bias) {
  const Numbers u(trial);
  const double half = (1 + bias) / 2;  // the share of the lower eight of the sixteen cells
  return test_law(
      trial, DiscreteDomain{16}, [](std::int64_t) { return 1.0 / 16; },
      [&](std::uint64_t i) {
        const double x = u(i);
        const double place = x < half ? x / half / 2 : 0.5 + (x - half) / (1 - half) / 2;
        return static_cast<std::int64_t>(16 * place);
      });
}

Finding two_cells(const Trial& trial, double bias) {
  const Numbers u(trial);
  return test_law(
      trial, DiscreteDomain{2}, [](std::int64_t) { return 0.5; },
      [&](std::uint64_t i) { return std::int64_t{u(i) < (1 + bias) / 2}; });
}

// Draws of the density 1 + b (2s - 1), by inversion, tested against the uniform density. Their L2
// distance is b / sqrt3.
Finding density(const Trial& trial, double bias) {
  const Numbers u(trial);
  const double b = bias * std::numbers::sqrt3;
  return test_law(
      trial, IntervalDomain{0, 1}, [](double) { return 1.0; },
      [&](std::uint64_t i) {
        const double c = 1 - b;
        return 2 * u(i) / (c + std::sqrt(c * c + 4 * b * u(i)));
      });
}

// A single sample of fixed size, large enough to detect u^(1/(1+margin)) at a level of 1e-8.
Finding kolmogorov(const Trial& trial, double bias) {
  const Numbers u(trial);
  const double farthest = trial.margin / std::numbers::e;
  const double reach = std::sqrt(std::log(4 / trial.alpha) / 2) + 2.5;
  std::vector<double> sample(static_cast<std::size_t>(std::pow(reach / farthest, 2)) * 2);
  for (std::size_t i = 0; i < sample.size(); ++i) sample[i] = std::pow(u(i), 1 / (1 + bias));
  const KolmogorovSmirnov result = kolmogorov_smirnov(sample);
  const bool alarm = result.too_far < trial.alpha / 2 || result.too_near < trial.alpha / 2;
  return Finding{alarm ? Verdict::biased : Verdict::certified, Guarantee::asymptotic, trial.margin};
}

// The number of density 1 + a sqrt2 cos(pi t), a the bias, by inversion. Its distance from the
// uniform law is a, all of it in the first cosine moment.
double wave(double u, double bias) {
  const double a = bias * std::numbers::sqrt2;
  double t = u;
  for (int k = 0; k < 30; ++k) t = u - a * std::sin(std::numbers::pi * t) / std::numbers::pi;
  return t;
}

// Draws of the density 2 s (1 + a sqrt2 cos(pi t)). The claim is a = 0.
Finding moments_of_the_law(const Trial& trial, double bias) {
  const Numbers u(trial);
  return test_rosenblatt(
      trial, [](double s, double) { return 2 * s; },
      [&](std::uint64_t i) { return Eigen::Vector2d(std::sqrt(u(i)), wave(u(i, 1), bias)); });
}

// The law of quantile(u), u uniform, tested on draws of quantile(wave(u)).
template <class Domain, class Density, class Quantile>
Finding follows(const Trial& trial, const Domain& domain, const Density& density, const Quantile& quantile,
                double bias) {
  const Numbers u(trial);
  return test_follows(trial, domain, density, [&](std::uint64_t i) { return quantile(wave(u(i), bias)); });
}

// All draws lie in a thousandth of the domain.
Finding narrow(const Trial& trial, double bias) {
  const boost::math::normal law(0, 1e-3);
  return follows(
      trial, IntervalDomain{-6, 6}, [&](double x) { return pdf(law, x); },
      [&](double u) { return quantile(law, u); }, bias);
}

// Steps at the ends of sevenths.
Finding steps(const Trial& trial, double bias) {
  static constexpr double sum = 13.5, heights[] = {1, 3, 0, 2, 4, 1.5, 2};
  const auto density = [](double x) { return heights[std::min(static_cast<int>(7 * x), 6)] * 7 / sum; };
  const auto quantile = [](double u) {
    int k = 0;
    double rest = u * sum;
    for (; k < 6 && rest >= heights[k]; ++k) rest -= heights[k];
    return (k + std::min(rest / heights[k], 1.0)) / 7;
  };
  return follows(trial, IntervalDomain{0, 1}, density, quantile, bias);
}

Finding pole(const Trial& trial, double bias) {
  return follows(
      trial, IntervalDomain{0, 1}, [](double x) { return 0.5 / std::sqrt(x); }, [](double u) { return u * u; },
      bias);
}

Finding unbounded(const Trial& trial, double bias) {
  return follows(
      trial, LineDomain{}, [](double x) { return 1 / (std::numbers::pi * (1 + x * x)); },
      [](double u) { return std::tan(std::numbers::pi * (u - 0.5)); }, bias);
}

// Of an outcome of probability p, the distance is |q - p| / sqrt(p).
Finding rare_outcome(const Trial& trial, double bias) {
  constexpr double p = 1e-4;
  const double q = p + bias * std::sqrt(p);
  const Numbers u(trial);
  return test_law(
      trial, DiscreteDomain{2}, [](std::int64_t i) { return i == 1 ? p : 1 - p; },
      [&](std::uint64_t i) { return std::int64_t{u(i) < q}; });
}

Finding same_law(const Trial& trial, double bias) {
  const Numbers u(trial);
  return test_same_law(
      trial, [&](std::uint64_t i) { return Eigen::Vector2d(wave(u(i), bias), 0.5); },
      [&](std::uint64_t i) { return Eigen::Vector2d(u(i, 1), 0.5); }, true);
}

// Two points, each of which has a cell of its own.
Finding same_discrete_law(const Trial& trial, double bias) {
  const Numbers u(trial);
  const auto coin = [&](std::uint64_t i, std::uint32_t unit, double p) {
    return Eigen::Vector2d(u(i, unit) < p ? 0.25 : 0.75, 0.5);
  };
  // The cells have the probability 1/2, and a margin of sqrt(1/2) times the trial's.
  const double p = 0.5 + bias * std::sqrt(0.5);
  return test_same_law(
      trial, [&](std::uint64_t i) { return coin(i, 0, p); }, [&](std::uint64_t i) { return coin(i, 1, 0.5); },
      true);
}

}  // namespace

const std::vector<TestKind>& law_kinds() {
  static const std::vector<TestKind> kinds{{"counts", false, counts},
                                           {"counts.coin", false, two_cells},
                                           {"counts.rare", true, rare_outcome},
                                           {"law.interval", false, density},
                                           {"kolmogorov_smirnov", false, kolmogorov},
                                           {"rosenblatt", false, moments_of_the_law},
                                           {"follows.narrow", false, narrow},
                                           {"follows.steps", false, steps},
                                           {"follows.pole", false, pole},
                                           {"follows.unbounded", false, unbounded},
                                           {"same_law", false, same_law},
                                           {"same_law.coins", false, same_discrete_law}};
  return kinds;
}

}  // namespace fairlight
