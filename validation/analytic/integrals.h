#pragma once

#include <fairlight/estimators/importance.h>
#include <fairlight/estimators/lambertian.h>
#include <fairlight/estimators/pick_one.h>
#include <fairlight/estimators/roulette.h>
#include <fairlight/validation/experiment.h>

namespace fairlight {

/// Integrals over the hemisphere, in closed form: with z = cos(theta) and dw = dz dphi, the integral of z^n is
/// 2 pi / (n + 1).

/// The height of a direction to a power of at least 1.
template <class Real>
Real cosine_power(const Vec3<Real>& w, int power) {
  Real product = w.z();
  for (int i = 1; i < power; ++i) product *= w.z();
  return product;
}

/// Importance sampling of z^power by the law `Directions`; `largest` is the supremum of z^power / p.
template <template <class> class Directions>
auto hemisphere_integral(const std::string& name, const std::string& subject, int power, double largest) {
  const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
    const Importance estimator(Directions<Real>{}, [=](const Vec3<Real>& w) { return cosine_power(w, power); });
    return estimator.estimate(source);
  };
  return Experiment{name,
                    {"Importance", subject},
                    "the integral of cos^" + std::to_string(power) + " over the hemisphere is 2 pi / " +
                        std::to_string(power + 1),
                    "elementary",
                    1,
                    {{2 * std::numbers::pi / (power + 1), 0, largest * (1 + 1e-12)}},
                    draw};
}

/// Roulette with survival probability q leaves the mean of what it is played on as it was.
template <class Roulette>
auto roulette_integral(const std::string& name, double q) {
  const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
    const Importance inner(CosineHemisphere<Real>{}, [](const Vec3<Real>& w) { return cosine_power(w, 2); });
    const Rouletted<decltype(inner), Real, Roulette> estimator(inner, rounded<Real>(q));
    return estimator.estimate(source);
  };
  return Experiment{
      name,
      {"RussianRoulette", "Rouletted"},
      "the integral of cos^2 over the hemisphere is 2 pi / 3, estimated with probability " + std::to_string(q),
      "elementary; Arvo and Kirk 1990",
      1,
      {{2 * std::numbers::pi / 3, 0, 1 / q * std::numbers::pi * (1 + 1e-12)}},
      draw};
}

/// The reflectance of a Lambertian surface: the weight f cos / p of a bounce has the albedo as its mean. With
/// uniform directions the weight is 2 albedo cos(theta), at most twice the albedo.
template <template <class> class Directions>
auto lambertian_albedo(const std::string& name, const std::string& subject) {
  constexpr double albedo = 0.75;
  const auto draw = []<class Real>(std::type_identity<Real>, auto& source) {
    const Lambertian<Real, Directions> surface(Rgb<Real>::Constant(Real(albedo)));
    return Real(surface.sample({Real(0), Real(0), Real(1)}, next_pair<Real>(source)).weight[0]);
  };
  return Experiment{name,
                    {"Lambertian", subject},
                    "the weight of a bounce has the albedo as its mean",
                    "elementary",
                    1,
                    {{albedo, 0, 2 * albedo * (1 + 1e-12)}},
                    draw};
}

/// With cosine-weighted directions every bounce weighs exactly the albedo.
template <class Real>
Claim lambertian_constant() {
  return {.name = "lambertian.cosine.weight" + real_suffix<Real>(),
          .kind = "constant",
          .subjects = {"Lambertian", "CosineHemisphere"},
          .statement = "the weight of every bounce is the albedo, to 4 ulp",
          .source = "f cos / p = albedo",
          .margin_factor = 1,
          .check =
              [](const Trial& trial) {
                constexpr double albedo = 0.75;
                const Lambertian<Real> surface(Rgb<Real>::Constant(Real(albedo)));
                return check_constant<Real>(trial, albedo, 4, [&](auto& source) {
                  return Real(surface.sample({Real(0), Real(0), Real(1)}, next_pair<Real>(source)).weight[0]);
                });
              },
          .real = real_name<Real>()};
}

/// The paper's two dice (A.1): the sum of a loaded die, face k with probability k/21, and a fair one has the mean
/// 91/21 + 7/2 = 47/6. `Terms` throws both, or one of them and doubles it.
template <class Terms>
auto two_dice(const std::string& name, std::vector<std::string> subjects) {
  const auto draw = []<class Real>(std::type_identity<Real>, auto& source) {
    const auto die = [](auto i, auto& numbers) {
      const Real u = numbers.next();
      Real loaded(1);
      for (int below = 1, face = 1; face < 6; below += ++face) {
        loaded += select(u * Real(21) >= rounded<Real>(below), Real(1), Real(0));
      }
      Real fair(1);
      for (int face = 1; face < 6; ++face) {
        fair += select(u * Real(6) >= rounded<Real>(face), Real(1), Real(0));
      }
      return Real(select(same_index<Real>(Index<Real>(i), Index<Real>(0)), loaded, fair));
    };
    return Terms::template sum<Real>(2, source, die);
  };
  return Experiment{name,
                    std::move(subjects),
                    "two unlike dice sum to 47/6 in the mean",
                    "the paper, A.1",
                    1,
                    {{47.0 / 6, 0, 12}},
                    draw};
}

}  // namespace fairlight
