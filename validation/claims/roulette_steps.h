#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fairlight/estimators/roulette.h>
#include <fairlight/validation/checks/parameters.h>

namespace fairlight {

/// One step of a path's roulette: a path of this throughput and depth, at a surface of this albedo,
/// keeps throughput x albedo in the mean, per channel.
struct RouletteStep {
  Rgb<double> albedo, throughput;
  int depth = 0;
};

/// The albedos are dark, of any brightness and nearly white, in turn from red, green and blue on; the
/// throughput is from a thousandth to 4, as uniform directions make it.
inline std::vector<ParameterRange> roulette_step_ranges(const std::string& component) {
  std::vector<ParameterRange> ranges;
  for (int step = 0; step < 3; ++step) {
    const std::array<std::array<double, 2>, 3> albedos{{{0, 0.3}, {0.3, 0.97}, {0.97, 1}}};
    for (int c = 0; c < 3; ++c) {
      const auto& [low, high] = albedos[static_cast<std::size_t>((c + step) % 3)];
      ranges.push_back({component, "albedo", low, high});
    }
    for (int c = 0; c < 3; ++c) {
      const double low = step == 0 ? 1e-3 : step == 1 ? 0.1 : 1, high = step == 0 ? 0.1 : step == 1 ? 1 : 4;
      ranges.push_back({component, "throughput", low, high, ParameterRange::Law::logarithmic});
    }
    ranges.push_back({component, "depth", 0, 8});
  }
  return ranges;
}

/// Three steps, three channels of each. A draw is the throughput that a step leaves; it is at most the
/// mean over `smallest(step)`, the least survival probability, whose root divides the scale.
template <class Roulette, class Smallest>
auto roulette_steps(const std::string& name, const std::string& subject, const std::vector<double>& values,
                    const Roulette& roulette, const Smallest& smallest) {
  DrawnValues next(values);
  std::array<RouletteStep, 3> steps;
  std::vector<Reference> references;
  for (RouletteStep& step : steps) {
    step.albedo = next.next_vector().array();
    step.throughput = next.next_vector().array();
    step.depth = static_cast<int>(next.next());
    for (int c = 0; c < 3; ++c) {
      const double mean = step.albedo[c] * step.throughput[c];
      const double scale = (step.albedo * step.throughput).maxCoeff() / std::sqrt(smallest(step));
      references.push_back(
          {.mean = mean, .lower = 0, .upper = mean / smallest(step) * (1 + 1e-12), .scale = scale});
    }
  }
  const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
    Eigen::Array<Real, 9, 1> kept;
    for (int i = 0; i < 3; ++i) {
      const RouletteStep& step = steps[static_cast<std::size_t>(i)];
      const auto colour = [](const Rgb<double>& x) {
        return Rgb<Real>(rounded<Real>(x[0]), rounded<Real>(x[1]), rounded<Real>(x[2]));
      };
      const auto [alive, weight] = roulette.template play<Real>(colour(step.albedo), colour(step.throughput),
                                                                rounded<Real>(step.depth), source);
      const Rgb<Real> after = colour(step.albedo) * colour(step.throughput) * weight;
      for (int c = 0; c < 3; ++c) kept[3 * i + c] = select(alive, after[c], Real(0));
    }
    return kept;
  };
  return estimand(name, {subject}, "a step of roulette keeps the throughput in the mean, per channel",
                  "elementary; Arvo and Kirk 1990", references, draw, 4);
}

template <class Roulette>
auto steps_by_reflectance(const std::vector<double>& values) {
  return roulette_steps("roulette.step.reflectance", "RouletteByReflectance", values, Roulette(),
                        [](const RouletteStep& step) { return step.albedo.maxCoeff(); });
}
template <class Roulette>
auto steps_by_throughput(const std::vector<double>& values) {
  return roulette_steps(
      "roulette.step.throughput", "RouletteByThroughput", values, Roulette(),
      [](const RouletteStep& step) { return std::min(1.0, (step.albedo * step.throughput).maxCoeff()); });
}
/// From the fourth bounce on.
template <class Roulette>
auto steps_from_fourth_bounce(const std::vector<double>& values) {
  return roulette_steps("roulette.step.later", "RouletteFromBounce", values, RouletteFromBounce<Roulette>(4),
                        [](const RouletteStep& step) { return step.depth < 3 ? 1 : step.albedo.maxCoeff(); });
}

}  // namespace fairlight
