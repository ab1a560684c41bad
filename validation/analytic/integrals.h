#pragma once

#include <fairlight/estimators/importance.h>
#include <fairlight/estimators/lambertian.h>
#include <fairlight/estimators/pick_one.h>
#include <fairlight/estimators/roulette.h>
#include <fairlight/validation/checks.h>

namespace fairlight {

/// Integrals over the hemisphere, in closed form: with z = cos(theta) and dw = dz dphi, the integral of z^n is
/// 2 pi / (n + 1).

/// Importance sampling of z^power by the law `Directions`; `largest` is the supremum of z^power / p.
template <template <class> class Directions>
Claim hemisphere_integral(const std::string& name, const std::string& subject, int power, double largest) {
  const double mean = 2 * std::numbers::pi / (power + 1);
  const Reference reference{mean, 0, largest * (1 + 1e-12)};
  return {name,
          "mean",
          {"Importance", subject},
          "the integral of cos^" + std::to_string(power) + " over the hemisphere is 2 pi / " +
              std::to_string(power + 1),
          "elementary",
          1,
          [=](const Trial& trial) {
            const auto integrand = [=](const Vec3<double>& w) { return std::pow(w.z(), power); };
            const Importance estimator(Directions<double>{}, integrand);
            return check_mean(trial, {reference}, [&](auto& source) { return estimator.estimate(source); });
          }};
}

/// Roulette with survival probability q leaves the mean of what it is played on as it was.
template <class Roulette>
Claim roulette_integral(const std::string& name, double q) {
  const Reference reference{2 * std::numbers::pi / 3, 0, 1 / q * std::numbers::pi * (1 + 1e-12)};
  return {name,
          "mean",
          {"RussianRoulette", "Rouletted"},
          "the integral of cos^2 over the hemisphere is 2 pi / 3, estimated with probability " + std::to_string(q),
          "elementary; Arvo and Kirk 1990",
          1,
          [=](const Trial& trial) {
            const auto integrand = [](const Vec3<double>& w) { return w.z() * w.z(); };
            const Importance inner(CosineHemisphere<double>{}, integrand);
            const Rouletted<decltype(inner), double, Roulette> estimator(inner, q);
            return check_mean(trial, {reference}, [&](auto& source) { return estimator.estimate(source); });
          }};
}

/// The reflectance of a Lambertian surface: the weight f cos / p of a bounce has the albedo as its mean. With
/// uniform directions the weight is 2 albedo cos(theta), at most twice the albedo.
template <template <class> class Directions>
Claim lambertian_albedo(const std::string& name, const std::string& subject) {
  return {name,
          "mean",
          {"Lambertian", subject},
          "the weight of a bounce has the albedo as its mean",
          "elementary",
          1,
          [](const Trial& trial) {
            constexpr double albedo = 0.75;
            const Lambertian<double, Directions> surface(Rgb<double>::Constant(albedo));
            return check_mean(trial, {Reference{albedo, 0, 2 * albedo * (1 + 1e-12)}},
                              [&](auto& source) { return surface.sample(next_pair<double>(source)).weight[0]; });
          }};
}

/// With cosine-weighted directions every bounce weighs exactly the albedo.
inline Claim lambertian_constant() {
  return {"lambertian.cosine.weight",
          "constant",
          {"Lambertian", "CosineHemisphere"},
          "the weight of every bounce is the albedo, to 4 ulp",
          "f cos / p = albedo",
          1,
          [](const Trial& trial) {
            constexpr double albedo = 0.75;
            const Lambertian<double> surface(Rgb<double>::Constant(albedo));
            return check_constant(trial, albedo, 4, [&](auto& source) {
              return surface.sample(next_pair<double>(source)).weight[0];
            });
          }};
}

/// The paper's two dice (A.1): the sum of a loaded die, face k with probability k/21, and a fair one has the mean
/// 91/21 + 7/2 = 47/6. `Terms` throws both, or one of them and doubles it.
template <class Terms>
Claim two_dice(const std::string& name, std::vector<std::string> subjects) {
  return {name,
          "mean",
          std::move(subjects),
          "two unlike dice sum to 47/6 in the mean",
          "the paper, A.1",
          1,
          [](const Trial& trial) {
            const auto loaded = [](double u) {
              int face = 1;
              for (double below = 1; u * 21 >= below; below += face) ++face;
              return face;
            };
            const auto fair = [](double u) { return 1 + static_cast<int>(6 * u); };
            const auto die = [&](int i, auto& source) -> double {
              const double u = source.next();
              return i == 0 ? loaded(u) : fair(u);
            };
            return check_mean(trial, {Reference{47.0 / 6, 0, 12}},
                              [&](auto& source) { return Terms::template sum<double>(2, source, die); });
          }};
}

}  // namespace fairlight
